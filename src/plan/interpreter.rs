//! The plan as kinematics: its programs run over blocks of lanes. Joints are in millimetres and degrees outside.

use super::{AXIS_INPUT, JOINT_INPUT, Plan, Program, TIP_INPUT, TOOL_LENGTH_INPUT};
use mach_runtime::kinematics::{JointBlock, Kinematics, LANES, Lane, PoseBlock, SolutionBlock};
use mach_runtime::vector::Vec3;

/// Runs a plan.
#[derive(Debug, Clone)]
pub struct Interpreter {
    inverse: Program,
    position: Program<1>,
    forward: Program,
    branches: usize,
    free_axis: Option<usize>,
    rotary: Vec<bool>,
}

impl Interpreter {
    /// The programs of a plan.
    pub fn new(plan: &Plan) -> Self {
        let inputs = JOINT_INPUT + plan.rotary.len();
        let mut outputs: Vec<_> = plan.branches.iter().flat_map(|branch| branch.joints.clone()).collect();
        outputs.extend([plan.reach, plan.pole_sine]);
        let pose: Vec<_> = plan.tip.iter().chain(&plan.axis).copied().collect();
        Self {
            inverse: Program::new(&plan.graph, inputs, &outputs),
            position: Program::new(&plan.graph, inputs, &plan.position),
            forward: Program::new(&plan.graph, inputs, &pose),
            branches: plan.branches.len(),
            free_axis: plan.free_axis,
            rotary: plan.rotary.clone(),
        }
    }
}

impl Kinematics for Interpreter {
    fn axis_count(&self) -> usize {
        self.rotary.len()
    }

    fn branch_count(&self) -> usize {
        self.branches
    }

    fn free_axis(&self) -> Option<usize> {
        self.free_axis
    }

    fn inverse(&mut self, poses: &PoseBlock, tool_length_mm: f64, out: &mut SolutionBlock) {
        for i in 0..3 {
            *self.inverse.input(TIP_INPUT + i) = poses.tip_mm[i];
            *self.inverse.input(AXIS_INPUT + i) = poses.axis[i];
        }
        *self.inverse.input(TOOL_LENGTH_INPUT) = [tool_length_mm; LANES];
        self.inverse.run();
        let axes = self.rotary.len();
        for (branch, joints) in out.branches.iter_mut().enumerate() {
            for (axis, lane) in joints.iter_mut().enumerate() {
                *lane = outside(self.inverse.output(branch * axes + axis), self.rotary[axis]);
            }
        }
        out.reach_rad = *self.inverse.output(self.branches * axes);
        out.pole_sine = *self.inverse.output(self.branches * axes + 1);
    }

    fn position(&mut self, tip_mm: Vec3, tool_length_mm: f64, joints: &mut [f64]) {
        for (i, &value) in tip_mm.iter().enumerate() {
            self.position.input(TIP_INPUT + i)[0] = value;
        }
        self.position.input(TOOL_LENGTH_INPUT)[0] = tool_length_mm;
        for (axis, value) in joints.iter().enumerate() {
            self.position.input(JOINT_INPUT + axis)[0] = if self.rotary[axis] { value.to_radians() } else { *value };
        }
        self.position.run();
        for (axis, value) in joints.iter_mut().enumerate().filter(|&(axis, _)| !self.rotary[axis]) {
            *value = self.position.output(axis)[0];
        }
    }

    fn forward(&mut self, joints: &JointBlock, tool_length_mm: f64, out: &mut PoseBlock) {
        for (axis, lane) in joints.iter().enumerate() {
            *self.forward.input(JOINT_INPUT + axis) = if self.rotary[axis] { lane.map(f64::to_radians) } else { *lane };
        }
        *self.forward.input(TOOL_LENGTH_INPUT) = [tool_length_mm; LANES];
        self.forward.run();
        for i in 0..3 {
            out.tip_mm[i] = *self.forward.output(i);
            out.axis[i] = *self.forward.output(3 + i);
        }
    }
}

fn outside(lane: &Lane, rotary: bool) -> Lane {
    if rotary { lane.map(f64::to_degrees) } else { *lane }
}
