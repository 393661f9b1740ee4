//! Linear axes that do not reach every point of space.

use super::{PARALLEL_SINE, standing};
use crate::diagnostic::{Code, Diagnostic};
use crate::model::directions::ALONG_SINE;
use crate::model::draft::{AxisDraft, Draft};
use mach_runtime::machine::Motion;

/// Linear axes in one plane.
pub(crate) static NO_SPACE: Code = Code {
    id: "E0304",
    title: "the linear axes do not span space",
    explanation: "\
Three linear axes move the tool to every point only if their directions do not lie in one plane. They need not be
perpendicular. Two move it in a plane, and a rotary axis turns every point into it only if it does not turn about the
normal of that plane.

    linear X along +x
    linear Y along +y
    linear Z along +y        // +z was meant
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    if !draft.knows_solved() {
        return Vec::new();
    }
    let linear = draft.solved(Motion::Linear);
    let pairs = linear.iter().enumerate().flat_map(|(i, one)| linear[i + 1..].iter().map(move |other| [*one, *other]));
    let parallel = pairs.filter(|_| linear.len() <= 3).find(|pair| are_parallel(draft, *pair));
    if let Some([one, other]) = parallel {
        let message = format!("{} and {} are parallel", one.name.value, other.name.value);
        return vec![report(draft, message, &[other, one])];
    }
    match (&linear[..], &draft.solved(Motion::Rotary)[..]) {
        (&[a, b, c], _) if are_flat(draft, [a, b, c]) => {
            let message = format!("{}, {} and {} lie in one plane", a.name.value, b.name.value, c.name.value);
            vec![report(draft, message, &[c, b, a])]
        }
        (&[a, b], &[rotary]) if turns_in_their_plane(draft, [a, b, rotary]) => {
            let (a_name, b_name, name) = (&a.name.value, &b.name.value, &rotary.name.value);
            let message =
                format!("{name} turns in the plane of {a_name} and {b_name}, and does not make up for a third");
            vec![report(draft, message, &[rotary, b, a])]
        }
        _ => Vec::new(),
    }
}

fn are_parallel(draft: &Draft<'_>, [a, b]: [&AxisDraft; 2]) -> bool {
    standing::always(draft, |standing| match (standing.of(a), standing.of(b)) {
        (Some(a), Some(b)) => a.cross(&b).norm() <= PARALLEL_SINE,
        _ => false,
    })
}

fn are_flat(draft: &Draft<'_>, [a, b, c]: [&AxisDraft; 3]) -> bool {
    standing::always(draft, |standing| match (standing.of(a), standing.of(b), standing.of(c)) {
        (Some(a), Some(b), Some(c)) => a.dot(&b.cross(&c)).abs() <= PARALLEL_SINE,
        _ => false,
    })
}

/// Whether a rotary axis that turns about the tool is the normal of two linear axes.
fn turns_in_their_plane(draft: &Draft<'_>, [a, b, rotary]: [&AxisDraft; 3]) -> bool {
    standing::always(draft, |standing| match (standing.of(a), standing.of(b), standing.of(rotary), standing.tool()) {
        (Some(a), Some(b), Some(n), Some(tool)) => {
            let normal = a.cross(&b).normalize();
            n.cross(&tool).norm() < ALONG_SINE && n.cross(&normal).norm() <= PARALLEL_SINE
        }
        _ => false,
    })
}

fn report(draft: &Draft<'_>, what: String, axes: &[&AxisDraft]) -> Diagnostic {
    let message = format!("{what}: the linear axes do not reach every point");
    let error = standing::noted(draft, Diagnostic::error(&NO_SPACE, message));
    axes.iter().fold(error, |diagnostic, axis| match &axis.direction {
        Some(direction) => diagnostic.at(draft.sources.place(&direction.at), axis.name.value.as_str()),
        None => diagnostic,
    })
}
