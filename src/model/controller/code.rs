//! The texts of codes: nothing in them is a word or a code that the program's blocks print themselves.

use super::ControlledAxis;
use super::address::{self, Address};
use super::lowering::Lowering;
use crate::syntax::tree::{ControllerStatement, Span, Spanned, TemplatePiece};
use mach_runtime::diagnostic::Code;
use mach_runtime::nc::moves::has_word;

/// A code that does more than a code.
pub(super) static MORE_THAN_A_CODE: Code = Code {
    id: "E0532",
    title: "the text of a code holds a word or a code that motions print",
    explanation: "\
Motions print words and codes of the group `motion` only when they change. The text of a meaning must therefore leave them
alone: it holds no word of an axis or of the feed and no sequence number, and outside of the group `motion` no code of it.

    group offset { 1 \"G54 X5.\" }       // where is X then?
    group offset { 1 \"G54 G0\" }        // the next cut would print no G1
    plain \"C90\"                       // an axis word of a machine with an axis C
",
};

/// A text of codes, and where it is said.
struct Said<'a> {
    index: usize,
    /// Without its holes.
    text: String,
    span: &'a Span,
    is_motion: bool,
}

/// Reports the texts that hold more than codes of their own.
pub(super) fn check(lowering: &mut Lowering<'_>, axes: &[ControlledAxis<'_>], modal_groups: &[Vec<String>]) {
    let addresses = address::in_programs(lowering, axes);
    let texts = lowering.statements().flat_map(|(index, statement)| texts(index, statement));
    for Said { index, text, span, is_motion } in texts {
        let modal_code = || if is_motion { None } else { modal_code(&text, modal_groups) };
        if let Some(what) = word(&text, &addresses).or_else(modal_code) {
            let message = format!("`{text}` is more than a code: it holds {what}");
            lowering.report(&MORE_THAN_A_CODE, message, index, span, "motions would not know of it");
        }
    }
}

fn texts(index: usize, statement: &ControllerStatement) -> Vec<Said<'_>> {
    match statement {
        ControllerStatement::Plain { pattern, .. } => vec![said(index, pattern, false)],
        ControllerStatement::Group { name, body } => {
            let texts = body.statements.iter().flat_map(|member| &member.node.texts);
            texts.map(|text| said(index, &text.pattern, name.value == "motion")).collect()
        }
        _ => Vec::new(),
    }
}

fn said(index: usize, pattern: &Pattern, is_motion: bool) -> Said<'_> {
    Said { index, text: literal(&pattern.value), span: &pattern.span, is_motion }
}

/// A text with its holes.
type Pattern = Spanned<Vec<Spanned<TemplatePiece>>>;

/// What stands in the text between its holes.
fn literal(pieces: &[Spanned<TemplatePiece>]) -> String {
    let literal = |piece: &Spanned<TemplatePiece>| match &piece.value {
        TemplatePiece::Text(text) => text.clone(),
        TemplatePiece::Placeholder { .. } => " ".to_owned(),
    };
    pieces.iter().map(literal).collect()
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
