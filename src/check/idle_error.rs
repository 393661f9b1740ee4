//! A location error that moves no line.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::{Draft, ErrorDraft, Measured};
use mach_runtime::machine::{Component, Motion};
use nalgebra::Vector3;

/// An error without any effect on where its axis lies.
pub(crate) static IDLE: Code = Code {
    id: "E0320",
    title: "an error that cannot change where the axis lies",
    explanation: "\
The line of an axis is what it was when it is shifted along itself or turned about itself, and a linear axis has a
direction, but no place.

    error EZ0C 12 um        // C about z, shifted along z
    error EC0C 20 urad      // C about z, turned about z
    error EX0Y 4 um         // a linear axis has no place

A rotary axis about z has EX0C, EY0C, EA0C and EB0C; a linear one along z has EA0Z and EB0Z. Where an axis reads zero
belongs into its `travel` and into `zero`.
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    draft.errors.iter().filter_map(|error| report(draft, error)).collect()
}

fn report(draft: &Draft<'_>, error: &ErrorDraft) -> Option<Diagnostic> {
    let axis = &draft.axes[error.axis];
    let (Measured::Location(_), Some(line)) = (&error.measured, axis.unit()) else { return None };
    let works = |component: Component| {
        let along = Vector3::ith(component.direction(), 1.0);
        let has_place = axis.motion == Motion::Rotary || component.is_turn();
        has_place && line.cross(&along).norm() >= super::PARALLEL_SINE
    };
    if works(error.component) {
        return None;
    }
    let (name, error_name) = (&axis.name.value, &error.name.value);
    let label = match (axis.motion, error.component.is_turn()) {
        (Motion::Linear, false) => "a linear axis has no place",
        (_, true) => "a turn about the axis itself",
        (Motion::Rotary, false) => "a shift along the axis itself",
    };
    let others: Vec<String> =
        Component::ALL.into_iter().filter(|&c| works(c)).map(|c| format!("E{}0{name}", c.letter())).collect();
    let message = format!("{error_name} does not change where {name} lies");
    let diagnostic = super::error(draft, &IDLE, message, &error.name.at, label);
    Some(diagnostic.note(format!("the location errors of {name} are {}", others.join(", "))))
}
