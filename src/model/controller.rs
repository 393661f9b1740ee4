//! From a controller's statements to the dialect that the runtime prints by.

mod address;
mod beside;
mod block;
mod blocks;
mod code;
mod comment;
mod controlled_axis;
mod effect;
mod feed_unit;
mod form;
mod lowering;
mod motion;
mod pattern;
mod picture;
mod placeholder;
mod retract;
mod scene;
mod sequence;
mod table;
mod template;
mod word;

use crate::syntax::tree::{BlockKind, ControllerStatement, Span, Text};
use blocks::Blocks;
pub use controlled_axis::ControlledAxis;
use lowering::Lowering;
use mach_runtime::diagnostic::{Code, Diagnostic, Place};
use mach_runtime::dialect::meaning::{FeedMode, Meaning};
use mach_runtime::nc::dialect::{Codes, Dialect};
use mach_runtime::unit::LengthUnit;

/// Everything that can be wrong with a controller.
pub static CODES: [&Code; 20] = [
    &picture::BAD_PICTURE,
    &word::UNKNOWN_FORMAT,
    &address::BAD_ADDRESS,
    &LACKING,
    &placeholder::UNKNOWN_PLACEHOLDER,
    &placeholder::PLACEHOLDER_ELSEWHERE,
    &motion::INCOMPLETE_MOTION,
    &sequence::BAD_SEQUENCE,
    &table::BAD_PATTERN,
    &table::TWO_MEANINGS,
    &effect::UNREAD_TEXT,
    &effect::OTHER_EFFECT,
    &lowering::UNPRINTABLE,
    &beside::RUNS_TOGETHER,
    &code::MORE_THAN_A_CODE,
    &retract::NO_AXIS_WORD,
    &comment::BAD_DELIMITER,
    &blocks::BAD_MARK,
    &form::BAD_FORM,
    &feed_unit::BAD_UNIT,
];

/// A controller that says too little.
static LACKING: Code = Code {
    id: "E0523",
    title: "the controller does not say something that is needed",
    explanation: "\
A controller needs at least the blocks `on rapid` and `on feed` with what their codes mean, a word for every axis of the machine,
and a word `F`.

    controller plain {
        format length \"####.###\"
        format feed \"####.\"
        word X Y Z A B C length
        word F feed
        group motion { rapid \"G0\"  line \"G1\" }
        on rapid { \"G0 {axes}\" }
        on feed { \"G1 {axes} {feed}\" }
    }

A block that prints `{offset}`, `{units}` or `{feed_mode}` needs the member `1` of the group
`offset` (or what `offset` says), the group `units` or the group `feed`.
An axis that only this machine has is given its word in the machine's own `controller` block.
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

/// The dialect for a machine with these axes, in the machine's order.
///
/// `write` statements are not looked at: how a rotary is wound is a matter of the axis.
///
/// # Errors
/// Everything that is wrong with the statements.
pub fn lower(controller: &Controller<'_>, axes: &[ControlledAxis<'_>]) -> Result<Dialect, Vec<Diagnostic>> {
    let mut lowering = Lowering::new(controller);
    let units = units(&lowering);
    let formats = word::formats(&mut lowering, units);
    let comment = comment::comment(&mut lowering);
    let blocks_are = Blocks::of(&mut lowering, &comment);
    address::check(&mut lowering, axes, blocks_are.kind);
    let axis_words = word::axes(&mut lowering, &formats, axes);
    let feed = word::feed(&mut lowering, &formats);
    feed_unit::check(&mut lowering);
    let modal_groups = modal_groups(&lowering, blocks_are.kind);
    code::check(&mut lowering, axes, &modal_groups);
    let blocks = block::blocks(&mut lowering, axes, &modal_groups, &comment);
    let extension = lowering.last(extension_statement).map(|(index, text)| lowering.printable(index, text));
    let sequence = sequence::sequence(&mut lowering);
    let table = table::table(&mut lowering, &formats, axes, &axis_words, &comment, sequence.as_ref(), &blocks_are);
    let retract = retract::retract(&mut lowering, axes);
    let dialect = Dialect {
        name: controller.name.to_owned(),
        units,
        extension: extension.unwrap_or_else(|| "nc".to_owned()),
        comment,
        sequence,
        offset: blocks_are.printed(&offset(&mut lowering)),
        retract,
        codes: codes(&lowering, units),
        axes: axis_words,
        feed_per_revolution: word::feed_per_revolution(&mut lowering, &formats).unwrap_or_else(|| feed.clone()),
        feed,
        modal_groups,
        blocks,
        table,
    };
    if lowering.diagnostics.is_empty() {
        effect::check(&mut lowering, &dialect, axes);
    }
    if lowering.diagnostics.is_empty() { Ok(dialect) } else { Err(lowering.diagnostics) }
}

fn extension_statement(statement: &ControllerStatement) -> Option<&Text> {
    if let ControllerStatement::Extension(text) = statement { Some(text) } else { None }
}

/// The program's unit of length; millimetres where nothing is said.
fn units(lowering: &Lowering<'_>) -> LengthUnit {
    let said = lowering.last(|statement| match statement {
        ControllerStatement::Units(units) => Some(units.value),
        _ => None,
    });
    said.map_or(LengthUnit::Millimetre, |(_, units)| units)
}

/// The codes of the program's state; empty where nothing is said (a block that prints one has been refused).
fn codes(lowering: &Lowering<'_>, units: LengthUnit) -> Codes {
    let code = |meaning| table::literal(lowering, (meaning, None));
    Codes {
        units: code(Meaning::Units(units)).unwrap_or_default(),
        per_minute: code(Meaning::FeedMode(FeedMode::PerMinute)).unwrap_or_default(),
        per_revolution: code(Meaning::FeedMode(FeedMode::PerRevolution)),
    }
}

/// The codes of motions, which replace each other; a statement says its own.
fn modal_groups(lowering: &Lowering<'_>, blocks: BlockKind) -> Vec<Vec<String>> {
    if blocks == BlockKind::Statements {
        return Vec::new();
    }
    let members = table::members(lowering);
    let motions = members.iter().filter(|(_, member)| matches!(member.meaning.0, Meaning::Motion(_)));
    vec![motions.filter_map(|(_, member)| table::literal(lowering, member.meaning)).collect()]
}

/// The code of the work offset; empty where nothing is said.
fn offset(lowering: &mut Lowering<'_>) -> String {
    let said = lowering.last(|statement| match statement {
        ControllerStatement::Offset(number) => Some(number),
        _ => None,
    });
    let number = match said {
        Some((index, number)) => sequence::whole(lowering, index, number, 1),
        None => Some(1),
    };
    let number = number.map(|number| number as u32);
    table::literal(lowering, (Meaning::Offset, number)).unwrap_or_default()
}
