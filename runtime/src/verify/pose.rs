//! Where joints take the tool.

use crate::compensation::Compensated;
use crate::kinematics::{JointBlock, Kinematics, LANES, Lane, Outcome, PoseBlock, SolutionBlock, Tolerances};
use crate::machine::{Axis, Machine, Motion, Rule};
use crate::vector::{Vec3, angle_rad, norm, sub};

/// Tip in millimetres and unit tool axis, in the machine frame with every axis at zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pose {
    /// The tip.
    pub(super) tip_mm: Vec3,
    /// The tool axis.
    pub(super) axis: Vec3,
}

impl Pose {
    /// The distance of the tips in millimetres, and the angle of the axes in radians.
    pub(super) fn apart(self, other: Self) -> (f64, f64) {
        (norm(sub(self.tip_mm, other.tip_mm)), angle_rad(self.axis, other.axis))
    }
}

/// The machine both ways, pose by pose.
pub(super) struct Solver<'m> {
    machine: &'m Machine,
    kinematics: Compensated<'m, &'m mut dyn Kinematics>,
    joints: JointBlock,
    poses: PoseBlock,
    solutions: SolutionBlock,
}

impl<'m> Solver<'m> {
    pub(super) fn new(machine: &'m Machine, kinematics: &'m mut dyn Kinematics) -> Self {
        let solutions = SolutionBlock::of(kinematics);
        Self {
            machine,
            kinematics: Compensated::new(kinematics, machine),
            joints: vec![[0.0; LANES]; machine.axes.len()],
            poses: PoseBlock::ZERO,
            solutions,
        }
    }

    /// The pose at these joints.
    pub(super) fn pose(&mut self, joints: &[f64]) -> Pose {
        if self.machine.errors.is_empty() {
            let (tip_mm, axis) = self.machine.chain.pose(joints, self.machine.tool());
            return Pose { tip_mm, axis };
        }
        self.joints.iter_mut().zip(joints).for_each(|(lanes, joint)| *lanes = [*joint; LANES]);
        self.kinematics.forward(&self.joints, self.machine.tool(), &mut self.poses);
        Pose { tip_mm: self.poses.tip(0), axis: self.poses.axis(0) }
    }

    /// How far joints are from the nearest solution for a pose, axis by axis in millimetres and degrees; `None` where the machine
    /// has none.
    pub(super) fn off(&mut self, pose: Pose, joints: &[f64]) -> Option<Vec<f64>> {
        let Self { machine, kinematics, poses, solutions, .. } = self;
        (0..LANES).for_each(|lane| poses.set(lane, pose.tip_mm, pose.axis));
        let surplus: Vec<Lane> = kinematics.surplus_axes().iter().map(|&axis| [joints[axis]; LANES]).collect();
        kinematics.inverse(poses, &surplus, machine.tool(), solutions);
        let tolerances = Tolerances { axis_rad: machine.axis_tolerance_rad, plane_mm: machine.plane_tolerance_mm };
        match solutions.outcome(0, tolerances) {
            Outcome::Reached => {}
            Outcome::FreeAtPole { .. } => return self.off_at_pole(pose, joints),
            Outcome::Missed(_) => return None,
        }
        let off = |branch: &JointBlock| -> Vec<f64> {
            let axes = machine.axes.iter().zip(joints).zip(branch);
            axes.map(|((axis, found), solved)| apart(axis, *found, solved[0])).collect()
        };
        let greatest = |off: &Vec<f64>| off.iter().copied().fold(0.0, f64::max);
        solutions.branches.iter().map(off).min_by(|a, b| greatest(a).total_cmp(&greatest(b)))
    }
}

impl Solver<'_> {
    /// With an axis that is free, the linear axes follow it.
    fn off_at_pole(&mut self, pose: Pose, joints: &[f64]) -> Option<Vec<f64>> {
        let mut solved = joints.to_vec();
        self.kinematics.position(pose.tip_mm, self.machine.tool(), &mut solved).ok()?;
        let axes = self.machine.axes.iter().zip(joints).zip(&solved);
        Some(axes.map(|((axis, found), solved)| apart(axis, *found, *solved)).collect())
    }
}

/// How far a joint value is from another, whole turns aside.
fn apart(axis: &Axis, a: f64, b: f64) -> f64 {
    let off = a - b;
    match (axis.motion, axis.rule) {
        (_, Rule::Locked(value)) => (a - value).abs(),
        (Motion::Linear, _) => off.abs(),
        (Motion::Rotary, _) => (off - 360.0 * (off / 360.0).round()).abs(),
    }
}
