//! The directions of a draft as they stand: what the checks of the geometry look at.

use crate::diagnostic::Diagnostic;
use crate::model::directions::{StandingJoint, standing};
use crate::model::draft::{AxisDraft, Draft};
use crate::model::quantity::readable;
use crate::syntax::tree::Link;
use mach_runtime::machine::{Motion, Rule};
use nalgebra::Vector3;

/// Where a surplus axis is tried, away from where it stands: a machine that lacks something at one angle lacks it there,
/// one that lacks it at another angle as well lacks it for good. Nothing about a machine repeats at this angle.
const ELSEWHERE_RAD: f64 = 1.0;

/// Directions, each `None` where it was not said rightly.
pub(super) struct Standing<'a> {
    axes: Vec<(&'a AxisDraft, Vector3<f64>)>,
    tool: Option<Vector3<f64>>,
}

impl Standing<'_> {
    /// An axis' direction.
    pub(super) fn of(&self, axis: &AxisDraft) -> Option<Vector3<f64>> {
        let known = self.axes.iter().find(|(known, _)| std::ptr::eq(*known, axis));
        known.map(|(_, direction)| *direction).or_else(|| axis.unit())
    }

    /// The tool's.
    pub(super) fn tool(&self) -> Option<Vector3<f64>> {
        self.tool
    }
}

/// Whether something is wrong wherever the surplus axes stand. Nobody knows of a draft that does not say how they stand.
pub(super) fn always(draft: &Draft<'_>, wrong: impl Fn(&Standing<'_>) -> bool) -> bool {
    is_known(draft) && wrong(&with(draft, 0.0)) && wrong(&with(draft, ELSEWHERE_RAD))
}

/// Whether everything is known that turns a direction.
fn is_known(draft: &Draft<'_>) -> bool {
    let chain = draft.knows_chain();
    let turns = |axis: &&AxisDraft| draft.ruled(axis).is_some();
    let is_known =
        |axis: &AxisDraft| draft.ruled(axis).is_some_and(|ruled| ruled.rule.is_some()) && axis.unit().is_some();
    draft.rotaries().filter(turns).all(|axis| chain && is_known(axis))
}

/// A finding, with where the axes stand that have a part in it.
pub(super) fn noted(draft: &Draft<'_>, diagnostic: Diagnostic) -> Diagnostic {
    let locked = draft.axes.iter().filter_map(|axis| match draft.ruled(axis)?.rule? {
        Rule::Locked(value) if axis.motion == Motion::Rotary => {
            Some(format!("{} at {} deg", axis.name.value, readable(value)))
        }
        _ => None,
    });
    let locked: Vec<String> = locked.collect();
    if locked.is_empty() { diagnostic } else { diagnostic.note(format!("so it is with {}", locked.join(" and "))) }
}

/// With the surplus rotaries so far away from where they stand.
fn with<'a>(draft: &'a Draft<'_>, away_rad: f64) -> Standing<'a> {
    let links = draft.chain.iter().flat_map(|chain| &chain.value);
    let mut joints: Vec<(&AxisDraft, StandingJoint)> = Vec::new();
    for link in links {
        let Link::Axis { name, primed } = link else { continue };
        let Some((_, axis)) = draft.axis(&name.value) else { continue };
        let stands_before = joints.iter().any(|(known, _)| std::ptr::eq(*known, axis));
        let Some(direction) = axis.unit().filter(|_| !stands_before) else { continue };
        let turn_rad = turn_rad(draft, axis, away_rad);
        joints.push((axis, StandingJoint { direction, turn_rad: if *primed { -turn_rad } else { turn_rad } }));
    }
    let (axes, joints): (Vec<_>, Vec<_>) = joints.into_iter().unzip();
    let tool = draft.tool.as_ref().and_then(|tool| tool.unit());
    let (directions, turned) = standing(&joints, &tool.unwrap_or_else(Vector3::zeros));
    Standing { axes: axes.into_iter().zip(directions).collect(), tool: tool.map(|_| turned) }
}

fn turn_rad(draft: &Draft<'_>, axis: &AxisDraft, away_rad: f64) -> f64 {
    match draft.ruled(axis).and_then(|ruled| ruled.rule) {
        _ if axis.motion == Motion::Linear => 0.0,
        Some(Rule::Locked(value)) => value.to_radians(),
        Some(Rule::Preferred(value)) => value.to_radians() + away_rad,
        Some(Rule::Free) => away_rad,
        Some(Rule::Pose) | None => 0.0,
    }
}
