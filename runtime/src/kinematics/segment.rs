//! How far tip and tool axis leave their straight ways while every axis moves linearly: a bound that is proved, not sampled.
//!
//! Between two joint vectors every axis moves at its own constant rate. The tip then leaves the line between its ends by `e(t)`,
//! `t` from 0 to 1, with `e(0) = e(1) = 0`. The parabola through these two and `e(1/2)` is off by no more than
//! `|t (t - 1/2) (t - 1)| M3 / 6`, where `M3` bounds the third derivative; so
//!
//! > max|e| ≤ |e(1/2)| + √3/216 M3
//!
//! `M3` comes from the tool outwards through the joints, with bounds `M1`, `M2`, `M3` of the first three derivatives of a point:
//! a linear joint adds its motion to `M1`; a rotary joint that turns by `w`, with the point no farther than `ρ` from its axis,
//! makes `M1 + wρ`, `M2 + 2w M1 + w²ρ` and `M3 + 3w M2 + 3w² M1 + w³ρ` of them. Between the ends a point is no farther from an
//! axis than at the farther end, and an eighth of `M2` more.
//!
//! The same is true of the unit tool axis, which leaves the great circle between its ends, gone through evenly; that adds
//! the third derivative of the great circle, its angle cubed.

use crate::machine::{Chain, Joint, Motion};
use crate::vector::{Vec3, add, angle_rad, cross, norm, scale, sub};
use std::f64::consts::PI;

/// `√3/216`: the greatest of `t (t - 1/2) (t - 1) / 6` between 0 and 1.
const CUBIC: f64 = 0.008_018_753_738_744_802;

/// What is known at one place of the way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place<'j> {
    /// Of each axis, in the machine's order, in millimetres and degrees.
    pub joints: &'j [f64],
    /// Where the chain takes the tip, in millimetres.
    pub tip_mm: Vec3,
    /// Where the chain takes the unit tool axis.
    pub axis: Vec3,
}

/// How far the tool is off its straight way at most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// The tip from the line between its ends, gone along evenly, in millimetres.
    pub tip_mm: f64,
    /// The tool axis from the great circle between its ends, gone along evenly, in radians.
    pub axis_rad: f64,
}

/// How far the tool leaves its straight way between two places at most, given the pose half way between their joints. All
/// three poses are the chain's: without errors that depend on positions.
pub fn deviation(chain: &Chain, ends: [Place<'_>; 2], half_way: (Vec3, Vec3), tool_length_mm: f64) -> Deviation {
    let bounds = bounds(chain, ends, tool_length_mm);
    let [from, to] = ends;
    let (tip, axis) = half_way;
    let middle = scale(0.5, add(from.tip_mm, to.tip_mm));
    let (bisector, angle) = (add(from.axis, to.axis), angle_rad(from.axis, to.axis));
    let bisector = scale(1.0 / norm(bisector), bisector);
    let apart = norm(sub(axis, bisector)) + CUBIC * (bounds.axis.third + angle * angle * angle);
    Deviation {
        tip_mm: norm(sub(tip, middle)) + CUBIC * bounds.tip.third,
        // More than a diameter, or no number because the ends are opposite: any direction.
        axis_rad: if apart < 2.0 { 2.0 * libm::asin(apart / 2.0) } else { PI },
    }
}

/// Bounds of the first three derivatives of a vector.
#[derive(Debug, Clone, Copy, Default)]
struct Derivatives {
    first: f64,
    second: f64,
    third: f64,
}

impl Derivatives {
    /// Those behind a turn by an angle, for the vector's distances from the axis at both ends.
    fn turned(self, angle_rad: f64, distances: [f64; 2]) -> Self {
        let (Self { first, second, third }, w) = (self, angle_rad.abs());
        let distance = distances[0].max(distances[1]) + second / 8.0;
        Self {
            first: first + w * distance,
            second: second + w * (2.0 * first + w * distance),
            third: third + w * (3.0 * second + w * (3.0 * first + w * distance)),
        }
    }
}

struct Bounds {
    tip: Derivatives,
    axis: Derivatives,
}

/// From the tool outwards. The outermost rotary's distances are seen from the workpiece, as turning about it does not change
/// them: with two rotaries no angle needs a sine.
fn bounds(chain: &Chain, ends: [Place<'_>; 2], tool_length_mm: f64) -> Bounds {
    let mut bounds = Bounds { tip: Derivatives::default(), axis: Derivatives::default() };
    let mut poses = [(chain.tip_at_home(tool_length_mm), chain.tool_axis); 2];
    let mut rotaries = chain.joints.iter().filter(|joint| joint.motion == Motion::Rotary).count();
    for (place, joint) in chain.joints.iter().enumerate().rev() {
        let values = ends.map(|end| joint.signed(end.joints[joint.axis]));
        if joint.motion == Motion::Linear {
            bounds.tip.first += (values[1] - values[0]).abs();
            (0..2).for_each(|end| poses[end].0 = add(poses[end].0, scale(values[end], joint.direction)));
            continue;
        }
        rotaries -= 1;
        if rotaries == 0 {
            poses = ends.map(|end| (without(&chain.joints[..place], end), end.axis));
        }
        let angle_rad = (values[1] - values[0]).to_radians();
        let off = |vector: Vec3| norm(cross(joint.direction, vector));
        bounds.tip = bounds.tip.turned(angle_rad, poses.map(|(tip, _)| off(sub(tip, joint.point_mm))));
        bounds.axis = bounds.axis.turned(angle_rad, poses.map(|(_, axis)| off(axis)));
        if rotaries > 1 {
            (0..2).for_each(|end| poses[end] = joint.moved(values[end], poses[end]));
        }
    }
    bounds
}

/// The tip as it is before these linear joints move it.
fn without(linear: &[Joint], end: Place<'_>) -> Vec3 {
    let motion = |joint: &Joint| scale(joint.signed(end.joints[joint.axis]), joint.direction);
    linear.iter().fold(end.tip_mm, |tip, joint| sub(tip, motion(joint)))
}
