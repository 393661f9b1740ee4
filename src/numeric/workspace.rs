//! What an iteration works with: the forward chain, its linearisation, a trial step.

use super::effort::Effort;
use super::forward::Forward;
use super::found::within_one_turn;
use super::least_squares::LeastSquares;
use super::residual::{BOUND, LENGTH_MM, Target};
use crate::plan::{Plan, Pose};

/// Working space for one machine. Joints are scaled.
#[derive(Debug, Clone)]
pub(super) struct Workspace {
    pub(super) forward: Forward,
    pub(super) effort: Effort,
    /// The derivatives of the scaled residual by each joint, or what is taken for them.
    columns: Vec<Pose>,
    system: LeastSquares,
    rotary: Vec<bool>,
    /// Joints that stay where they are: those that the pose leaves open.
    surplus: Vec<usize>,
    step: Vec<f64>,
    moved: Vec<f64>,
}

impl Workspace {
    pub(super) fn new(plan: &Plan) -> Self {
        let joints = plan.rotary.len();
        Self {
            forward: Forward::new(plan),
            effort: Effort::default(),
            columns: vec![[0.0; 6]; joints],
            system: LeastSquares::new(joints),
            rotary: plan.rotary.clone(),
            surplus: plan.surplus.clone(),
            step: vec![0.0; joints],
            moved: vec![0.0; joints],
        }
    }

    /// The pose of these joints; what follows starts from its derivatives.
    pub(super) fn linearise(&mut self, joints: &[f64]) -> Pose {
        let pose = self.forward.derivatives(joints, &mut self.columns);
        self.surplus.iter().for_each(|&joint| self.columns[joint].fill(0.0));
        pose
    }

    /// Tries the step that leaves least of this residual by the derivatives: the pose that it leads to, or none where the
    /// step is too small to matter, or the start no number. Angles stay within one turn: next to a singular position a step may be any number of turns.
    pub(super) fn try_step(&mut self, joints: &[f64], residual: &Pose, damping: f64) -> Option<Pose> {
        self.system.solve(&self.columns, residual, damping, &mut self.step);
        let length = size(&self.step);
        if length.is_nan() || length <= BOUND {
            return None;
        }
        for (axis, moved) in self.moved.iter_mut().enumerate() {
            let sum = joints[axis] + self.step[axis];
            *moved = if self.rotary[axis] { within_one_turn(sum) } else { sum };
        }
        self.effort.iterations += 1;
        Some(self.forward.pose(&self.moved))
    }

    /// The step tried last with the linear joints put where they hold the tip: the pose that it leads to. The derivatives are
    /// to be computed again.
    pub(super) fn try_held(&mut self, target: &Target) -> Pose {
        let mut moved = std::mem::take(&mut self.moved);
        self.place(target, &mut moved);
        self.moved = moved;
        self.effort.iterations += 1;
        self.forward.pose(&self.moved)
    }

    /// Takes the step that was tried last.
    pub(super) fn take_step(&self, joints: &mut [f64]) {
        joints.copy_from_slice(&self.moved);
    }

    /// The size of what is left at these joints.
    pub(super) fn residual(&mut self, target: &Target, joints: &[f64]) -> f64 {
        size(&target.residual(&self.forward.pose(joints)))
    }

    /// How many linear joints follow the pose.
    pub(super) fn linear_joints(&self) -> usize {
        (0..self.rotary.len()).filter(|joint| !self.rotary[*joint] && !self.surplus.contains(joint)).count()
    }

    /// Moves the linear joints so that the tip is where it should be, and says whether it is. The tip is affine in them: a
    /// second step takes away only what rounding has left of the first.
    pub(super) fn place(&mut self, target: &Target, joints: &mut [f64]) -> bool {
        for _ in 0..2 {
            let mut left = target.residual(&self.linearise(joints));
            left[3..].fill(0.0);
            for (column, _) in self.columns.iter_mut().zip(&self.rotary).filter(|(_, rotary)| **rotary) {
                column.fill(0.0);
            }
            self.system.solve(&self.columns, &left, BOUND, &mut self.step);
            joints.iter_mut().zip(&self.step).for_each(|(joint, step)| *joint += step);
        }
        target.distance(&self.forward.pose(joints)).0 <= BOUND * LENGTH_MM
    }

    /// Corrects the derivatives by what the step that was tried last has changed the residual by, as little as possible
    /// (Broyden's good method).
    pub(super) fn learn(&mut self, change: &Pose) {
        let length_squared: f64 = self.step.iter().map(|step| step * step).sum();
        let foretold: Pose =
            std::array::from_fn(|i| self.columns.iter().zip(&self.step).map(|(column, step)| column[i] * step).sum());
        for (column, step) in self.columns.iter_mut().zip(&self.step) {
            for i in 0..6 {
                column[i] += (change[i] - foretold[i]) * step / length_squared;
            }
        }
    }
}

/// The length of a vector.
pub(super) fn size(vector: &[f64]) -> f64 {
    vector.iter().map(|component| component * component).sum::<f64>().sqrt()
}
