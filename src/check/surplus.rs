//! `lock`, `prefer` and `free` of axes of which that cannot be said, or with values that they cannot have.

use crate::diagnostic::{Code, Diagnostic, Suggestion};
use crate::model::draft::{AxisDraft, Draft, RuleDraft};
use crate::model::quantity::readable;
use crate::syntax::spelling::nearest;
use mach_runtime::machine::{Motion, Rule};

/// An axis that the pose needs.
pub(crate) static NOT_SURPLUS: Code = Code {
    id: "E0312",
    title: "an axis that the pose needs is left open",
    explanation: "\
`prefer` and `free` are said of axes that a pose does not decide. A rotary axis is one of them only where three linear and
two other rotary axes are left, which the pose decides. Any axis can be locked: the machine then does without it.

    chain w C b X Y Z B t
    branch {
        free B               // with C alone the tool does not point where the program wants it
        lock B 90 deg        // four axes, with the head at 90 degrees
    }

A `lock`, `prefer` or `free` of something that is not an axis of the machine is the same mistake.
",
};

/// A value that the axis cannot have.
pub(crate) static OUT_OF_TRAVEL: Code = Code {
    id: "E0313",
    title: "an axis is to stand beyond its travel",
    explanation: "\
The position of `lock` and `prefer` lies within the travel of the axis.

    linear W along +z travel -400 .. 0
    branch {
        lock W 50 mm         // W ends at 0
    }
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    draft.ruled.iter().filter_map(|ruled| report(draft, ruled)).collect()
}

fn report(draft: &Draft<'_>, ruled: &RuleDraft) -> Option<Diagnostic> {
    let name = &ruled.axis.value.value;
    let Some((_, axis)) = draft.axis(name) else {
        return (!draft.may_lack_axis(name)).then(|| unknown(draft, ruled));
    };
    match ruled.rule? {
        Rule::Locked(value) => beyond(draft, ruled, axis, value),
        Rule::Preferred(value) => needed(draft, ruled, axis).or_else(|| beyond(draft, ruled, axis, value)),
        Rule::Free => needed(draft, ruled, axis),
        Rule::Pose => None,
    }
}

fn unknown(draft: &Draft<'_>, ruled: &RuleDraft) -> Diagnostic {
    let name = &ruled.axis.value.value;
    let message = format!("the machine has no axis {name}");
    let error = super::error(draft, &NOT_SURPLUS, message, &ruled.axis.at, "unknown axis");
    match nearest(name, draft.axes.iter().map(|axis| axis.name.value.as_str())) {
        Some(meant) => error.suggest(Suggestion {
            text: format!("did you mean `{meant}`?"),
            place: draft.sources.place(&ruled.axis.at),
            replacement: meant.to_owned(),
        }),
        None => error,
    }
}

/// A rotary axis without which no two rotaries and three linear axes are left.
fn needed(draft: &Draft<'_>, ruled: &RuleDraft, axis: &AxisDraft) -> Option<Diagnostic> {
    let left = (draft.solved(Motion::Linear).len(), draft.solved(Motion::Rotary).len());
    if axis.motion == Motion::Linear || left.0 >= 3 && left.1 >= 2 || draft.may_lack_axes() {
        return None;
    }
    let message = format!("{} cannot be left open: a pose decides it", axis.name.value);
    let error = super::error(draft, &NOT_SURPLUS, message, &ruled.at, "");
    Some(error.note(format!("without it {} linear and {} rotary axes are left", left.0, left.1)))
}

fn beyond(draft: &Draft<'_>, ruled: &RuleDraft, axis: &AxisDraft, value: f64) -> Option<Diagnostic> {
    let travel = axis.travel.as_ref()?;
    let [lower, upper] = travel.value;
    if lower <= value && value <= upper {
        return None;
    }
    let message = format!("{} cannot stand at {}", axis.name.value, readable(value));
    let error = super::error(draft, &OUT_OF_TRAVEL, message, &ruled.at, "beyond its travel");
    Some(error.at(draft.sources.place(&travel.at), "its travel"))
}
