//! The block of a motion is complete: every axis once, a cut in one line, and the feed in time.

use super::ControlledAxis;
use super::lowering::Lowering;
use crate::syntax::tree::Span;
use mach_runtime::diagnostic::Code;
use mach_runtime::nc::dialect::{Block, Line, Piece, Trigger};

/// A motion block that does not print the motion.
pub(super) static INCOMPLETE_MOTION: Code = Code {
    id: "E0526",
    title: "a motion block prints its words not exactly once",
    explanation: "\
The block of a motion prints the word of every axis of the machine exactly once: by `{axes}`, by `{linear}` and
`{rotary}`, or by the axes' names.

    on rapid { \"G0 {axes}\" }
    on feed  { \"G1 {axes} {feed}\" }
    on approach {
        \"G0 {rotary}\"
        \"G0 {X} {Y}\"
        \"G43 H{register:00} {Z}\"
    }

An axis that is not printed would stand still. `on feed` prints all axes in one line, because two blocks are two
motions, and the tool would leave its path. `on feed` and `on approach feed` print `{feed}` before the first axis has
moved, or with it.

A controller may name axes that this machine has not; a line of which nothing is left is left out. If a machine has an
axis that its controller's `on approach` does not name, write the block anew in the machine's own `controller` block.
",
};

/// Whether a line has words of axes, and the machine has none of them.
pub(super) fn is_left_out(line: &Line) -> bool {
    has_axis_words(line) && axes(line).next().is_none()
}

/// Reports what is wrong with a block, if it is a motion's.
pub(super) fn check(
    lowering: &mut Lowering<'_>,
    index: usize,
    block: &Block,
    machine: &[ControlledAxis<'_>],
    span: &Span,
) {
    if !block.trigger.is_motion() {
        return;
    }
    let event = block.trigger.name();
    let mistakes = [wrong_axes(block, machine), feed_mistake(block)];
    for (what, label) in mistakes.into_iter().flatten() {
        lowering.report(&INCOMPLETE_MOTION, format!("`on {event}` {what}"), index, span, label);
    }
}

/// A message and a label.
type Mistake = (String, &'static str);

/// Axes that are printed not exactly once.
fn wrong_axes(block: &Block, machine: &[ControlledAxis<'_>]) -> Option<Mistake> {
    let count = |axis: usize| block.lines.iter().flat_map(axes).filter(|printed| *printed == axis).count();
    let named = |wrong: fn(usize) -> bool| -> Vec<&str> {
        (0..machine.len()).filter(|axis| wrong(count(*axis))).map(|axis| machine[axis].name).collect()
    };
    let (missing, repeated) = (named(|count| count == 0), named(|count| count > 1));
    if !missing.is_empty() && missing.len() == machine.len() {
        return Some(("does not print `{axes}`".to_owned(), "exactly one `{axes}` is needed"));
    }
    let label = "every axis of the machine is needed exactly once; a machine's own `controller` block may say it anew";
    if !missing.is_empty() {
        return Some((format!("does not print {}", missing.join(", ")), label));
    }
    (!repeated.is_empty()).then(|| (format!("prints {} more than once", repeated.join(", ")), label))
}

/// A feed that comes late or not at all, and a cut in pieces.
fn feed_mistake(block: &Block) -> Option<Mistake> {
    if !block.trigger.is_feed() {
        return None;
    }
    let moving: Vec<usize> = (0..block.lines.len()).filter(|line| has_axis_words(&block.lines[*line])).collect();
    let fed = block.lines.iter().position(|line| line.pieces.contains(&Piece::Feed));
    match fed {
        None => Some(("does not print `{feed}`".to_owned(), "exactly one `{feed}` is needed")),
        Some(fed) if moving.first().is_some_and(|first| *first < fed) => {
            Some(("prints `{feed}` behind its first motion".to_owned(), "`{feed}` belongs into the first line"))
        }
        _ if block.trigger == Trigger::Feed && moving.len() > 1 => {
            Some(("prints the axes in several lines".to_owned(), "a cut is one motion of all axes"))
        }
        _ => None,
    }
}

fn has_axis_words(line: &Line) -> bool {
    line.pieces.iter().any(|piece| matches!(piece, Piece::Axes(_)))
}

/// The axes that a line prints, as indices.
fn axes(line: &Line) -> impl Iterator<Item = usize> {
    let sets = line.pieces.iter().filter_map(|piece| if let Piece::Axes(axes) = piece { Some(axes) } else { None });
    sets.flatten().copied()
}
