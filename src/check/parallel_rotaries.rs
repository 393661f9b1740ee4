//! Two rotary axes that turn about the same direction.

use super::{PARALLEL_SINE, standing};
use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::Draft;
use mach_runtime::machine::Motion;

/// Parallel rotary axes.
pub(crate) static PARALLEL: Code = Code {
    id: "E0302",
    title: "the rotary axes are parallel",
    explanation: "\
Two rotary axes point the tool in every direction only if they turn about different directions. Parallel ones add up to
one: the tool can be turned about that direction, and tilted no other way.

    rotary A about +x
    rotary C about +x        // +z was meant
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    let [first, second] = draft.solved(Motion::Rotary)[..] else { return Vec::new() };
    let are_parallel = |standing: &standing::Standing<'_>| match (standing.of(first), standing.of(second)) {
        (Some(n1), Some(n2)) => n1.cross(&n2).norm() <= PARALLEL_SINE,
        _ => false,
    };
    if !draft.knows_solved() || !standing::always(draft, are_parallel) {
        return Vec::new();
    }
    let (first_name, second_name) = (&first.name.value, &second.name.value);
    let message = format!("{first_name} and {second_name} are parallel: the tool axis can only be tilted in one plane");
    let diagnostic = [second, first].into_iter().fold(Diagnostic::error(&PARALLEL, message), |diagnostic, axis| {
        match &axis.direction {
            Some(direction) => diagnostic.at(draft.sources.place(&direction.at), axis.name.value.as_str()),
            None => diagnostic,
        }
    });
    vec![standing::noted(draft, diagnostic)]
}
