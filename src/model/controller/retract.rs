//! What `{retract}` prints, where the controller says it.

use super::ControlledAxis;
use super::lowering::Lowering;
use super::word::Said;
use crate::syntax::tree::ControllerStatement;
use mach_runtime::diagnostic::Code;
use mach_runtime::machine::Motion;

/// A way out that moves no axis, or does more than that.
pub(super) static NO_AXIS_WORD: Code = Code {
    id: "E0533",
    title: "the way out is not made of words of linear axes",
    explanation: "\
`retract` says which words take the tool out: addresses of the machine's linear axes, each with a number, and blanks between
them.

    retract \"Z0.\"
    retract \"Z0. Y0.\"
    retract \"G28 Z0.\"       // the code belongs into the block: \"G28 {retract}\"

The number is as the control counts the axis, not from the program zero.
",
};

/// The text of the way out, if it is said; reported if it is none.
pub(super) fn retract(lowering: &mut Lowering<'_>, axes: &[ControlledAxis<'_>]) -> Option<String> {
    let (index, said) = lowering.last(|statement| match statement {
        ControllerStatement::Retract(text) => Some(text),
        _ => None,
    })?;
    let linear = axes.iter().filter(|axis| axis.motion == Motion::Linear);
    let addresses: Vec<&str> = linear.filter_map(|axis| Some(Said::last(lowering, axis.name)?.address())).collect();
    let text = &said.value;
    if !is_made_of_words(text, &addresses) {
        let message = format!("`{text}` does not say where linear axes go");
        let label = format!("numbers of {} are expected", addresses.join(", "));
        lowering.report(&NO_AXIS_WORD, message, index, &said.span, label);
    }
    Some(text.clone())
}

/// Whether it is one word or more with these addresses and plain numbers.
fn is_made_of_words(text: &str, addresses: &[&str]) -> bool {
    let is_word = |word: &str| addresses.iter().any(|address| word.strip_prefix(address).is_some_and(is_number));
    !text.trim().is_empty() && text.split(' ').all(|word| word.is_empty() || is_word(word))
}

fn is_number(text: &str) -> bool {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    let is_plain = digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
    is_plain && digits.contains(|c: char| c.is_ascii_digit()) && digits.matches('.').count() <= 1
}
