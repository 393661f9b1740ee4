//! From a controller's statements to the dialect that the runtime prints by.

mod address;
mod beside;
mod block;
mod code;
mod lowering;
mod motion;
mod picture;
mod placeholder;
mod retract;
mod scene;
mod sequence;
mod template;
mod trial;
mod word;

use crate::syntax::tree::{ControllerStatement, Span, Text};
use lowering::Lowering;
use mach_runtime::diagnostic::{Code, Diagnostic, Place};
use mach_runtime::machine::Motion;
use mach_runtime::nc::dialect::{Codes, Dialect};
use mach_runtime::unit::LengthUnit;
use std::collections::BTreeMap;

/// Everything that can be wrong with a controller.
pub static CODES: [&Code; 14] = [
    &picture::BAD_PICTURE,
    &word::UNKNOWN_FORMAT,
    &address::BAD_ADDRESS,
    &LACKING,
    &placeholder::UNKNOWN_PLACEHOLDER,
    &placeholder::PLACEHOLDER_ELSEWHERE,
    &motion::INCOMPLETE_MOTION,
    &sequence::BAD_SEQUENCE,
    &MODAL_TWICE,
    &lowering::UNPRINTABLE,
    &trial::UNREADABLE_MOTION,
    &beside::RUNS_TOGETHER,
    &code::MORE_THAN_A_CODE,
    &retract::NO_AXIS_WORD,
];

/// A controller that says too little.
static LACKING: Code = Code {
    id: "E0523",
    title: "the controller does not say something that is needed",
    explanation: "\
A controller needs at least the blocks `on rapid` and `on feed`, a word for every axis of the machine, and a word `F`.

    controller plain {
        format length \"####.###\"
        format feed \"####.\"
        word X Y Z A B C length
        word F feed
        on rapid { \"G0 {axes}\" }
        on feed { \"G1 {axes} {feed}\" }
    }

A block that prints `{offset}`, `{units}` or `{feed_mode}` needs the statement `offset`, `code units` or `code feed`.
An axis that only this machine has is given its word in the machine's own `controller` block.
",
};

/// A code that is in two modal groups, or twice in one.
static MODAL_TWICE: Code = Code {
    id: "E0528",
    title: "a code stands in two modal groups",
    explanation: "\
The codes of one `modal` statement replace each other, so a code can stand in one group only, and once.

    modal G0 G1 G2 G3
    modal G17 G18 G19 G1      // G1 belongs to the motions
",
};

/// A controller as one machine has it.
pub struct Controller<'a> {
    /// Its name.
    pub name: &'a str,
    /// Where the machine names it.
    pub at: Place,
    /// Its statements, those that replace others behind them.
    pub statements: &'a [ControllerStatement],
    /// The place of a span of the statement with this index.
    pub place: &'a dyn Fn(usize, &Span) -> Place,
}

/// What a controller has to know of an axis.
#[derive(Debug, Clone, Copy)]
pub struct Axis<'a> {
    /// Its name.
    pub name: &'a str,
    /// How it moves.
    pub motion: Motion,
}

/// The dialect for a machine with these axes, in the machine's order.
///
/// `write` statements are not looked at: how a rotary is wound is a matter of the axis.
///
/// # Errors
/// Everything that is wrong with the statements.
pub fn lower(controller: &Controller<'_>, axes: &[Axis<'_>]) -> Result<Dialect, Vec<Diagnostic>> {
    let mut lowering = Lowering::new(controller);
    let units = units(&lowering);
    let formats = word::formats(&mut lowering, units);
    address::check(&mut lowering, axes);
    let axis_words = word::axes(&mut lowering, &formats, axes);
    let feed = word::feed(&mut lowering, &formats);
    let comment = comment(&mut lowering);
    let modal_groups = modal_groups(&mut lowering);
    code::check(&mut lowering, axes, &modal_groups);
    let blocks = block::blocks(&mut lowering, axes, &modal_groups, &comment);
    let extension = lowering.last(extension_statement).map(|(index, text)| lowering.printable(index, text));
    let offset = lowering.last(offset_statement).map(|(index, text)| lowering.printable(index, text));
    let retract = retract::retract(&mut lowering, axes);
    let dialect = Dialect {
        name: controller.name.to_owned(),
        units,
        extension: extension.unwrap_or_else(|| "nc".to_owned()),
        comment,
        sequence: sequence::sequence(&mut lowering),
        offset: offset.unwrap_or_default(),
        retract,
        codes: codes(&mut lowering, units),
        axes: axis_words,
        feed_per_revolution: word::feed_per_revolution(&mut lowering, &formats).unwrap_or_else(|| feed.clone()),
        feed,
        modal_groups,
        blocks,
    };
    if lowering.diagnostics.is_empty() {
        trial::read_back(&mut lowering, &dialect);
    }
    if lowering.diagnostics.is_empty() { Ok(dialect) } else { Err(lowering.diagnostics) }
}

fn extension_statement(statement: &ControllerStatement) -> Option<&Text> {
    if let ControllerStatement::Extension(text) = statement { Some(text) } else { None }
}

fn offset_statement(statement: &ControllerStatement) -> Option<&Text> {
    if let ControllerStatement::Offset(text) = statement { Some(text) } else { None }
}

/// The program's unit of length; millimetres where nothing is said.
fn units(lowering: &Lowering<'_>) -> LengthUnit {
    let said = lowering.last(|statement| match statement {
        ControllerStatement::Units(units) => Some(units.value),
        _ => None,
    });
    said.map_or(LengthUnit::Millimetre, |(_, units)| units)
}

/// What encloses comments; parentheses where nothing is said.
fn comment(lowering: &mut Lowering<'_>) -> (String, String) {
    let said = lowering.last(|statement| match statement {
        ControllerStatement::Comment { open, close } => Some((open, close)),
        _ => None,
    });
    let Some((index, (open, close))) = said else { return ("(".to_owned(), ")".to_owned()) };
    let close = close.as_ref().map(|close| lowering.printable(index, close));
    (lowering.printable(index, open), close.unwrap_or_default())
}

/// The codes of the program's state; empty where nothing is said (a block that prints one has been refused).
fn codes(lowering: &mut Lowering<'_>, units: LengthUnit) -> Codes {
    let unit_codes = lowering.last(|statement| match statement {
        ControllerStatement::UnitsCode { mm, inch } => Some((mm, inch)),
        _ => None,
    });
    let feed_codes = lowering.last(|statement| match statement {
        ControllerStatement::FeedCode { minute, revolution } => Some((minute, revolution)),
        _ => None,
    });
    let units = unit_codes.map(|(index, (mm, inch))| {
        let (mm, inch) = (lowering.printable(index, mm), lowering.printable(index, inch));
        if units == LengthUnit::Inch { inch } else { mm }
    });
    let feed = feed_codes.map(|(index, (minute, revolution))| {
        let revolution = revolution.as_ref().map(|revolution| lowering.printable(index, revolution));
        (lowering.printable(index, minute), revolution)
    });
    let (per_minute, per_revolution) = feed.unwrap_or_default();
    Codes { units: units.unwrap_or_default(), per_minute, per_revolution }
}

/// The groups of codes that replace each other.
fn modal_groups(lowering: &mut Lowering<'_>) -> Vec<Vec<String>> {
    let mut first_at: BTreeMap<&str, Place> = BTreeMap::new();
    let mut groups = Vec::new();
    for (index, statement) in lowering.statements() {
        let ControllerStatement::Modal(codes) = statement else { continue };
        for code in codes {
            let place = lowering.place(index, &code.span);
            let Some(first) = first_at.insert(&code.value, place.clone()) else { continue };
            let diagnostic = Diagnostic::error(&MODAL_TWICE, format!("{} stands in two modal groups", code.value))
                .at(place, "here again")
                .at(first, "first here");
            lowering.diagnostics.push(diagnostic);
        }
        groups.push(codes.iter().map(|code| code.value.clone()).collect());
    }
    groups
}
