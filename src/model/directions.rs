//! Directions as they stand: turned by the rotary axes that the pose does not decide, the others at zero.

use super::machine::{Model, ModelAxis, ModelJoint};
use crate::plan::{cos_constant, sin_constant};
use mach_runtime::machine::{Motion, Rule};
use nalgebra::Vector3;

/// Along a line: with a smaller sine between a rotary axis and the tool, a machine with two linear axes is one whose rotary
/// turns about the tool. A measured one may be a little off.
pub(crate) const ALONG_SINE: f64 = 0.02;

/// One joint of a chain, from the workpiece to the tool.
pub(crate) struct StandingJoint {
    /// Its unit direction with every axis at zero.
    pub(crate) direction: Vector3<f64>,
    /// How far it turns what it carries; zero for a linear joint and for one that the pose decides.
    pub(crate) turn_rad: f64,
}

/// The directions of all joints and of the tool, as they stand.
pub(crate) fn standing(chain: &[StandingJoint], tool: &Vector3<f64>) -> (Vec<Vector3<f64>>, Vector3<f64>) {
    let (mut directions, mut tool) = (Vec::with_capacity(chain.len()), *tool);
    for joint in chain.iter().rev() {
        if joint.turn_rad != 0.0 {
            directions.iter_mut().chain([&mut tool]).for_each(|v| *v = turned(v, joint));
        }
        directions.push(joint.direction);
    }
    directions.reverse();
    (directions, tool)
}

/// A vector behind a joint (Rodrigues).
fn turned(v: &Vector3<f64>, StandingJoint { direction: n, turn_rad }: &StandingJoint) -> Vector3<f64> {
    let (sine, cosine) = (sin_constant(*turn_rad), cos_constant(*turn_rad));
    v * cosine + n.cross(v) * sine + n * n.dot(v) * (1.0 - cosine)
}

/// Where an axis stands, in millimetres or degrees: at zero if the pose decides it, and as near to that as it can if free.
pub(crate) fn value(axis: &ModelAxis) -> f64 {
    match axis.rule {
        Rule::Pose => 0.0,
        Rule::Locked(value) | Rule::Preferred(value) => value,
        Rule::Free => 0.0_f64.clamp(axis.travel.lower, axis.travel.upper),
    }
}

/// The directions of a machine's joints, in the order of the chain, and of its tool.
pub(crate) fn of_model(model: &Model) -> (Vec<Vector3<f64>>, Vector3<f64>) {
    let joint = |joint: &ModelJoint| {
        let axis = &model.axes[joint.axis];
        let value = if axis.motion == Motion::Rotary { value(axis) } else { 0.0 };
        StandingJoint {
            direction: model.line(joint.axis).direction,
            turn_rad: if joint.primed { -value } else { value }.to_radians(),
        }
    };
    standing(&model.chain.iter().map(joint).collect::<Vec<_>>(), &model.tool.axis)
}
