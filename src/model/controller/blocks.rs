//! How blocks are put together.

use super::lowering::Lowering;
use crate::syntax::tree::{BlockKind, ControllerStatement};
use mach_runtime::diagnostic::Code;

/// A mark at the end of lines that words have in them.
pub(super) static BAD_MARK: Code = Code {
    id: "E0535",
    title: "a line that goes on cannot be told from words",
    explanation: "\
What stands at the end of a line that goes on in the next one is a sign that no word, number or comment has:

    blocks statements continued \"~\"
",
};

/// How blocks are put together.
#[derive(Debug, Clone)]
pub(super) struct Blocks {
    pub(super) kind: BlockKind,
    /// What stands at the end of a line that goes on in the next one.
    pub(super) continued: Option<String>,
}

impl Blocks {
    /// As the controller says; words where it says nothing.
    pub(super) fn of(lowering: &mut Lowering<'_>, comment: &(String, String)) -> Self {
        let said = lowering.last(|statement| match statement {
            ControllerStatement::Blocks { kind, continued } => Some((kind.value, continued)),
            _ => None,
        });
        let Some((index, (kind, continued))) = said else { return Self { kind: BlockKind::Words, continued: None } };
        if let Some(mark) = continued {
            let is_sign = |c: char| c.is_ascii_punctuation() && !".+-=\"#_/%:,".contains(c);
            let is_comment = |text: &str| !text.is_empty() && (mark.value.contains(text) || text.contains(&mark.value));
            let is_free = !mark.value.is_empty() && mark.value.chars().all(is_sign);
            if !is_free || is_comment(&comment.0) || is_comment(&comment.1) {
                let message = format!("`{}` cannot end a line that goes on", mark.value);
                lowering.report(&BAD_MARK, message, index, &mark.span, "a sign that no word has is expected");
            }
        }
        Self { kind, continued: continued.as_ref().map(|mark| mark.value.clone()) }
    }

    /// The text of a code as it is printed: a line ends behind each mark.
    pub(super) fn printed(&self, text: &str) -> String {
        match &self.continued {
            Some(mark) => text.replace(&format!("{mark} "), &format!("{mark}\n  ")),
            None => text.to_owned(),
        }
    }
}
