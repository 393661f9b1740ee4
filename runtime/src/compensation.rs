//! Compensation of errors that depend on where the axes are: a fixed point around the closed form.
//!
//! The closed form solves the machine as it should be. Where the machine with its errors would then stand differs a
//! little from that; the pose that is asked of the closed form is moved by this difference the other way, and again, until
//! nothing changes. An error of 10 µm and 20 µrad shrinks by about a thousand each time.

use crate::kinematics::{JointBlock, Kinematics, LANES, Lane, Miss, Pole, PoseBlock, SolutionBlock};
use crate::machine::{ErrorTable, Machine, Motion};
use crate::tool::ToolGeometry;
use crate::vector::{Vec3, add, angle_rad, cross, dot, norm, scale, sub};

/// Two poses closer than this are the same: half of what a machine is proved to.
const SETTLED_MM: f64 = 5e-10;
/// See [`SETTLED_MM`].
const SETTLED_RAD: f64 = 5e-13;

/// A tip farther off than this when the iteration ends is not compensated.
const TIP_BOUND_MM: f64 = 1e-9;

/// No more than so many corrections: errors that a machine tool has take three or four.
const MOST_CORRECTIONS: usize = 16;

/// Where turning the tool by some angle takes a rotary axis through more than so many times that angle (next to a pole, or
/// to the edge of the reach), its own errors' turn is not worth the motion: the rotary axes stay where they are without
/// errors, and only the tip is compensated.
const MOST_GAIN: f64 = 25.0;

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
        Self {
            solutions: SolutionBlock::of(&inner),
            inner,
            machine,
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

    fn actual(&mut self, joints: &JointBlock, tool: ToolGeometry, out: &mut PoseBlock) {
        let Self { inner, machine, deviations, .. } = self;
        for (lane, table) in deviations.iter_mut().zip(&machine.errors) {
            *lane = deviation(table, machine, &joints[table.axis]);
        }
        inner.forward_actual(joints, deviations, tool, out);
    }

    fn stand(&mut self, joints: &JointBlock, tool: ToolGeometry) -> Stand {
        let mut stand = Stand { ideal: PoseBlock::ZERO, actual: PoseBlock::ZERO };
        self.inner.forward(joints, tool, &mut stand.ideal);
        self.actual(joints, tool, &mut stand.actual);
        stand
    }

    /// Moves one candidate, given without errors, to where the errors take the tool to the wanted poses. The lanes where that
    /// comes to no rest, a bit for each.
    fn settle(
        &mut self,
        branch: usize,
        wanted: &PoseBlock,
        surplus: &[Lane],
        tool: ToolGeometry,
        joints: &mut JointBlock,
    ) -> u64 {
        let without = joints.clone();
        let mut asked = wanted.clone();
        let mut keeps_angles = [false; LANES];
        let mut corrections = 0;
        loop {
            let stand = self.stand(joints, tool);
            let next = stand.correct(wanted, &keeps_angles);
            let settled = (0..LANES).all(|lane| is_settled(&asked, &next, lane));
            if settled || corrections == MOST_CORRECTIONS {
                self.most_corrections = self.most_corrections.max(corrections);
                return unsettled(&stand, wanted, &without);
            }
            asked = next;
            corrections += 1;
            self.branch(branch, &asked, surplus, tool, joints);
            let newly = self.unsteady(&without, joints, wanted, &asked);
            if newly.contains(&true) {
                (0..LANES).for_each(|lane| keeps_angles[lane] |= newly[lane]);
                asked = stand.correct(wanted, &keeps_angles);
                self.branch(branch, &asked, surplus, tool, joints);
            }
        }
    }

    fn branch(
        &mut self,
        branch: usize,
        asked: &PoseBlock,
        surplus: &[Lane],
        tool: ToolGeometry,
        joints: &mut JointBlock,
    ) {
        self.inner.inverse(asked, surplus, tool, &mut self.solutions);
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

    fn pole(&self) -> Option<Pole> {
        self.inner.pole()
    }

    fn surplus_axes(&self) -> &[usize] {
        self.inner.surplus_axes()
    }

    fn inverse(&mut self, poses: &PoseBlock, surplus: &[Lane], tool: ToolGeometry, out: &mut SolutionBlock) {
        self.inner.inverse(poses, surplus, tool, out);
        if !self.is_ideal() {
            let branches = out.branches.iter_mut().enumerate();
            let settle = |(branch, joints)| self.settle(branch, poses, surplus, tool, joints);
            let unsettled = branches.map(settle).fold(0, |all, lanes| all | lanes);
            out.set_uncompensated(unsettled);
        }
    }

    fn position(&mut self, tip_mm: Vec3, tool: ToolGeometry, joints: &mut [f64]) -> Result<(), Miss> {
        self.inner.position(tip_mm, tool, joints)?;
        if self.is_ideal() {
            return Ok(());
        }
        let mut asked = tip_mm;
        let mut corrections = 0;
        loop {
            let block = joints.iter().map(|joint| [*joint; LANES]).collect();
            let stand = self.stand(&block, tool);
            let next = add(tip_mm, sub(stand.ideal.tip(0), stand.actual.tip(0)));
            if norm(sub(next, asked)) <= SETTLED_MM || corrections == MOST_CORRECTIONS {
                self.most_corrections = self.most_corrections.max(corrections);
                return if is_at(&stand, 0, tip_mm) { Ok(()) } else { Err(Miss::NotCompensated) };
            }
            asked = next;
            corrections += 1;
            self.inner.position(asked, tool, joints)?;
        }
    }

    fn forward(&mut self, joints: &JointBlock, tool: ToolGeometry, out: &mut PoseBlock) {
        if self.is_ideal() {
            self.inner.forward(joints, tool, out);
        } else {
            self.actual(joints, tool, out);
        }
    }

    fn forward_actual(&mut self, joints: &JointBlock, deviations: &[Lane], tool: ToolGeometry, out: &mut PoseBlock) {
        self.inner.forward_actual(joints, deviations, tool, out);
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

/// Whether the tip stands where it is wanted.
fn is_at(stand: &Stand, lane: usize, tip_mm: Vec3) -> bool {
    norm(sub(stand.actual.tip(lane), tip_mm)) <= TIP_BOUND_MM
}

/// The lanes in which the tip is not where it is wanted though there are joints for it without errors: a bit for each.
fn unsettled(stand: &Stand, wanted: &PoseBlock, without: &JointBlock) -> u64 {
    let has_joints = |lane: usize| without.iter().all(|joint| joint[lane].is_finite());
    let is_off = |lane: &usize| has_joints(*lane) && !is_at(stand, *lane, wanted.tip(*lane));
    (0..LANES).filter(is_off).fold(0, |lanes, lane| lanes | 1 << lane)
}

/// Whether two poses are the same; what is no number has nothing to settle.
fn is_settled(a: &PoseBlock, b: &PoseBlock, lane: usize) -> bool {
    let moves = norm(sub(a.tip(lane), b.tip(lane))) > SETTLED_MM || angle_rad(a.axis(lane), b.axis(lane)) > SETTLED_RAD;
    !moves
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
