//! Compensation of errors that depend on where the axes are: a fixed point around the closed form.
//!
//! The closed form solves the machine as it should be. Where the machine with its errors would then stand differs a
//! little from that; the pose that is asked of the closed form is moved by this difference the other way, and again, until
//! nothing changes. An error of 10 µm and 20 µrad shrinks by about a thousand each time.

use crate::error_table::ErrorTable;
use crate::kinematics::{JointBlock, Kinematics, LANES, Lane, PoseBlock, SolutionBlock};
use crate::machine::{Machine, Motion};
use crate::vector::{Vec3, add, angle_rad, cross, dot, norm, scale, sub};

/// Two poses closer than this are the same: a tenth of what a machine is proved to.
const SETTLED_MM: f64 = 1e-10;
/// See [`SETTLED_MM`].
const SETTLED_RAD: f64 = 1e-13;

/// A tip farther off than this when the iteration ends is not compensated.
const TIP_BOUND_MM: f64 = 1e-9;

/// No more than so many corrections: errors that a machine tool has take three or four.
const MOST_CORRECTIONS: usize = 16;

/// Where turning the tool by some angle takes a rotary axis through more than so many times that angle (next to a pole, or
/// to the edge of the reach), its own errors' turn is not worth the motion: the rotary axes stay where they are without
/// errors, and only the tip is compensated.
const MOST_GAIN: f64 = 100.0;

/// Kinematics of a machine with its error tables, around those of the machine as it should be. Without tables it does what
/// the kinematics inside does.
#[derive(Debug)]
pub struct Compensated<'m, K> {
    inner: K,
    machine: &'m Machine,
    solutions: SolutionBlock,
    deviations: Vec<Lane>,
    most_corrections: usize,
}

/// Where joints take the tool: as it should be, and as it is.
struct Stand {
    ideal: PoseBlock,
    actual: PoseBlock,
}

impl<'m, K: Kinematics> Compensated<'m, K> {
    /// The kinematics of `machine` around the closed form.
    pub fn new(inner: K, machine: &'m Machine) -> Self {
        let (branches, axes) = (inner.branch_count(), inner.axis_count());
        Self {
            inner,
            machine,
            solutions: SolutionBlock::new(branches, axes),
            deviations: vec![[0.0; LANES]; machine.errors.len()],
            most_corrections: 0,
        }
    }

    /// The greatest number of corrections that any block has taken.
    pub fn most_corrections(&self) -> usize {
        self.most_corrections
    }

    fn is_ideal(&self) -> bool {
        self.machine.errors.is_empty()
    }

    fn actual(&mut self, joints: &JointBlock, tool_length_mm: f64, out: &mut PoseBlock) {
        let Self { inner, machine, deviations, .. } = self;
        for (lane, table) in deviations.iter_mut().zip(&machine.errors) {
            *lane = deviation(table, machine, &joints[table.axis]);
        }
        inner.forward_actual(joints, deviations, tool_length_mm, out);
    }

    fn stand(&mut self, joints: &JointBlock, tool_length_mm: f64) -> Stand {
        let mut stand = Stand { ideal: PoseBlock::ZERO, actual: PoseBlock::ZERO };
        self.inner.forward(joints, tool_length_mm, &mut stand.ideal);
        self.actual(joints, tool_length_mm, &mut stand.actual);
        stand
    }

    /// Moves one candidate, given without errors, to where the errors take the tool to the wanted poses.
    fn settle(
        &mut self,
        branch: usize,
        wanted: &PoseBlock,
        surplus: &[Lane],
        tool_length_mm: f64,
        joints: &mut JointBlock,
    ) {
        let without = joints.clone();
        let mut asked = wanted.clone();
        let mut keeps_angles = [false; LANES];
        for correction in 0.. {
            let stand = self.stand(joints, tool_length_mm);
            let next = stand.correct(wanted, &keeps_angles);
            let settled = (0..LANES).all(|lane| is_settled(&asked, &next, lane));
            if settled || correction == MOST_CORRECTIONS {
                refuse_unsettled(&stand, wanted, joints);
                self.most_corrections = self.most_corrections.max(correction);
                return;
            }
            asked = next;
            self.branch(branch, &asked, surplus, tool_length_mm, joints);
            if correction == 0 {
                keeps_angles = self.unsteady(&without, joints, wanted, &asked);
                asked = stand.correct(wanted, &keeps_angles);
                self.branch(branch, &asked, surplus, tool_length_mm, joints);
            }
        }
    }

    fn branch(
        &mut self,
        branch: usize,
        asked: &PoseBlock,
        surplus: &[Lane],
        tool_length_mm: f64,
        joints: &mut JointBlock,
    ) {
        self.inner.inverse(asked, surplus, tool_length_mm, &mut self.solutions);
        joints.clone_from(&self.solutions.branches[branch]);
    }

    /// The lanes in which a small turn of the tool takes a large motion of a rotary axis.
    fn unsteady(
        &self,
        before: &JointBlock,
        after: &JointBlock,
        wanted: &PoseBlock,
        asked: &PoseBlock,
    ) -> [bool; LANES] {
        let rotaries = || (0..before.len()).filter(|&axis| self.machine.axes[axis].motion == Motion::Rotary);
        std::array::from_fn(|lane| {
            let turned = rotaries().map(|axis| turn_rad(after[axis][lane] - before[axis][lane])).fold(0.0, f64::max);
            turned > MOST_GAIN * angle_rad(wanted.axis(lane), asked.axis(lane))
        })
    }
}

impl<K: Kinematics> Kinematics for Compensated<'_, K> {
    fn axis_count(&self) -> usize {
        self.inner.axis_count()
    }

    fn branch_count(&self) -> usize {
        self.inner.branch_count()
    }

    fn free_axis(&self) -> Option<usize> {
        self.inner.free_axis()
    }

    fn surplus_axes(&self) -> &[usize] {
        self.inner.surplus_axes()
    }

    fn inverse(&mut self, poses: &PoseBlock, surplus: &[Lane], tool_length_mm: f64, out: &mut SolutionBlock) {
        self.inner.inverse(poses, surplus, tool_length_mm, out);
        if !self.is_ideal() {
            for (branch, joints) in out.branches.iter_mut().enumerate() {
                self.settle(branch, poses, surplus, tool_length_mm, joints);
            }
        }
    }

    fn position(&mut self, tip_mm: Vec3, tool_length_mm: f64, joints: &mut [f64]) {
        self.inner.position(tip_mm, tool_length_mm, joints);
        if self.is_ideal() {
            return;
        }
        let mut asked = tip_mm;
        for correction in 0.. {
            let block = joints.iter().map(|joint| [*joint; LANES]).collect();
            let stand = self.stand(&block, tool_length_mm);
            let next = add(tip_mm, sub(stand.ideal.tip(0), stand.actual.tip(0)));
            if norm(sub(next, asked)) <= SETTLED_MM || correction == MOST_CORRECTIONS {
                let is_off = norm(sub(stand.actual.tip(0), tip_mm)) > TIP_BOUND_MM;
                joints.iter_mut().filter(|_| is_off).for_each(|joint| *joint = f64::NAN);
                self.most_corrections = self.most_corrections.max(correction);
                return;
            }
            asked = next;
            self.inner.position(asked, tool_length_mm, joints);
        }
    }

    fn forward(&mut self, joints: &JointBlock, tool_length_mm: f64, out: &mut PoseBlock) {
        if self.is_ideal() {
            self.inner.forward(joints, tool_length_mm, out);
        } else {
            self.actual(joints, tool_length_mm, out);
        }
    }

    fn forward_actual(&mut self, joints: &JointBlock, deviations: &[Lane], tool_length_mm: f64, out: &mut PoseBlock) {
        self.inner.forward_actual(joints, deviations, tool_length_mm, out);
    }
}

impl Stand {
    /// The poses to ask for, so that the errors found here take the tool to the wanted ones.
    fn correct(&self, wanted: &PoseBlock, keeps_angles: &[bool; LANES]) -> PoseBlock {
        let mut asked = wanted.clone();
        for (lane, &keeps_angles) in keeps_angles.iter().enumerate() {
            let tip = add(wanted.tip(lane), sub(self.ideal.tip(lane), self.actual.tip(lane)));
            let turned = || turned(self.actual.axis(lane), self.ideal.axis(lane), wanted.axis(lane));
            asked.set(lane, tip, if keeps_angles { wanted.axis(lane) } else { turned() });
        }
        asked
    }
}

/// The error of one table at each lane's joint of its axis.
fn deviation(table: &ErrorTable, machine: &Machine, joint: &Lane) -> Lane {
    joint.map(|joint| table.at(&machine.axes[table.axis], joint))
}

/// Whether two poses are the same; what is no number has nothing to settle.
fn is_settled(a: &PoseBlock, b: &PoseBlock, lane: usize) -> bool {
    let moves = norm(sub(a.tip(lane), b.tip(lane))) > SETTLED_MM || angle_rad(a.axis(lane), b.axis(lane)) > SETTLED_RAD;
    !moves
}

/// A candidate that does not put the tip where it should be has no joints.
fn refuse_unsettled(stand: &Stand, wanted: &PoseBlock, joints: &mut JointBlock) {
    for lane in 0..LANES {
        if norm(sub(stand.actual.tip(lane), wanted.tip(lane))) > TIP_BOUND_MM {
            joints.iter_mut().for_each(|joint| joint[lane] = f64::NAN);
        }
    }
}

/// `v` turned as `from` is turned into `to` by the shortest way; these are next to each other.
fn turned(from: Vec3, to: Vec3, v: Vec3) -> Vec3 {
    let normal = cross(from, to);
    let first = cross(normal, v);
    let second = scale(1.0 / (1.0 + dot(from, to)), cross(normal, first));
    add(v, add(first, second))
}

/// The size of an angle in degrees, without whole turns, in radians.
fn turn_rad(angle_deg: f64) -> f64 {
    (angle_deg - 360.0 * (angle_deg / 360.0).round()).abs().to_radians()
}
