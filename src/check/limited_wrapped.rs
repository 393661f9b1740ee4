//! An axis with limits that is written within a turn which its travel leaves.

use crate::diagnostic::{Code, Diagnostic, Suggestion};
use crate::model::draft::{AxisDraft, Draft, WrittenDraft};
use crate::model::quantity::readable;
use crate::model::source::Located;

/// A word that stands for a position beyond the travel as well.
pub(crate) static BEYOND_THE_TURN: Code = Code {
    id: "E0555",
    title: "the travel of an axis with limits is not within its written range",
    explanation: "\
An axis with limits goes exactly where its word says: the control does not look for the same angle a whole turn away. So
every position within the travel must be its own word.

    rotary C about +z travel -200 .. 200
    write C 0 .. 360           // -158 would be written as C202., beyond the travel
    write C unwound            // C-158.

The range ends before its second value: with `write C 0 .. 360` the position 360 is written as 0. Only an axis that turns
without limits can be written within one turn wherever it stands.
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    let is_known = |axis: &&AxisDraft| !draft.lost_of_controller.may_say(&["write"], &axis.name.value);
    draft.rotaries().filter(is_known).filter_map(|axis| beyond(draft, axis)).collect()
}

fn beyond(draft: &Draft<'_>, axis: &AxisDraft) -> Option<Diagnostic> {
    let written = draft.written_of(axis)?;
    let (range, travel) = (written.range_deg.as_ref()?, axis.travel.as_ref()?);
    let ([from, to], [lower, upper]) = (range.value, travel.value);
    let is_limited = lower.is_finite() && upper.is_finite();
    let is_within = from <= lower && upper < to;
    (is_limited && lower < upper && !is_within).then(|| report(draft, axis, written, range, travel))
}

fn report(
    draft: &Draft<'_>,
    axis: &AxisDraft,
    written: &WrittenDraft,
    range: &Located<[f64; 2]>,
    travel: &Located<[f64; 2]>,
) -> Diagnostic {
    let name = &axis.name.value;
    let [from, to] = range.value;
    let end = if travel.value[0] < from { travel.value[0] } else { travel.value[1] };
    let word = from + (end - from).rem_euclid(360.0);
    let message = format!("{name} at {} deg would be written as {}", readable(end), readable(word));
    let label = "an axis with limits turns to where its word says";
    let found = super::error(draft, &BEYOND_THE_TURN, message, &range.at, label);
    let found = found.at(draft.sources.place(&travel.at), format!("not within {} .. {}", readable(from), readable(to)));
    if !written.of_the_machine {
        return found.note(format!("say `write {name} unwound` in the machine's own `controller` block"));
    }
    found.suggest(Suggestion {
        text: "write the position as it is".to_owned(),
        place: draft.sources.place(&range.at),
        replacement: "unwound".to_owned(),
    })
}
