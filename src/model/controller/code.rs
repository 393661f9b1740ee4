//! The texts of codes: nothing in them is a word or a code that the program's blocks print themselves.

use super::Axis;
use super::address::{self, Address};
use super::lowering::Lowering;
use crate::syntax::tree::{ControllerStatement, Span, Text};
use mach_runtime::diagnostic::Code;
use mach_runtime::nc::moves::has_word;

/// A code that does more than a code.
pub(super) static MORE_THAN_A_CODE: Code = Code {
    id: "E0532",
    title: "the text of a code holds a word or a code that motions print",
    explanation: "\
Motions print words and codes of `modal` groups only when they change. What `{offset}`, `{units}` and `{feed_mode}` print must
therefore leave them alone, and a code of a `modal` statement is no word of an axis, of the feed, or a sequence number.

    offset \"G54 X5.\"          // where is X then?
    offset \"G54 G0\"           // with `modal G0 G1` the next cut would print no G1
    modal C0 C90              // axis words of a machine with an axis C
",
};

/// A text of codes, and where it is said.
struct Said<'a> {
    index: usize,
    text: &'a str,
    span: &'a Span,
}

/// Reports the texts that hold more than codes of their own.
pub(super) fn check(lowering: &mut Lowering<'_>, axes: &[Axis<'_>], modal_groups: &[Vec<String>]) {
    let addresses = address::in_programs(lowering, axes);
    let texts = lowering.statements().flat_map(|(index, statement)| texts(index, statement));
    for Said { index, text, span } in texts {
        if let Some(what) = word(text, &addresses).or_else(|| modal_code(text, modal_groups)) {
            let message = format!("`{text}` is more than a code: it holds {what}");
            lowering.report(&MORE_THAN_A_CODE, message, index, span, "motions would not know of it");
        }
    }
}

fn said(index: usize, text: &Text) -> Said<'_> {
    Said { index, text: &text.value, span: &text.span }
}

fn texts(index: usize, statement: &ControllerStatement) -> Vec<Said<'_>> {
    use ControllerStatement::{FeedCode, Modal, Offset, UnitsCode};
    let said = |text| said(index, text);
    match statement {
        Offset(text) => vec![said(text)],
        UnitsCode { mm, inch } => vec![said(mm), said(inch)],
        FeedCode { minute, revolution } => {
            [Some(minute), revolution.as_ref()].into_iter().flatten().map(said).collect()
        }
        Modal(codes) => codes.iter().map(|code| Said { index, text: &code.value, span: &code.span }).collect(),
        _ => Vec::new(),
    }
}

/// The word in a text that the program's blocks print.
fn word(text: &str, addresses: &[Address<'_>]) -> Option<String> {
    let found = addresses.iter().find(|address| has_word(text, address.text))?;
    Some(format!("a word of {}", found.whose))
}

/// The code beside others in a text that motions print.
fn modal_code(text: &str, modal_groups: &[Vec<String>]) -> Option<String> {
    let mut codes = text.split(|c: char| !(c.is_ascii_alphanumeric() || matches!(c, '.' | '_')));
    let code = codes.find(|code| *code != text && modal_groups.iter().flatten().any(|modal| modal == code))?;
    Some(format!("the modal code {code}"))
}
