//! The iterated inverse as the runtime's kinematics: every solution is followed from pose to pose.

use super::found::Found;
use super::residual::{BOUND, LENGTH_MM, Target};
use super::workspace::Workspace;
use super::{Effort, Method, seeds};
use crate::plan::{Interpreter, JOINT_INPUT, Plan, Program};
use mach_runtime::kinematics::{JointBlock, Kinematics, LANES, Lane, Miss, Pole, PoseBlock, SolutionBlock, held};
use mach_runtime::tool::ToolGeometry;
use mach_runtime::vector::Vec3;
use std::f64::consts::PI;

/// A plan's forward chain, solved for the joints by iteration. Of the plan's branches only their number is used.
///
/// A machine with two rotaries or more has two candidates: the solutions found from a grid of starts at the first pose,
/// each followed from there. One that gets lost, or meets the other, is looked for from the grid again. Where there is but
/// one, it is handed out twice. As each pose starts from the one before, poses are to come in the order of the path.
#[derive(Debug, Clone)]
pub struct Numeric {
    method: Method,
    workspace: Workspace,
    chain: Interpreter,
    pole_distance: Program<1>,
    branches: usize,
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
    /// How far tip and axis are off: zero with solutions.
    tip_mm: f64,
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
            pole_distance: Program::new(&plan.graph, inputs, &[plan.pole_distance]),
            branches: branches(plan),
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
        for start in 0..self.starts.len() {
            let mut joints = self.starts[start].clone();
            self.workspace.place(target, &mut joints);
            let from = target.with(&self.workspace.forward.pose(&joints));
            self.attempt(&from, target, joints, found);
            if found.solutions.len() == self.branches {
                return;
            }
        }
    }

    /// The solutions in their order; what comes nearest where there are none.
    fn settled(&mut self, target: Target, mut found: Found) -> Followed {
        let mut solutions = std::mem::take(&mut found.solutions);
        if solutions.is_empty() {
            let joints = found.nearest().unwrap_or_else(|| self.starts[0].clone());
            return self.nearest(target, joints);
        }
        if let Some(second) = self.second_rotary() {
            solutions.sort_by(|a, b| b[second].total_cmp(&a[second]));
        }
        solutions.resize(self.branches, solutions[solutions.len() - 1].clone());
        Followed { target, solutions, tip_mm: 0.0, axis_rad: 0.0 }
    }

    /// The joints that come nearest, from some that are near: by least squares, whatever the method is. Three linear
    /// joints hold the tip for any angles; where they do not, at a singular position, they are no numbers.
    fn nearest(&mut self, target: Target, mut joints: Vec<f64>) -> Followed {
        Method::Newton.solve(&mut self.workspace, &target, &target, &mut joints);
        let holds_tip = self.workspace.linear_joints() >= 3;
        let is_singular = holds_tip && !self.workspace.place(&target, &mut joints);
        let (tip_mm, axis_rad) = target.distance(&self.workspace.forward.pose(&joints));
        let solutions = |joints| vec![joints; self.branches];
        if is_singular {
            let linear = joints.iter_mut().zip(&self.rotary).filter(|(_, rotary)| !**rotary);
            linear.for_each(|(joint, _)| *joint = f64::NAN);
            return Followed { target, solutions: solutions(joints), tip_mm: 0.0, axis_rad: 0.0 };
        }
        Followed { target, solutions: solutions(joints), tip_mm: if holds_tip { 0.0 } else { tip_mm }, axis_rad }
    }

    /// The rotary that orders the solutions, the greater angle first: the one nearest the tool of those declared.
    fn second_rotary(&self) -> Option<usize> {
        (0..self.rotary.len()).rev().find(|&axis| self.rotary[axis] && Some(axis) != self.pole().map(Pole::axis))
    }

    /// The joints that the pose leaves open, put to these values.
    fn put_surplus(&mut self, surplus: &[Lane], lane: usize) {
        for (place, lanes) in surplus.iter().enumerate() {
            let axis = self.chain.surplus_axes()[place];
            let scaled = self.inside(axis, lanes[lane]);
            let last = self.last.iter_mut().flat_map(|last| &mut last.solutions);
            last.chain(&mut self.starts).for_each(|joints| joints[axis] = scaled);
        }
    }

    fn pole_distance(&mut self, target: &Target) -> f64 {
        let inputs = target.tip_mm.into_iter().chain(target.axis).chain([target.tool.length_mm]);
        inputs.enumerate().for_each(|(index, value)| self.pole_distance.input(index)[0] = value);
        self.pole_distance.run();
        self.pole_distance.output(0)[0]
    }

    /// A joint value, scaled.
    fn inside(&self, axis: usize, joint: f64) -> f64 {
        if self.rotary[axis] { joint.to_radians() } else { joint / LENGTH_MM }
    }

    /// A scaled joint in millimetres or degrees. What is half a turn within the bound is a positive one: rounding must not
    /// decide which way to turn.
    fn outside(&self, axis: usize, scaled: f64) -> f64 {
        match self.rotary[axis] {
            true if (scaled.abs() - PI).abs() <= BOUND => 180.0,
            true => scaled.to_degrees(),
            false => scaled * LENGTH_MM,
        }
    }
}

impl Kinematics for Numeric {
    fn axis_count(&self) -> usize {
        self.rotary.len()
    }

    fn branch_count(&self) -> usize {
        self.branches
    }

    fn pole(&self) -> Option<Pole> {
        self.chain.pole()
    }

    fn surplus_axes(&self) -> &[usize] {
        self.chain.surplus_axes()
    }

    fn inverse(&mut self, poses: &PoseBlock, surplus: &[Lane], tool: ToolGeometry, out: &mut SolutionBlock) {
        self.workspace.forward.tool = tool;
        for lane in 0..LANES {
            let target = Target { tip_mm: poses.tip(lane), axis: poses.axis(lane), tool };
            let is_known = |last: &mut Followed| last.target == target && surplus.is_empty();
            let known = self.last.take_if(is_known);
            self.put_surplus(surplus, lane);
            let followed = known.unwrap_or_else(|| self.follow(target));
            let (branches, margins) = out.parts_mut();
            for (branch, joints) in branches.iter_mut().zip(&followed.solutions) {
                for (axis, (lanes, joint)) in branch.iter_mut().zip(joints).enumerate() {
                    lanes[lane] = self.outside(axis, *joint);
                }
            }
            margins.reach_rad[lane] = if followed.axis_rad > BOUND { -followed.axis_rad } else { 0.0 };
            margins.gap_mm[lane] = followed.tip_mm;
            margins.pole[lane] = self.pole_distance(&target);
            self.last = Some(followed);
        }
    }

    fn position(&mut self, tip_mm: Vec3, tool: ToolGeometry, joints: &mut [f64]) -> Result<(), Miss> {
        self.workspace.forward.tool = tool;
        let target = Target { tip_mm, axis: [0.0; 3], tool };
        let follows = |axis: usize| !self.rotary[axis] && !self.chain.surplus_axes().contains(&axis);
        let given = |(axis, joint): (usize, &f64)| if follows(axis) { 0.0 } else { self.inside(axis, *joint) };
        let mut scaled: Vec<f64> = joints.iter().enumerate().map(given).collect();
        let is_held = self.workspace.place(&target, &mut scaled);
        for (axis, joint) in joints.iter_mut().enumerate().filter(|&(axis, _)| follows(axis)) {
            *joint = if is_held { scaled[axis] * LENGTH_MM } else { f64::NAN };
        }
        held(joints)
    }

    fn forward(&mut self, joints: &JointBlock, tool: ToolGeometry, out: &mut PoseBlock) {
        self.chain.forward(joints, tool, out);
    }

    fn forward_actual(&mut self, joints: &JointBlock, deviations: &[Lane], tool: ToolGeometry, out: &mut PoseBlock) {
        self.chain.forward_actual(joints, deviations, tool, out);
    }
}

/// How many solutions a pose has: two with two rotaries or more, unless the plan knows better.
fn branches(plan: &Plan) -> usize {
    let rotaries = plan.rotary.iter().filter(|rotary| **rotary).count();
    if plan.has_closed_form() { plan.branches.len() } else { rotaries.clamp(1, 2) }
}
