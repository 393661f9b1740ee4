//! What a statement is about: of two statements about the same thing the later definition's holds.

use super::error_name::ErrorName;
use crate::syntax::tree::{
    Body, BranchStatement, Broken, ControllerStatement, MachineStatement, Name, Span, Stated, ToleranceKind, Trivia,
};
use mach_runtime::dialect::names;

/// A statement of a definition that can be like another one.
pub(crate) trait Statement: Clone {
    /// What it is about. Two statements of one body about the same thing are a mistake.
    fn subjects(&self) -> Vec<String>;

    /// The statement, which stands at `span`, taken apart so that each part can be replaced on its own.
    fn parts(&self, span: &Span) -> Vec<(Span, Self)> {
        vec![(span.clone(), self.clone())]
    }

    /// What stands inside of its block and was not understood, as statements of the body that it stands in itself.
    fn broken(&self) -> Vec<Broken> {
        Vec::new()
    }

    /// Whether what was not understood may be about a subject.
    fn may_be_about(broken: &Broken, subject: &str) -> bool {
        let (kind, name) = subject.split_once(' ').unwrap_or((subject, ""));
        broken.may_be(&Self::keywords(kind)) && (name.is_empty() || broken.may_speak_of(name))
    }

    /// The keywords of the statements about a kind of subjects.
    fn keywords(kind: &str) -> Vec<&str> {
        vec![kind]
    }

    /// Whether it is merged with the family's statement about the same thing instead of replacing it.
    fn adds_to_family(&self) -> bool {
        false
    }
}

/// The keywords of the statements that declare an axis.
pub(crate) const AXIS: [&str; 2] = ["linear", "rotary"];

impl Statement for MachineStatement {
    fn subjects(&self) -> Vec<String> {
        let subject = match self {
            Self::Let { name, .. } => format!("let {}", name.value),
            Self::Chain(_) => "chain".to_owned(),
            Self::Dh(_) => "dh".to_owned(),
            Self::Error { name, .. } | Self::ErrorTable { name, .. } => error_subject(name),
            Self::Linear { name, .. } | Self::Rotary { name, .. } => format!("axis {}", name.value),
            Self::Tool { .. } => "tool".to_owned(),
            Self::Zero(_) => "zero".to_owned(),
            Self::Tolerance { kind, .. } => match kind.value {
                ToleranceKind::Axis => "tolerance axis".to_owned(),
                ToleranceKind::Chord => "tolerance chord".to_owned(),
                ToleranceKind::Plane => "tolerance plane".to_owned(),
            },
            Self::Records(_) => "records".to_owned(),
            Self::Branch(body) => return body.statements.iter().map(|stated| branch_subject(&stated.node)).collect(),
            Self::Controller { .. } => "controller".to_owned(),
        };
        vec![subject]
    }

    /// A branch block says several things.
    fn parts(&self, span: &Span) -> Vec<(Span, Self)> {
        match self {
            Self::Branch(body) => {
                let alone = |stated: &Stated<BranchStatement>| Body {
                    statements: vec![Stated { trivia: Trivia::default(), ..stated.clone() }],
                    broken: Vec::new(),
                    trailing: Vec::new(),
                };
                body.statements.iter().map(|stated| (stated.span.clone(), Self::Branch(alone(stated)))).collect()
            }
            _ => vec![(span.clone(), self.clone())],
        }
    }

    /// What is broken in a branch block is about any of its words.
    fn broken(&self) -> Vec<Broken> {
        let Self::Branch(body) = self else { return Vec::new() };
        let in_machine = |broken: &Broken| Broken {
            names: broken.names.clone().zip(broken.keywords.clone()).map(|words| [words.0, words.1].concat()),
            keywords: Some(vec!["branch".to_owned()]),
            span: broken.span.clone(),
        };
        body.broken.iter().map(in_machine).collect()
    }

    fn keywords(kind: &str) -> Vec<&str> {
        if kind == "axis" { AXIS.to_vec() } else { vec![kind] }
    }

    /// What a machine changes of its controller comes on top of what its family changes.
    fn adds_to_family(&self) -> bool {
        matches!(self, Self::Controller { .. })
    }
}

/// However its zero is written.
fn error_subject(name: &Name) -> String {
    let canonical = ErrorName::read(&name.value).map(|name| name.canonical());
    format!("error {}", canonical.as_ref().unwrap_or(&name.value))
}

fn branch_subject(statement: &BranchStatement) -> String {
    match statement {
        BranchStatement::Start(_) => "branch start".to_owned(),
        BranchStatement::Then(_) => "branch then".to_owned(),
        BranchStatement::Reposition(_) => "branch reposition".to_owned(),
        BranchStatement::Lock { axis, .. } | BranchStatement::Prefer { axis, .. } | BranchStatement::Free(axis) => {
            format!("branch {}", axis.value)
        }
    }
}

impl Statement for ControllerStatement {
    /// What is broken in a block is about what the block is about.
    fn broken(&self) -> Vec<Broken> {
        let (keyword, name, broken) = match self {
            Self::On { event, body } => ("on", event.value.name(), &body.broken),
            Self::Group { name, body } => ("group", name.value, &body.broken),
            _ => return Vec::new(),
        };
        let names = Some(name.split(' ').map(str::to_owned).collect());
        let keywords = Some(vec![keyword.to_owned()]);
        let of_the_block =
            |broken: &Broken| Broken { names: names.clone(), keywords: keywords.clone(), ..broken.clone() };
        broken.iter().map(of_the_block).collect()
    }

    fn subjects(&self) -> Vec<String> {
        let all = |kind: &str, names: &[Name]| names.iter().map(|name| format!("{kind} {}", name.value)).collect();
        let subject = match self {
            Self::Units(_) => "units".to_owned(),
            Self::Blocks { .. } => "blocks".to_owned(),
            Self::Form { meaning, .. } => format!("form {}", names::form_name(meaning.value)),
            Self::Extension(_) => "extension".to_owned(),
            Self::Comment { .. } => "comment".to_owned(),
            Self::NoSequence | Self::Sequence { .. } => "sequence".to_owned(),
            Self::Offset(_) => "offset".to_owned(),
            Self::Retract(_) => "retract".to_owned(),
            Self::Format { name, .. } => format!("format {}", name.value),
            Self::Word { names, .. } => return all("word", names),
            Self::WriteRange { axis, .. } | Self::WriteUnwound(axis) => format!("write {}", axis.value),
            Self::Group { name, .. } => format!("group {}", name.value),
            Self::Plain { pattern, .. } => format!("plain {}", pattern.span.start),
            Self::On { event, .. } => format!("on {}", event.value.name()),
        };
        vec![subject]
    }

    /// A list of words is one statement a word.
    fn parts(&self, span: &Span) -> Vec<(Span, Self)> {
        match self {
            Self::Word { names, format, address, inch } => {
                let word = |name: &Name| Self::Word {
                    names: vec![name.clone()],
                    format: format.clone(),
                    address: address.clone(),
                    inch: inch.clone(),
                };
                names.iter().map(|name| (span.clone(), word(name))).collect()
            }
            _ => vec![(span.clone(), self.clone())],
        }
    }
}
