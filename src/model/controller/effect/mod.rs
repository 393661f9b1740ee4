//! What each block does: its text is printed with sample values and run on a control that knows nothing but the dialect's
//! table. A block must do what its event says, and nothing that the writer does not know of.

mod judge;
mod run;
mod sample;

use super::ControlledAxis;
use super::lowering::Lowering;
use crate::syntax::tree::{ControllerStatement, Span};
use mach_runtime::control::Control;
use mach_runtime::diagnostic::Code;
use mach_runtime::dialect::meaning::{FeedMode, Meaning, Once};
use mach_runtime::machine::Axis;
use mach_runtime::nc::dialect::{Block, Dialect, Piece, Value};
use mach_runtime::tool::ToolGeometry;

/// A block whose text is not made of what the dialect declares.
pub(super) static UNREAD_TEXT: Code = Code {
    id: "E0562",
    title: "the text of a block cannot be read as the control reads it",
    explanation: "\
Every text that a controller prints is read as the control would read it, by the words, groups and codes that the controller
declares. What is not declared would do something that nobody has looked at:

    on tool { \"G53 G0 {retract}\" \"T{tool} M6 M11\" }

Declare the code with what it means, or, if it moves nothing and switches nothing, as `plain`:

    once { tool change \"M6\"  machine coordinates \"G53\" }
    plain \"M11\" \"the C axis is unclamped\"

Axis words of motions come from `{axes}` and the like, those of a way out from `{retract}`; no axis word is written out.",
};

/// A block that does not do what its event says, or more than that.
pub(super) static OTHER_EFFECT: Code = Code {
    id: "E0563",
    title: "the block does something else than its event",
    explanation: "\
The text of each block is run on the control's model, and must do what its event says and leave nothing behind that the
blocks after it do not know of:

    on feed { \"G0 {axes} {feed}\" }        // a cut in rapid traverse
    on feed { \"{axes} {feed}\" }           // whatever motion was in force
    on feed { \"G1 {axes} ({feed})\" }      // the feed is in a comment
    on stop { \"M0\" \"G91\" }               // the rest of the program would be incremental
    on stop { \"M0\" \"G49\" }               // the rest would be without the tool's length
    on rapid { \"G0 {axes} F3000\" }        // the next cut would take this feed

A block that is no motion may move an axis only by `{retract}` in machine coordinates, and only at the program's start and end,
at an operation and at a tool change.",
};

/// Reports each block that cannot be read, or does something else than its event.
pub(super) fn check(lowering: &mut Lowering<'_>, dialect: &Dialect, named: &[ControlledAxis<'_>]) {
    let axes = sample::axes(named);
    for block in &dialect.blocks {
        let mut modes = sample::feed_modes(dialect);
        let found = modes.find_map(|mode| mistake(dialect, &axes, block, mode));
        let Some((code, message)) = found else { continue };
        let said = lowering.last(|statement| match statement {
            ControllerStatement::On { event, .. } if event.value == block.trigger => Some(&event.span),
            _ => None,
        });
        let (index, span): (usize, &Span) = said.expect("the dialect has this block of the statement");
        lowering.report(code, format!("`on {}` {message}", block.trigger.name()), index, span, "in this block");
    }
}

/// What is wrong with a block, and its code.
type Mistake = (&'static Code, String);

fn mistake(dialect: &Dialect, axes: &[Axis], block: &Block, mode: FeedMode) -> Option<Mistake> {
    let unread = |message: String| Some((&UNREAD_TEXT, message));
    let text = sample::print(dialect, axes, block, mode)?;
    if let Some(message) = written_out(dialect, axes, block) {
        return unread(message);
    }
    match run::run(&text, dialect, axes, (block.trigger, mode)) {
        Err(message) => unread(message),
        Ok(run) => judge::judge(&run, dialect, (block.trigger, mode)).map(|message| (&OTHER_EFFECT, message)),
    }
}

/// An axis word that is written out, and not in machine coordinates: one that is still there when the placeholders of axes print
/// nothing.
fn written_out(dialect: &Dialect, axes: &[Axis], block: &Block) -> Option<String> {
    let mut without = block.clone();
    for line in &mut without.lines {
        line.pieces.retain(|piece| !matches!(piece, Piece::Axes(_) | Piece::Value(Value::Retract, _)));
    }
    let text = sample::print(dialect, axes, &without, FeedMode::PerMinute)?;
    let control = Control::new(&dialect.table, axes, ToolGeometry::of_length(0.0));
    text.lines().find_map(|line| {
        let block = control.read(line).ok()??;
        let is_machine = block.has(Meaning::Once(Once::MachineCoordinates));
        (!block.axes.is_empty() && !is_machine).then(|| format!("has an axis word that is written out: `{line}`"))
    })
}
