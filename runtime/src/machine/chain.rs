//! The chain of a machine: its joints in the machine frame with every axis at zero, from the workpiece to the tool.
//!
//! Where the tool is in the workpiece is the product of the joints' motions: each moves what is on the tool's side of it along
//! or about its own line, and the lines are where they are with every axis at zero.

use super::{Motion, ToolGeometry};
use crate::vector::{Vec3, add, cross, dot, scale, sub};

/// The joints of a machine, and its tool.
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    /// From the workpiece to the tool: every axis once.
    pub joints: Vec<Joint>,
    /// How many of them carry the workpiece: those before the bed.
    pub bed: usize,
    /// The tool axis with every axis at zero, from the tip to the spindle; a unit vector.
    pub tool_axis: Vec3,
    /// The gauge point with every axis at zero, in millimetres.
    pub gauge_mm: Vec3,
}

/// An axis in its place of the chain.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Index into [`super::Machine::axes`].
    pub axis: usize,
    /// How it moves.
    pub motion: Motion,
    /// Its unit direction.
    pub direction: Vec3,
    /// A point on the line of a rotary axis, in millimetres; the origin for a linear one.
    pub point_mm: Vec3,
    /// Whether its positive sense is the workpiece's motion (ISO 841), so that it moves the tool the other way.
    pub primed: bool,
}

impl Chain {
    /// The tip with every axis at zero, in millimetres.
    pub fn tip_at_home(&self, tool: ToolGeometry) -> Vec3 {
        sub(self.gauge_mm, scale(tool.length_mm, self.tool_axis))
    }

    /// Tip (in millimetres) and unit tool axis for joint values in millimetres and degrees, in the order of the machine's
    /// axes: the machine as it is without errors that depend on positions.
    pub fn pose(&self, joints: &[f64], tool: ToolGeometry) -> (Vec3, Vec3) {
        let home = (self.tip_at_home(tool), self.tool_axis);
        self.joints.iter().rev().fold(home, |pose, joint| joint.moved(joint.signed(joints[joint.axis]), pose))
    }
}

impl Joint {
    /// How far the tool's side moves for a value of the axis.
    pub fn signed(&self, value: f64) -> f64 {
        if self.primed { -value } else { value }
    }

    /// Tip (in millimetres) and tool axis, moved by this much: millimetres or degrees, [`Self::signed`].
    pub fn moved(&self, by: f64, (tip, axis): (Vec3, Vec3)) -> (Vec3, Vec3) {
        match self.motion {
            Motion::Linear => (add(tip, scale(by, self.direction)), axis),
            Motion::Rotary => {
                let turn = libm::sincos(by.to_radians());
                let turned = |v| turned(self.direction, turn, v);
                (add(self.point_mm, turned(sub(tip, self.point_mm))), turned(axis))
            }
        }
    }
}

/// A vector turned about a direction by an angle with this sine and cosine.
pub(crate) fn turned(n: Vec3, (sine, cosine): (f64, f64), v: Vec3) -> Vec3 {
    let along = scale(dot(n, v), n);
    add(along, add(scale(cosine, sub(v, along)), scale(sine, cross(n, v))))
}
