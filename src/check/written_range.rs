//! A written range that is not one turn, or of an axis that does not turn.

use crate::diagnostic::{Code, Diagnostic, Suggestion};
use crate::model::draft::{AxisDraft, Draft, WrittenDraft};
use crate::model::quantity::readable;
use crate::model::source::Located;
use mach_runtime::machine::Motion;

/// A written range that is not one turn.
pub(crate) static NOT_ONE_TURN: Code = Code {
    id: "E0551",
    title: "the written range is not one turn",
    explanation: "\
`write C 0 .. 360` says that the program shows C reduced to one turn, whatever the axis has turned: the range is 360
degrees wide, so that every position has exactly one value in it.

    write C 0 .. 180           // what is written at 270 degrees?
    write C 0 .. 360           // 0 <= C < 360
    write C -180 .. 180        // -180 <= C < 180
    write C unwound            // whole turns included

The physical travel is another thing: it belongs to the axis (`rotary C … travel -30 .. 120 deg`).
",
};

/// A written range of something that does not turn.
pub(crate) static NOT_ROTARY: Code = Code {
    id: "E0552",
    title: "a written range for something that is not a rotary axis",
    explanation: "\
Only a rotary axis can be written reduced to one turn. In a machine's own `controller` block `write` names one of the
machine's rotary axes; in a controller's definition it may name axes that a machine has not.

    write X 0 .. 360           // X is a linear axis
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    draft
        .written
        .iter()
        .filter_map(|written| wrong_axis(draft, written).or_else(|| wrong_range(draft, written)))
        .collect()
}

fn wrong_axis(draft: &Draft<'_>, written: &WrittenDraft) -> Option<Diagnostic> {
    let name = &written.axis.value.value;
    let (message, label) = match draft.axis(name) {
        Some((_, AxisDraft { motion: Motion::Rotary, .. })) => return None,
        None if !written.of_the_machine || draft.may_lack_axis(name) => return None,
        Some(_) => (format!("{name} is not a rotary axis"), "a linear axis"),
        None => (format!("the machine has no axis {name}"), "unknown axis"),
    };
    let rotaries: Vec<&str> = draft.rotaries().map(|axis| axis.name.value.as_str()).collect();
    let diagnostic = super::error(draft, &NOT_ROTARY, message, &written.axis.at, label);
    if draft.may_lack_axes() {
        return Some(diagnostic);
    }
    Some(diagnostic.note(format!("the machine's rotary axes: {}", rotaries.join(", "))))
}

fn wrong_range(draft: &Draft<'_>, written: &WrittenDraft) -> Option<Diagnostic> {
    let Located { value: [from, to], at } = written.range_deg.as_ref()?;
    let width = to - from;
    if (width - 360.0).abs() <= 1e-9 {
        return None;
    }
    let message = format!("the written range of {} is {} deg wide", written.axis.value.value, readable(width));
    let suggestion = Suggestion {
        text: "one turn from the same beginning".to_owned(),
        place: draft.sources.place(at),
        replacement: format!("{} .. {}", readable(*from), readable(from + 360.0)),
    };
    Some(super::error(draft, &NOT_ONE_TURN, message, at, "must be 360 deg wide").suggest(suggestion))
}
