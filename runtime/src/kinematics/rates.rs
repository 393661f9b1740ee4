//! How tip and tool axis move with each axis: the derivatives of the forward chain.
//!
//! Where a joint's line is while the joints before it stand where they do, an axis moves the tip along it, or about it. The
//! frame that takes lines there is turned on from joint to joint, from the workpiece to the tool; at its end it takes the
//! tool along.

use super::{JointBlock, LANES, Lane};
use crate::machine::{Chain, Motion, turned};
use crate::tool::ToolGeometry;
use crate::vector::{Vec3, add, cross, scale, sub};

/// How the tool moves with one axis, lane by lane.
#[derive(Debug, Clone, PartialEq)]
pub struct Rate {
    /// The tip, in millimetres for each millimetre or degree of the axis.
    pub tip: [Lane; 3],
    /// The unit tool axis, for each millimetre or degree of the axis.
    pub axis: [Lane; 3],
}

/// Where the joints before some joint have taken the machine frame.
#[derive(Debug, Clone, Copy)]
struct Frame {
    directions: [Vec3; 3],
    origin_mm: Vec3,
}

impl Rate {
    /// Nothing moves.
    pub const ZERO: Self = Self { tip: [[0.0; LANES]; 3], axis: [[0.0; LANES]; 3] };

    fn set(&mut self, lane: usize, tip: Vec3, axis: Vec3) {
        for i in 0..3 {
            self.tip[i][lane] = tip[i];
            self.axis[i][lane] = axis[i];
        }
    }
}

/// The rate of each axis, in the order of the machine, at each lane's joints: those of the chain, without errors that depend
/// on positions.
///
/// # Panics
/// When `out` is of another number of axes.
pub fn rates(chain: &Chain, joints: &JointBlock, tool: ToolGeometry, out: &mut [Rate]) {
    assert_eq!(out.len(), chain.joints.len(), "there is a rate for each axis");
    let mut lines = vec![([0.0; 3], [0.0; 3]); chain.joints.len()];
    (0..LANES).for_each(|lane| {
        let (tip, axis) = follow(chain, |axis| joints[axis][lane], tool, &mut lines);
        for (joint, &(direction, point_mm)) in chain.joints.iter().zip(&lines) {
            let rate = &mut out[joint.axis];
            match joint.motion {
                Motion::Linear => rate.set(lane, scale(joint.signed(1.0), direction), [0.0; 3]),
                Motion::Rotary => {
                    let turn = scale(joint.signed(1.0_f64.to_radians()), direction);
                    rate.set(lane, cross(turn, sub(tip, point_mm)), cross(turn, axis));
                }
            }
        }
    });
}

/// Where the line of each joint is, as direction and point; then tip and tool axis.
fn follow(chain: &Chain, value: impl Fn(usize) -> f64, tool: ToolGeometry, lines: &mut [(Vec3, Vec3)]) -> (Vec3, Vec3) {
    let mut frame = Frame::MACHINE;
    for (joint, line) in chain.joints.iter().zip(lines) {
        let value = joint.signed(value(joint.axis));
        *line = (frame.direction(joint.direction), frame.point(joint.point_mm));
        frame = match joint.motion {
            Motion::Linear => frame.shifted(scale(value, line.0)),
            Motion::Rotary => frame.turned(*line, libm::sincos(value.to_radians())),
        };
    }
    (frame.point(chain.tip_at_home(tool)), frame.direction(chain.tool_axis))
}

impl Frame {
    const MACHINE: Self = Self { directions: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin_mm: [0.0; 3] };

    fn direction(&self, v: Vec3) -> Vec3 {
        let [x, y, z] = self.directions;
        add(scale(v[0], x), add(scale(v[1], y), scale(v[2], z)))
    }

    fn point(&self, point_mm: Vec3) -> Vec3 {
        add(self.origin_mm, self.direction(point_mm))
    }

    fn shifted(self, by_mm: Vec3) -> Self {
        Self { origin_mm: add(self.origin_mm, by_mm), ..self }
    }

    /// Turned about a line by an angle with this sine and cosine.
    fn turned(self, (direction, point_mm): (Vec3, Vec3), turn: (f64, f64)) -> Self {
        let from_line = turned(direction, turn, sub(self.origin_mm, point_mm));
        Self { directions: self.directions.map(|v| turned(direction, turn, v)), origin_mm: add(point_mm, from_line) }
    }
}
