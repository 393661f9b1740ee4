//! The plan as kinematics: its programs run over blocks of lanes. Joints are in millimetres and degrees outside.

use super::{AXIS_INPUT, Id, InverseOutput, JOINT_INPUT, Plan, Program, TIP_INPUT, TOOL_LENGTH_INPUT};
use mach_runtime::kinematics::{JointBlock, Kinematics, LANES, Lane, Miss, Pole, PoseBlock, SolutionBlock, held};
use mach_runtime::tool::ToolGeometry;
use mach_runtime::vector::Vec3;

/// Runs a plan.
#[derive(Debug, Clone)]
pub struct Interpreter {
    inverse: Program,
    /// What its outputs are.
    outputs: Vec<InverseOutput>,
    position: Program<1>,
    forward: Program,
    /// The forward chain with errors; its inputs go on with these.
    actual: Program,
    branches: usize,
    pole: Option<Pole>,
    surplus: Vec<usize>,
    rotary: Vec<bool>,
}

impl Interpreter {
    /// The programs of a plan.
    pub fn new(plan: &Plan) -> Self {
        let inputs = JOINT_INPUT + plan.rotary.len();
        let (outputs, solutions): (Vec<_>, Vec<_>) = plan.inverse_outputs().into_iter().unzip();
        let pose = |(tip, axis): ([Id; 3], [Id; 3])| -> Vec<Id> { tip.into_iter().chain(axis).collect() };
        Self {
            inverse: Program::new(&plan.graph, inputs, &solutions),
            outputs,
            position: Program::new(&plan.graph, inputs, &plan.position),
            forward: Program::new(&plan.graph, inputs, &pose((plan.tip, plan.axis))),
            actual: Program::new(&plan.graph, inputs + plan.errors, &pose(plan.actual)),
            branches: plan.branches.len(),
            pole: plan.pole,
            surplus: plan.surplus.clone(),
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

    fn pole(&self) -> Option<Pole> {
        self.pole
    }

    fn surplus_axes(&self) -> &[usize] {
        &self.surplus
    }

    fn inverse(&mut self, poses: &PoseBlock, surplus: &[Lane], tool: ToolGeometry, out: &mut SolutionBlock) {
        assert_eq!(surplus.len(), self.surplus.len(), "an inverse is given a value for each surplus axis");
        for i in 0..3 {
            *self.inverse.input(TIP_INPUT + i) = poses.tip_mm[i];
            *self.inverse.input(AXIS_INPUT + i) = poses.axis[i];
        }
        *self.inverse.input(TOOL_LENGTH_INPUT) = [tool.length_mm; LANES];
        for (&axis, lane) in self.surplus.iter().zip(surplus) {
            *self.inverse.input(JOINT_INPUT + axis) = inside(lane, self.rotary[axis]);
        }
        self.inverse.run();
        let (branches, margins) = out.parts_mut();
        for (place, output) in self.outputs.iter().enumerate() {
            let lane = self.inverse.output(place);
            match *output {
                InverseOutput::Joint { branch, axis } => branches[branch][axis] = outside(lane, self.rotary[axis]),
                InverseOutput::Reach => margins.reach_rad = *lane,
                InverseOutput::PoleDistance => margins.pole = *lane,
                InverseOutput::Gap => margins.gap_mm = *lane,
            }
        }
        for joints in branches {
            // As they were given: radians and back would round.
            self.surplus.iter().zip(surplus).for_each(|(&axis, lane)| joints[axis] = *lane);
        }
    }

    fn position(&mut self, tip_mm: Vec3, tool: ToolGeometry, joints: &mut [f64]) -> Result<(), Miss> {
        for (i, &value) in tip_mm.iter().enumerate() {
            self.position.input(TIP_INPUT + i)[0] = value;
        }
        self.position.input(TOOL_LENGTH_INPUT)[0] = tool.length_mm;
        for (axis, value) in joints.iter().enumerate() {
            self.position.input(JOINT_INPUT + axis)[0] = if self.rotary[axis] { value.to_radians() } else { *value };
        }
        self.position.run();
        let follows = |axis: usize| !self.rotary[axis] && !self.surplus.contains(&axis);
        for (axis, value) in joints.iter_mut().enumerate().filter(|&(axis, _)| follows(axis)) {
            *value = self.position.output(axis)[0];
        }
        held(joints)
    }

    fn forward(&mut self, joints: &JointBlock, tool: ToolGeometry, out: &mut PoseBlock) {
        pose(&mut self.forward, &self.rotary, joints, tool, out);
    }

    fn forward_actual(&mut self, joints: &JointBlock, deviations: &[Lane], tool: ToolGeometry, out: &mut PoseBlock) {
        for (error, lane) in deviations.iter().enumerate() {
            *self.actual.input(JOINT_INPUT + self.rotary.len() + error) = *lane;
        }
        pose(&mut self.actual, &self.rotary, joints, tool, out);
    }
}

/// Runs a forward program.
fn pose(program: &mut Program, rotary: &[bool], joints: &JointBlock, tool: ToolGeometry, out: &mut PoseBlock) {
    for (axis, lane) in joints.iter().enumerate() {
        *program.input(JOINT_INPUT + axis) = inside(lane, rotary[axis]);
    }
    *program.input(TOOL_LENGTH_INPUT) = [tool.length_mm; LANES];
    program.run();
    for i in 0..3 {
        out.tip_mm[i] = *program.output(i);
        out.axis[i] = *program.output(3 + i);
    }
}

fn inside(lane: &Lane, rotary: bool) -> Lane {
    if rotary { lane.map(f64::to_radians) } else { *lane }
}

fn outside(lane: &Lane, rotary: bool) -> Lane {
    if rotary { lane.map(f64::to_degrees) } else { *lane }
}
