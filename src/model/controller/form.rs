//! Other ways to write the word of an axis.

use super::lowering::Lowering;
use crate::syntax::tree::{ControllerStatement, Spanned, TemplatePiece};
use mach_runtime::diagnostic::Code;
use mach_runtime::dialect::table::Form;

/// A form that is no word of an axis.
pub(super) static BAD_FORM: Code = Code {
    id: "E0536",
    title: "this is no form of an axis word",
    explanation: "\
Another way to write the word of an axis has its address and its number, and in front of them, between them or behind them what
makes the difference:

    form incremental \"I{address}{number}\"           // IX+10
    form incremental \"{address}=IC({number})\"       // X=IC(10)

The forms are `absolute`, `incremental`, `shortest`, `positive` and `negative`.",
};

/// The forms that the controller declares.
pub(super) fn forms(lowering: &mut Lowering<'_>) -> Vec<Form> {
    let mut forms = Vec::new();
    for (index, statement) in lowering.statements() {
        let ControllerStatement::Form { meaning, text } = statement else { continue };
        match parts(&text.value) {
            Some([before, between, behind]) => {
                forms.push(Form { meaning: meaning.value, before, between, behind });
            }
            None => {
                let message = "this is no form of an axis word";
                lowering.report(&BAD_FORM, message, index, &text.span, "`{address}` and then `{number}` are expected");
            }
        }
    }
    forms
}

/// What stands before the address, between it and the number, and behind that; something stands somewhere.
fn parts(pieces: &[Spanned<TemplatePiece>]) -> Option<[String; 3]> {
    let mut parts: [String; 3] = Default::default();
    let mut holes = ["address", "number"].iter();
    let mut at = 0;
    for piece in pieces {
        match &piece.value {
            TemplatePiece::Text(text) => parts[at] += &text.to_ascii_uppercase(),
            TemplatePiece::Placeholder { name, picture: None } if holes.next() == Some(&name.as_str()) => at += 1,
            TemplatePiece::Placeholder { .. } => return None,
        }
    }
    let is_plain = parts.iter().all(String::is_empty);
    (at == 2 && !is_plain).then_some(parts)
}
