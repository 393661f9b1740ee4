//! Linear axes that do not reach every point of space.

use super::PARALLEL_SINE;
use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::{AxisDraft, Draft};
use mach_runtime::machine::Motion;

/// Linear axes in one plane.
pub(crate) static NO_SPACE: Code = Code {
    id: "E0304",
    title: "the linear axes do not span space",
    explanation: "\
Three linear axes move the tool to every point only if their directions do not lie in one plane. They need not be
perpendicular.

    linear X along +x
    linear Y along +y
    linear Z along +y        // +z was meant
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    let linear: Vec<_> = draft.axes.iter().filter(|axis| axis.motion == Motion::Linear).collect();
    let [a, b, c] = linear[..] else { return Vec::new() };
    let parallel = [[a, b], [a, c], [b, c]].into_iter().find(are_parallel);
    if let Some([one, other]) = parallel {
        let message = format!("{} and {} are parallel", one.name.value, other.name.value);
        return vec![report(draft, message, &[other, one])];
    }
    let (Some(l1), Some(l2), Some(l3)) = (a.unit(), b.unit(), c.unit()) else { return Vec::new() };
    if l1.dot(&l2.cross(&l3)).abs() > PARALLEL_SINE {
        return Vec::new();
    }
    let message = format!("{}, {} and {} lie in one plane", a.name.value, b.name.value, c.name.value);
    vec![report(draft, message, &[c, b, a])]
}

fn are_parallel(pair: &[&AxisDraft; 2]) -> bool {
    let [Some(a), Some(b)] = pair.map(AxisDraft::unit) else { return false };
    a.cross(&b).norm() <= PARALLEL_SINE
}

fn report(draft: &Draft<'_>, what: String, axes: &[&AxisDraft]) -> Diagnostic {
    let message = format!("{what}: the linear axes do not reach every point");
    axes.iter().fold(Diagnostic::error(&NO_SPACE, message), |diagnostic, axis| match &axis.direction {
        Some(direction) => diagnostic.at(draft.sources.place(&direction.at), axis.name.value.as_str()),
        None => diagnostic,
    })
}
