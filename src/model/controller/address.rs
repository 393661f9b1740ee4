//! Addresses: each can be read, and stands for one thing.

use super::lowering::Lowering;
use super::placeholder::Meaning;
use super::scene::Scene;
use super::word::{FEED, FEED_PER_REVOLUTION, Said};
use super::{ControlledAxis, sequence};
use crate::syntax::tree::{BlockKind, ControllerStatement, Name, Span, Spanned, TemplatePiece, Text};
use mach_runtime::diagnostic::{Code, Diagnostic};
use mach_runtime::nc::dialect::Value;
use std::collections::BTreeMap;

/// An address that could be read as something else.
pub(super) static BAD_ADDRESS: Code = Code {
    id: "E0522",
    title: "an address that cannot be read, or that stands for two things",
    explanation: "\
The address of a word is one capital letter, or capital letters and digits with `=` behind them: with `C1` as the
address, `C15` could be `C1` with the number 5 or `C` with the number 15.

    word X Y Z length
    word C1 angle as \"C1=\"

G, M and O are the addresses of every control's own codes and programs, and no two of the words and the sequence numbers
have the same address; `C` and `C=` are the same.

    word C angle as \"M\"        // M30 would be the end of the program
    sequence \"F\"               // F12 G1 Z10. F1200.
    sequence \"S\"               // with \"S{speed} M3\" every block would set the speed
",
};

/// An address that programs for the machine have.
pub(super) struct Address<'a> {
    /// What it stands for.
    pub(super) whose: &'a str,
    pub(super) text: &'a str,
    /// Where it is said.
    index: usize,
    span: &'a Span,
}

impl<'a> Address<'a> {
    /// Without the sign behind it.
    fn bare(&self) -> &'a str {
        self.text.trim_end_matches('=')
    }
}

/// Checks every address that is said, and that those of the machine's words and of the sequence numbers differ.
pub(super) fn check(lowering: &mut Lowering<'_>, axes: &[ControlledAxis<'_>], blocks: BlockKind) {
    for (index, statement) in lowering.statements() {
        match statement {
            ControllerStatement::Word { names, address: None, .. } => {
                let names = names.iter().filter(|name| name.value != FEED_PER_REVOLUTION);
                names.for_each(|name| own_name(lowering, index, name));
            }
            // Statements begin with a plain number.
            ControllerStatement::Sequence { address: text, .. }
                if text.value.is_empty() && blocks == BlockKind::Statements => {}
            ControllerStatement::Word { address: Some(text), .. }
            | ControllerStatement::Sequence { address: text, .. } => said(lowering, index, text),
            _ => {}
        }
    }
    let mut addresses = in_programs(lowering, axes);
    addresses.extend(read_only(lowering, axes));
    report_shared(lowering, &addresses);
}

/// Checks an address as it was said.
fn said(lowering: &mut Lowering<'_>, index: usize, text: &Text) {
    if !is_readable(&text.value) {
        let message = format!("`{}` cannot be read as an address", text.value);
        lowering.report(&BAD_ADDRESS, message, index, &text.span, "one capital letter, or a longer name and `=`");
    } else if is_the_controls(&text.value) {
        report_the_controls(lowering, index, &text.value, &text.span);
    }
}

/// Checks the name of an axis as its own address.
fn own_name(lowering: &mut Lowering<'_>, index: usize, name: &Name) {
    if !is_readable(&name.value) {
        let message = format!("`{}` cannot be read as an address", name.value);
        let label = format!("`as \"{}=\"` would be one", name.value.to_uppercase());
        lowering.report(&BAD_ADDRESS, message, index, &name.span, label);
    } else if is_the_controls(&name.value) {
        report_the_controls(lowering, index, &name.value, &name.span);
    }
}

/// One capital letter, or more (with digits) before an equals sign.
fn is_readable(address: &str) -> bool {
    let name = address.strip_suffix('=').unwrap_or(address);
    let letter = name.starts_with(|c: char| c.is_ascii_uppercase());
    let rest = name.bytes().skip(1).all(|byte| byte.is_ascii_uppercase() || byte.is_ascii_digit());
    letter && rest && (name.len() == 1 || address.ends_with('='))
}

/// Whether it is the address of codes or of programs, perhaps with a number of its own (`M2=30`).
fn is_the_controls(address: &str) -> bool {
    matches!(address.trim_end_matches(|c: char| c == '=' || c.is_ascii_digit()), "G" | "M" | "O")
}

fn report_the_controls(lowering: &mut Lowering<'_>, index: usize, address: &str, span: &Span) {
    let message = format!("`{address}` cannot be an address of one's own");
    lowering.report(&BAD_ADDRESS, message, index, span, "G, M and O begin codes and programs");
}

/// The addresses of the sequence numbers, the feed and the machine's axes, without those that are wrong by themselves.
pub(super) fn in_programs<'a>(lowering: &Lowering<'a>, axes: &[ControlledAxis<'a>]) -> Vec<Address<'a>> {
    let sequence = sequence::address(lowering).map(|(index, text)| Address {
        whose: "the sequence numbers",
        text: &text.value,
        index,
        span: &text.span,
    });
    let feeds = [FEED, FEED_PER_REVOLUTION].into_iter().filter_map(|name| of_a_word(lowering, name, "the feed"));
    let axes = axes.iter().filter_map(|axis| of_a_word(lowering, axis.name, axis.name));
    let is_right = |address: &Address<'_>| is_readable(address.text) && !is_the_controls(address.text);
    sequence.into_iter().chain(feeds).chain(axes).filter(is_right).collect()
}

/// The other words that a control reads, and whose they are.
const READ_ONLY: [(&str, &str); 6] = [
    ("S", "the spindle's speed"),
    ("T", "the tool's number"),
    ("I", "the arc's centre I"),
    ("J", "the arc's centre J"),
    ("K", "the arc's centre K"),
    ("R", "the arc's radius"),
];

/// The addresses of words that no placeholder prints, but a control reads; an axis of the same name takes their place.
fn read_only<'a>(lowering: &Lowering<'a>, axes: &[ControlledAxis<'_>]) -> Vec<Address<'a>> {
    let others = READ_ONLY.into_iter().filter(|(name, _)| axes.iter().all(|axis| axis.name != *name));
    others.filter_map(|(name, whose)| of_a_word(lowering, name, whose)).collect()
}

fn of_a_word<'a>(lowering: &Lowering<'a>, name: &str, whose: &'a str) -> Option<Address<'a>> {
    let said = Said::last(lowering, name)?;
    Some(Address { whose, text: said.address(), index: said.index, span: said.address_span() })
}

/// Reports an address that stands for two things.
fn report_shared(lowering: &mut Lowering<'_>, addresses: &[Address<'_>]) {
    let mut first: BTreeMap<&str, &Address<'_>> = BTreeMap::new();
    for address in addresses {
        let bare = address.bare();
        let other = *first.entry(bare).or_insert(address);
        if other.whose != address.whose {
            let message = format!("{} and {} have the same address `{bare}`", other.whose, address.whose);
            let diagnostic = Diagnostic::error(&BAD_ADDRESS, message)
                .at(lowering.place(address.index, address.span), format!("that of {}", address.whose))
                .at(lowering.place(other.index, other.span), format!("that of {}", other.whose));
            lowering.diagnostics.push(diagnostic);
        }
    }
}

/// The letters that the standard keeps for axes, and that of the feed: in the call of a macro they are arguments, which may be
/// anything.
const ARGUMENTS: [&str; 10] = ["A", "B", "C", "F", "U", "V", "W", "X", "Y", "Z"];

/// Reports the number of a tool, of a register or of a speed behind an address that stands for something else, and is not told
/// already.
pub(super) fn check_number(
    lowering: &mut Lowering<'_>,
    scene: &Scene<'_>,
    left: &TemplatePiece,
    right: &Spanned<TemplatePiece>,
) {
    let (TemplatePiece::Text(text), TemplatePiece::Placeholder { name, .. }) = (left, &right.value) else { return };
    let Some(Meaning::Value(Value::Tool | Value::Register | Value::Speed)) = Meaning::of(name) else { return };
    let (addresses, told) = (in_programs(lowering, scene.axes), read_only(lowering, scene.axes));
    let is_told = |address: &Address<'_>| told.iter().any(|told| told.bare() == address.bare());
    let mut others = addresses.iter().filter(|address| !ARGUMENTS.contains(&address.text) && !is_told(address));
    if let Some(address) = others.find(|address| ends_with(text, address.text)) {
        let message = format!("`{{{name}}}` behind `{}` would be a number of {}", address.text, address.whose);
        let diagnostic = Diagnostic::error(&BAD_ADDRESS, message)
            .at(lowering.place(scene.index, &right.span), "another address is needed here or there")
            .at(lowering.place(address.index, address.span), format!("that of {}", address.whose));
        lowering.diagnostics.push(diagnostic);
    }
}

/// Whether the address stands at the end of a text.
fn ends_with(text: &str, address: &str) -> bool {
    let text = text.trim_end_matches([' ', '=']).to_ascii_uppercase();
    let before = text.strip_suffix(address.trim_end_matches('='));
    before.is_some_and(|before| !before.ends_with(|c: char| c.is_ascii_alphabetic()))
}
