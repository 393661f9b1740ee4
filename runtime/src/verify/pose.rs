//! Where joints take the tool.

use crate::certificate::Deviation;
use crate::compensation::Compensated;
use crate::kinematics::{JointBlock, Kinematics, LANES, Lane, Outcome, PoseBlock, SolutionBlock, Tolerances};
use crate::machine::{Axis, Machine, Motion as AxisMotion, Rule};
use crate::motion::{Item, Motion, What};
use crate::vector::{Vec3, angle_rad, norm, sub};

/// Tip in millimetres and unit tool axis, in the machine frame with every axis at zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pose {
    /// The tip.
    pub(crate) tip_mm: Vec3,
    /// The tool axis.
    pub(crate) axis: Vec3,
}

impl Pose {
    /// How far it is from the wanted one.
    #[inline]
    pub(super) fn deviation(self, wanted: Self) -> Deviation {
        Deviation::new([wanted.tip_mm, wanted.axis], [self.tip_mm, self.axis])
    }

    /// The distance of the tips in millimetres, and the angle of the axes in radians.
    pub(super) fn apart(self, other: Self) -> (f64, f64) {
        (norm(sub(self.tip_mm, other.tip_mm)), angle_rad(self.axis, other.axis))
    }
}

/// The machine both ways, pose by pose.
pub(crate) struct Solver<'m, K> {
    machine: &'m Machine,
    kinematics: Compensated<'m, K>,
    joints: JointBlock,
    poses: PoseBlock,
    solutions: SolutionBlock,
}

impl<'m, K: Kinematics> Solver<'m, K> {
    pub(crate) fn new(machine: &'m Machine, kinematics: K) -> Self {
        let solutions = SolutionBlock::of(&kinematics);
        Self {
            machine,
            kinematics: Compensated::new(kinematics, machine),
            joints: vec![[0.0; LANES]; machine.axes.len()],
            poses: PoseBlock::ZERO,
            solutions,
        }
    }

    /// Where the tool is behind each item of a motion that begins at a pose, as far as every axis is known.
    pub(crate) fn poses(&mut self, motion: &Motion, mut at: Option<Pose>, out: &mut Vec<Option<Pose>>) {
        let all = (1 << motion.axes()) - 1;
        let known = |item: &Item| match &item.what {
            What::Move(it) => Some((it.known == all).then_some(it.joints)),
            What::Event(_) => None,
        };
        out.clear();
        for items in motion.items().chunks(LANES) {
            let moves = items.iter().enumerate().filter_map(|(lane, item)| known(item).flatten().map(|at| (lane, at)));
            for (lane, joints) in moves {
                self.set_joints(lane, motion.joints_at(joints));
            }
            self.kinematics.forward(&self.joints, self.machine.tool(), &mut self.poses);
            for (lane, item) in items.iter().enumerate() {
                let pose = Pose { tip_mm: self.poses.tip(lane), axis: self.poses.axis(lane) };
                at = known(item).map_or(at, |known| known.map(|_| pose));
                out.push(at);
            }
        }
    }

    /// Where joints take the tool, lane by lane.
    pub(crate) fn forward(&mut self, joints: &JointBlock, poses: &mut PoseBlock) {
        self.kinematics.forward(joints, self.machine.tool(), poses);
    }

    fn set_joints(&mut self, lane: usize, joints: &[f64]) {
        self.joints.iter_mut().zip(joints).for_each(|(lanes, joint)| lanes[lane] = *joint);
    }

    /// Solves for up to [`LANES`] poses, near these joints where the pose leaves some of them open.
    pub(super) fn solve<'j>(&mut self, points: impl Iterator<Item = (Pose, &'j [f64])>) {
        for (lane, (pose, joints)) in points.enumerate() {
            self.poses.set(lane, pose.tip_mm, pose.axis);
            self.set_joints(lane, joints);
        }
        let Self { machine, kinematics, poses, solutions, joints, .. } = self;
        let surplus: Vec<Lane> = kinematics.surplus_axes().iter().map(|&axis| joints[axis]).collect();
        kinematics.inverse(poses, &surplus, machine.tool(), solutions);
    }

    /// How far joints are from the nearest solution of a lane, axis by axis in millimetres and degrees; false where the machine has
    /// none for its pose.
    pub(super) fn off(&mut self, lane: usize, pose: Pose, joints: &[f64], out: &mut Vec<f64>) -> bool {
        let Self { machine, solutions, .. } = self;
        let tolerances = Tolerances { axis_rad: machine.axis_tolerance_rad, plane_mm: machine.plane_tolerance_mm };
        out.clear();
        match solutions.outcome(lane, tolerances) {
            Outcome::Reached => {}
            Outcome::FreeAtPole { .. } => return self.off_at_pole(pose, joints, out),
            Outcome::Missed(_) => return false,
        }
        let off = |branch: &'_ JointBlock, axis: usize| apart(&machine.axes[axis], joints[axis], branch[axis][lane]);
        let greatest = |branch: &JointBlock| (0..joints.len()).map(|axis| off(branch, axis)).fold(0.0, f64::max);
        let nearest = solutions.branches.iter().min_by(|a, b| greatest(a).total_cmp(&greatest(b)));
        out.extend(nearest.into_iter().flat_map(|branch| (0..joints.len()).map(move |axis| off(branch, axis))));
        !out.is_empty()
    }

    /// With an axis that is free, the linear axes follow it.
    fn off_at_pole(&mut self, pose: Pose, joints: &[f64], out: &mut Vec<f64>) -> bool {
        let mut solved = joints.to_vec();
        if self.kinematics.position(pose.tip_mm, self.machine.tool(), &mut solved).is_err() {
            return false;
        }
        let axes = self.machine.axes.iter().zip(joints).zip(&solved);
        out.extend(axes.map(|((axis, found), solved)| apart(axis, *found, *solved)));
        true
    }
}

/// How far a joint value is from another, whole turns aside.
fn apart(axis: &Axis, a: f64, b: f64) -> f64 {
    let off = a - b;
    match (axis.motion, axis.rule) {
        (_, Rule::Locked(value)) => (a - value).abs(),
        (AxisMotion::Linear, _) => off.abs(),
        (AxisMotion::Rotary, _) => (off - 360.0 * (off / 360.0).round()).abs(),
    }
}
