//! What encloses comments.

use super::lowering::Lowering;
use crate::syntax::tree::{ControllerStatement, Text};
use mach_runtime::diagnostic::Code;

/// A delimiter that words have in them.
pub(super) static BAD_DELIMITER: Code = Code {
    id: "E0534",
    title: "a comment cannot be told from words",
    explanation: "\
What opens a comment, and what closes it, is made of signs that no word, number or text in quotes has. A control would take
anything else for a comment in the middle of a block, or the other way round.

    comment \"(\" \")\"
    comment \";\"
    comment \"N\"             // N10 G1 X5.
    comment \"\"              // where does it begin?
",
};

/// What opens and closes a comment, nothing for the end of the line; parentheses where nothing is said.
pub(super) fn comment(lowering: &mut Lowering<'_>) -> (String, String) {
    let said = lowering.last(|statement| match statement {
        ControllerStatement::Comment { open, close } => Some((open, close)),
        _ => None,
    });
    let Some((index, (open, close))) = said else { return ("(".to_owned(), ")".to_owned()) };
    let close = close.as_ref().map(|close| delimiter(lowering, index, close));
    (delimiter(lowering, index, open), close.unwrap_or_default())
}

/// The text, which is reported if it cannot delimit a comment.
fn delimiter(lowering: &mut Lowering<'_>, index: usize, text: &Text) -> String {
    let is_a_sign = |c: char| c.is_ascii_punctuation() && !matches!(c, '.' | '+' | '-' | '=' | '"' | '#' | '_');
    if text.value.is_empty() || !text.value.chars().all(is_a_sign) {
        let message = format!("`{}` cannot delimit a comment", text.value);
        lowering.report(&BAD_DELIMITER, message, index, &text.span, "signs that no word has are expected");
    }
    text.value.clone()
}
