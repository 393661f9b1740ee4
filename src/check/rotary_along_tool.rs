//! A rotary axis, the nearest to the tool, that turns about the tool.

use super::{PARALLEL_SINE, standing};
use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::{AxisDraft, Draft};
use mach_runtime::machine::Motion;

/// A rotary axis that cannot tilt the tool.
pub(crate) static ALONG_TOOL: Code = Code {
    id: "E0303",
    title: "a rotary axis turns about the tool",
    explanation: "\
Of the rotary axes, the one nearest to the tool in the chain must not turn about the tool itself: turning it changes
nothing in the direction of the tool, and with two rotary axes only one of them is left to tilt it.

    chain w A C b X Y Z t
    rotary A about +x
    rotary C about +z        // the last rotary axis before the tool
    tool along +z            // and the tool is along it

Often the order in the chain is wrong: on a trunnion table, C carries the workpiece and A carries C: `chain w C A b …`.
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    let joints = draft.links().filter_map(|name| draft.axis(&name.value));
    let is_solved = |axis: &AxisDraft| axis.motion == Motion::Rotary && draft.ruled(axis).is_none();
    let rotary: Vec<(usize, &AxisDraft)> = joints.filter(|(_, axis)| is_solved(axis)).collect();
    let once = |index: usize| rotary.iter().filter(|(other, _)| *other == index).count() == 1;
    let (Some((index, last)), Some(tool)) = (rotary.last(), &draft.tool) else { return Vec::new() };
    let (Some(direction), Some(along)) = (&last.direction, &tool.along) else { return Vec::new() };
    let turns_about_it = |standing: &standing::Standing<'_>| match (standing.of(last), standing.tool()) {
        (Some(n), Some(t)) => n.cross(&t).norm() <= PARALLEL_SINE,
        _ => false,
    };
    // With two linear axes that is how it should be: the rotary turns the point to where they reach it.
    let is_planar = draft.solved(Motion::Linear).len() == 2;
    if !draft.knows_chain()
        || !draft.knows_solved()
        || !once(*index)
        || is_planar
        || !standing::always(draft, turns_about_it)
    {
        return Vec::new();
    }
    let message = format!("{} turns about the tool: it cannot tilt it", last.name.value);
    let diagnostic = super::error(draft, &ALONG_TOOL, message, &direction.at, "along the tool")
        .at(draft.sources.place(&along.at), "the tool")
        .note(format!("{} is the last rotary axis of the chain before the tool", last.name.value));
    vec![standing::noted(draft, diagnostic)]
}
