//! The statements of a controller.

use super::expression::expression;
use super::layout::{StatementText, Table};
use super::machine::clause;
use super::{Printer, escaped, quoted};
use crate::syntax::tree::{
    BlockKind, Body, ControllerStatement, LengthUnit, LineTemplate, Member, MemberText, Name, Spanned, TemplatePiece,
    Text, Trivia,
};
use mach_runtime::dialect::names;

impl Printer {
    pub(super) fn controller_statement(&mut self, statement: &ControllerStatement, behind: Option<&str>) {
        match statement {
            ControllerStatement::On { event, body } => {
                self.lines(&format!("on {}", event.value.name()), body, behind);
            }
            ControllerStatement::Group { name, body } => {
                let head = if name.value == "once" { name.value.to_owned() } else { format!("group {}", name.value) };
                self.group(&head, body, behind);
            }
            statement => self.line(line(statement), behind),
        }
    }

    /// A group: on one line where it fits and no comment stands in it.
    fn group(&mut self, head: &str, body: &Body<Member>, behind: Option<&str>) {
        let has_comments = !body.trailing.is_empty() || body.statements.iter().any(|it| it.trivia != Trivia::default());
        let members = body.statements.iter().map(|it| member(&it.node).join(" "));
        let line = format!("{head} {{ {} }}", members.collect::<Vec<_>>().join("  "));
        if !has_comments && line.len() <= LONGEST_GROUP {
            return self.line(StatementText::plain(line), behind);
        }
        self.block(head, body, behind, |printer, member, behind| {
            printer.line(StatementText::row(Table::Members, self::member(member)), behind);
        });
    }
}

/// A group with more characters has a line for each member.
const LONGEST_GROUP: usize = 100;

/// A statement without a block.
fn line(statement: &ControllerStatement) -> StatementText {
    match statement {
        ControllerStatement::Format { name, picture, inch, zero } => {
            let cells = vec![
                format!("format {}", name.value),
                quoted(picture),
                text_clause("inch", inch.as_ref()),
                text_clause("zero", zero.as_ref()),
            ];
            StatementText::row(Table::Formats, cells)
        }
        ControllerStatement::Word { names, format, address, inch } => {
            let worth = inch.as_ref().map_or(String::new(), |inch| format!("inch {}", expression(inch)));
            let address = text_clause("as", address.as_ref());
            let cells = vec![format!("word {}", joined(names)), format.value.clone(), address, worth];
            StatementText::row(Table::Words, cells)
        }
        statement => StatementText::plain(plain(statement)),
    }
}

fn plain(statement: &ControllerStatement) -> String {
    match statement {
        ControllerStatement::Units(unit) => match unit.value {
            LengthUnit::Millimetre => "units mm".to_owned(),
            LengthUnit::Inch => "units inch".to_owned(),
        },
        ControllerStatement::Blocks { kind, continued } => {
            let kind = match kind.value {
                BlockKind::Words => "words",
                BlockKind::Statements => "statements",
            };
            let continued = continued.as_ref().map_or(String::new(), |mark| format!(" continued {}", quoted(mark)));
            format!("blocks {kind}{continued}")
        }
        ControllerStatement::Form { meaning, text } => {
            format!("form {} {}", names::form_name(meaning.value), pieces(&text.value))
        }
        ControllerStatement::Extension(text) => format!("extension {}", quoted(text)),
        ControllerStatement::Comment { open, close } => {
            let close = close.as_ref().map_or(String::new(), |close| format!(" {}", quoted(close)));
            format!("comment {}{close}", quoted(open))
        }
        ControllerStatement::NoSequence => "sequence none".to_owned(),
        ControllerStatement::Sequence { address, start, step, greatest } => {
            let clauses = [("start", start), ("step", step), ("greatest", greatest)];
            let clauses: String = clauses.iter().map(|(keyword, value)| clause(keyword, value.as_ref())).collect();
            format!("sequence {}{clauses}", quoted(address))
        }
        ControllerStatement::Offset(number) => format!("offset {}", expression(number)),
        ControllerStatement::Retract(text) => format!("retract {}", quoted(text)),
        ControllerStatement::WriteRange { axis, from, to } => {
            format!("write {} {} .. {}", axis.value, expression(from), expression(to))
        }
        ControllerStatement::WriteUnwound(axis) => format!("write {} unwound", axis.value),
        ControllerStatement::Plain { pattern, note } => {
            let note = note.as_ref().map_or(String::new(), |note| format!(" {}", quoted(note)));
            format!("plain {}{note}", pieces(&pattern.value))
        }
        ControllerStatement::Format { .. }
        | ControllerStatement::Word { .. }
        | ControllerStatement::Group { .. }
        | ControllerStatement::On { .. } => unreachable!("printed as a row or a block"),
    }
}

fn text_clause(keyword: &str, text: Option<&Text>) -> String {
    text.map_or(String::new(), |text| format!("{keyword} {}", quoted(text)))
}

fn joined(names: &[Name]) -> String {
    names.iter().map(|name| name.value.as_str()).collect::<Vec<_>>().join(" ")
}

/// A member of a group.
fn member(member: &Member) -> Vec<String> {
    let mut texts = member.texts.iter().map(member_text);
    let first = texts.next().unwrap_or_default();
    vec![member.name.value.clone(), first + &texts.map(|also| format!(" also {also}")).collect::<String>()]
}

fn member_text(text: &MemberText) -> String {
    let effects: Vec<String> = text.effects.iter().map(|it| format!("{} {}", it.group, it.member)).collect();
    let effects = if effects.is_empty() { String::new() } else { format!(" ({})", effects.join(", ")) };
    pieces(&text.pattern.value) + &effects
}

/// One line of an `on` block.
pub(super) fn template(line: &LineTemplate) -> String {
    format!("{}{}", if line.bare { "bare " } else { "" }, pieces(&line.pieces))
}

/// A text with placeholders, in quotes.
fn pieces(pieces: &[Spanned<TemplatePiece>]) -> String {
    let pieces: String = pieces.iter().map(|piece| template_piece(&piece.value)).collect();
    format!("\"{pieces}\"")
}

fn template_piece(piece: &TemplatePiece) -> String {
    match piece {
        TemplatePiece::Text(text) => escaped(text).replace('{', "{{").replace('}', "}}"),
        TemplatePiece::Placeholder { name, picture: None } => format!("{{{name}}}"),
        TemplatePiece::Placeholder { name, picture: Some(picture) } => format!("{{{name}:{picture}}}"),
    }
}
