//! The forward chain and its derivatives by the joints, for one set of joints at a time.

use super::{Id, JOINT_INPUT, Plan, Program, TOOL_LENGTH_INPUT};
use mach_runtime::tool::ToolGeometry;

/// Tip x, y, z in millimetres and unit tool axis i, j, k; or how they change, per unit of a joint.
pub type Pose = [f64; 6];

/// The programs for poses and derivatives. Joints are in millimetres and radians.
#[derive(Debug, Clone)]
pub struct Jacobian {
    pose: Program<1>,
    /// The pose, then its derivatives by each joint.
    derivatives: Program<1>,
    axes: usize,
}

impl Jacobian {
    /// The programs of a plan.
    pub fn new(plan: &Plan) -> Self {
        let axes = plan.rotary.len();
        let mut graph = plan.graph.clone();
        let joints: Vec<Id> = Plan::inputs(&mut graph, axes, plan.errors).joints;
        let pose: Vec<Id> = plan.tip.iter().chain(&plan.axis).copied().collect();
        let mut all = pose.clone();
        for joint in joints {
            all.extend(graph.derivatives(&pose, joint));
        }
        let inputs = JOINT_INPUT + axes;
        Self { pose: Program::new(&graph, inputs, &pose), derivatives: Program::new(&graph, inputs, &all), axes }
    }

    /// The pose of these joints.
    pub fn pose(&mut self, joints: &[f64], tool: ToolGeometry) -> Pose {
        run(&mut self.pose, joints, tool);
        outputs(&self.pose, 0)
    }

    /// The pose of these joints, and its derivatives: one column for each joint.
    pub fn derivatives(&mut self, joints: &[f64], tool: ToolGeometry, columns: &mut [Pose]) -> Pose {
        assert_eq!(columns.len(), self.axes, "a Jacobian has a column for each joint");
        run(&mut self.derivatives, joints, tool);
        for (joint, column) in columns.iter_mut().enumerate() {
            *column = outputs(&self.derivatives, 6 * (joint + 1));
        }
        outputs(&self.derivatives, 0)
    }
}

fn run(program: &mut Program<1>, joints: &[f64], tool: ToolGeometry) {
    program.input(TOOL_LENGTH_INPUT)[0] = tool.length_mm;
    for (joint, &value) in joints.iter().enumerate() {
        program.input(JOINT_INPUT + joint)[0] = value;
    }
    program.run();
}

fn outputs(program: &Program<1>, first: usize) -> Pose {
    std::array::from_fn(|i| program.output(first + i)[0])
}
