//! A direction of no length.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::{Draft, unit};

/// A vector that points nowhere.
pub(crate) static NO_DIRECTION: Code = Code {
    id: "E0301",
    title: "a direction of length zero",
    explanation: "\
The direction of an axis or of the tool is a vector of any length but zero; machc makes it a unit vector.

    rotary B about (0, 0, 0)             // points nowhere
    rotary B about (0, -1, 1)            // 45 degrees between -y and +z
    linear X along x - x                 // points nowhere
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    let axes = draft.axes.iter().map(|axis| (axis.name.value.as_str(), &axis.direction));
    let tool = draft.tool.iter().map(|tool| ("the tool", &tool.along));
    let directions = axes.chain(tool).filter_map(|(name, direction)| Some((name, direction.as_ref()?)));
    let without = directions.filter(|(_, direction)| unit(&direction.value).is_none());
    let report = |(name, direction): (&str, &crate::model::source::Located<_>)| {
        let message = format!("the direction of {name} has no length");
        super::error(draft, &NO_DIRECTION, message, &direction.at, "points nowhere")
    };
    without.map(report).collect()
}
