//! More or fewer axes than machc can solve today.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::{AxisDraft, Draft};
use mach_runtime::machine::Motion;

/// A number of axes that is not supported.
pub(crate) static NOT_SUPPORTED: Code = Code {
    id: "E0306",
    title: "this number of axes is not supported yet",
    explanation: "\
machc solves machines with three linear axes and none, one or two rotary axes, in any order and in any direction.

Not supported yet: two linear axes (a turning centre without Y), a fourth linear axis (a quill W beside Z), a third
rotary axis (a mill-turn with a tilting head and a second table). Leave out an axis that stands still in the programs
you post, and put its position into the points of the others.
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    if draft.axes.is_empty() {
        return Vec::new();
    }
    let of = |motion: Motion| draft.axes.iter().filter(|axis| axis.motion == motion).collect::<Vec<_>>();
    let (linear, rotary) = (of(Motion::Linear), of(Motion::Rotary));
    let mut found = Vec::new();
    if linear.len() < 3 {
        let message = format!("{} linear {} not supported yet: it takes three", linear.len(), are(linear.len()));
        let diagnostic = super::error(draft, &NOT_SUPPORTED, message, &draft.name.at, "");
        found.push(marked(draft, diagnostic, &linear));
    }
    if let Some(fourth) = linear.get(3) {
        found.push(too_many(draft, fourth, "a fourth linear axis"));
    }
    if let Some(third) = rotary.get(2) {
        found.push(too_many(draft, third, "a third rotary axis"));
    }
    found
}

fn are(count: usize) -> &'static str {
    if count == 1 { "axis is" } else { "axes are" }
}

fn marked(draft: &Draft<'_>, diagnostic: Diagnostic, axes: &[&AxisDraft]) -> Diagnostic {
    axes.iter().fold(diagnostic, |diagnostic, axis| diagnostic.at(draft.sources.place(&axis.name.at), ""))
}

fn too_many(draft: &Draft<'_>, axis: &AxisDraft, what: &str) -> Diagnostic {
    let message = format!("{} is {what}, which is not supported yet", axis.name.value);
    super::error(draft, &NOT_SUPPORTED, message, &axis.name.at, what)
}
