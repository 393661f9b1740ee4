//! The iterated inverse as the runtime's kinematics: every solution is followed from pose to pose.

use super::found::{Found, within_one_turn};
use super::residual::{BOUND, LENGTH_MM, Target};
use super::workspace::Workspace;
use super::{Effort, Method, seeds};
use crate::plan::{AXIS_INPUT, Interpreter, JOINT_INPUT, Plan, Program};
use mach_runtime::kinematics::{JointBlock, Kinematics, LANES, PoseBlock, SolutionBlock};
use mach_runtime::vector::Vec3;

/// A plan's forward chain, solved for the joints by iteration. The plan's own branches are not looked at.
///
/// A machine with two rotaries or more has two candidates: the solutions found from a grid of starts at the first pose,
/// each followed from there. One that gets lost, or meets the other, is looked for from the grid again. Where there is but
/// one, it is handed out twice. As each pose starts from the one before, poses are to come in the order of the path.
#[derive(Debug, Clone)]
pub struct Numeric {
    method: Method,
    workspace: Workspace,
    chain: Interpreter,
    pole_sine: Program<1>,
    rotary: Vec<bool>,
    starts: Vec<Vec<f64>>,
    last: Option<Followed>,
}

/// A pose with its solutions.
#[derive(Debug, Clone)]
struct Followed {
    target: Target,
    /// Scaled joints: the solutions, or those that come nearest.
    solutions: Vec<Vec<f64>>,
    /// How far the axis is off: zero with solutions.
    axis_rad: f64,
}

impl Numeric {
    /// The solver for a plan's machine.
    pub fn new(plan: &Plan, method: Method) -> Self {
        let inputs = JOINT_INPUT + plan.rotary.len();
        Self {
            method,
            workspace: Workspace::new(plan),
            chain: Interpreter::new(plan),
            pole_sine: Program::new(&plan.graph, inputs, &[plan.pole_sine]),
            rotary: plan.rotary.clone(),
            starts: seeds::starts(&plan.rotary),
            last: None,
        }
    }

    /// What the iterations have cost so far.
    pub fn effort(&self) -> Effort {
        self.workspace.effort
    }

    /// The pose with its solutions, from those of the last pose.
    fn follow(&mut self, target: Target) -> Followed {
        let before = self.workspace.effort;
        let mut found = Found::default();
        if let Some(last) = self.last.take() {
            for solution in last.solutions {
                self.attempt(&last.target, &target, solution, &mut found);
            }
        }
        if found.solutions.len() < self.branch_count() {
            self.search(&target, &mut found);
        }
        let followed = self.settled(target, found);
        self.workspace.effort.end_pose(&before);
        followed
    }

    /// Iterates from these joints, which solve for the pose `from`.
    fn attempt(&mut self, from: &Target, target: &Target, mut joints: Vec<f64>, found: &mut Found) {
        let end = self.method.solve(&mut self.workspace, from, target, &mut joints);
        let residual = self.workspace.residual(target, &joints);
        found.add(end, residual, joints, &self.rotary);
    }

    /// Starts from the grid, until there are as many solutions as there can be.
    fn search(&mut self, target: &Target, found: &mut Found) {
        self.workspace.effort.searches += 1;
        for start in self.starts.clone() {
            let mut joints = start;
            self.workspace.place(target, &mut joints);
            let from = target.with(&self.workspace.forward.pose(&joints));
            self.attempt(&from, target, joints, found);
            if found.solutions.len() == self.branch_count() {
                return;
            }
        }
    }

    /// The solutions in their order; what comes nearest where there are none.
    fn settled(&mut self, target: Target, mut found: Found) -> Followed {
        let mut solutions = std::mem::take(&mut found.solutions);
        let mut axis_rad = 0.0;
        if solutions.is_empty() {
            let joints = found.nearest().unwrap_or_else(|| self.starts[0].clone());
            let (nearest, off_rad) = self.nearest(&target, joints);
            solutions.push(nearest);
            axis_rad = off_rad;
        }
        if let Some(second) = self.second_rotary() {
            solutions.sort_by(|a, b| b[second].total_cmp(&a[second]));
        }
        solutions.resize(self.branch_count(), solutions[solutions.len() - 1].clone());
        Followed { target, solutions, axis_rad }
    }

    /// The joints that come nearest, from some that are near, and how far the axis is off: by least squares, whatever
    /// the method is. Where the linear joints cannot hold the tip they are no numbers, and how far the axis is off says
    /// nothing.
    fn nearest(&mut self, target: &Target, mut joints: Vec<f64>) -> (Vec<f64>, f64) {
        Method::Newton.solve(&mut self.workspace, target, target, &mut joints);
        let is_held = self.workspace.place(target, &mut joints);
        let (_, off_rad) = target.distance(&self.workspace.forward.pose(&joints));
        for (joint, &rotary) in joints.iter_mut().zip(&self.rotary) {
            *joint = match (rotary, is_held) {
                (true, _) => within_one_turn(*joint),
                (false, true) => *joint,
                (false, false) => f64::NAN,
            };
        }
        (joints, if is_held { off_rad } else { 0.0 })
    }

    /// The rotary that orders the solutions, the greater angle first: the one nearest the tool of those declared.
    fn second_rotary(&self) -> Option<usize> {
        (0..self.rotary.len()).rev().find(|&axis| self.rotary[axis] && Some(axis) != self.free_axis())
    }

    fn pole_sine(&mut self, axis: Vec3) -> f64 {
        for (i, component) in axis.into_iter().enumerate() {
            self.pole_sine.input(AXIS_INPUT + i)[0] = component;
        }
        self.pole_sine.run();
        self.pole_sine.output(0)[0]
    }

    fn outside(&self, axis: usize, scaled: f64) -> f64 {
        if self.rotary[axis] { scaled.to_degrees() } else { scaled * LENGTH_MM }
    }
}

impl Kinematics for Numeric {
    fn axis_count(&self) -> usize {
        self.rotary.len()
    }

    fn branch_count(&self) -> usize {
        if self.rotary.iter().filter(|rotary| **rotary).count() >= 2 { 2 } else { 1 }
    }

    fn free_axis(&self) -> Option<usize> {
        self.chain.free_axis()
    }

    fn inverse(&mut self, poses: &PoseBlock, tool_length_mm: f64, out: &mut SolutionBlock) {
        self.workspace.forward.tool_length_mm = tool_length_mm;
        for lane in 0..LANES {
            let target = Target { tip_mm: poses.tip(lane), axis: poses.axis(lane), tool_length_mm };
            let known = self.last.take_if(|last| last.target == target);
            let followed = known.unwrap_or_else(|| self.follow(target));
            for (branch, joints) in out.branches.iter_mut().zip(&followed.solutions) {
                for (axis, (lanes, joint)) in branch.iter_mut().zip(joints).enumerate() {
                    lanes[lane] = self.outside(axis, *joint);
                }
            }
            out.reach_rad[lane] = if followed.axis_rad > BOUND { -followed.axis_rad } else { 0.0 };
            out.pole_sine[lane] = self.pole_sine(target.axis);
            self.last = Some(followed);
        }
    }

    fn position(&mut self, tip_mm: Vec3, tool_length_mm: f64, joints: &mut [f64]) {
        self.workspace.forward.tool_length_mm = tool_length_mm;
        let target = Target { tip_mm, axis: [0.0; 3], tool_length_mm };
        let mut scaled: Vec<f64> = joints.iter().map(|joint| joint.to_radians()).collect();
        for (joint, _) in scaled.iter_mut().zip(&self.rotary).filter(|(_, rotary)| !**rotary) {
            *joint = 0.0;
        }
        let is_held = self.workspace.place(&target, &mut scaled);
        for (axis, joint) in joints.iter_mut().enumerate().filter(|&(axis, _)| !self.rotary[axis]) {
            *joint = if is_held { scaled[axis] * LENGTH_MM } else { f64::NAN };
        }
    }

    fn forward(&mut self, joints: &JointBlock, tool_length_mm: f64, out: &mut PoseBlock) {
        self.chain.forward(joints, tool_length_mm, out);
    }
}
