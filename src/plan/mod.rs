//! The plan: straight-line scalar programs derived from the chain.
//!
//! A [`Graph`] is built symbolically and simplifies as it grows. A [`Program`] is what is left of it for a set of
//! outputs, with registers assigned; it is interpreted over blocks of poses. The same graph is printed as equations.

mod derivative;
mod graph;
mod interpreter;
mod jacobian;
mod outputs;
mod program;
mod simplify;
mod trigonometry;

pub use graph::{Graph, Id, Op};
pub use interpreter::Interpreter;
pub use jacobian::{Jacobian, Pose};
pub use outputs::InverseOutput;
pub use program::Program;
pub use trigonometry::{cos_constant, sin_constant, snap};

use mach_runtime::kinematics::Pole;

/// Everything that was derived of a machine: outputs of one graph. Angles are in radians, lengths in millimetres.
#[derive(Debug, Clone)]
pub struct Plan {
    /// The expressions.
    pub graph: Graph,
    /// The candidates of the inverse; inputs are tip, axis, tool length and the surplus joints. None where there is no closed
    /// form: then the inverse is iterated for.
    pub branches: Vec<Branch>,
    /// Zero inside the reach, else minus the angle to it.
    pub reach: Id,
    /// How far it is to the pole: a sine or millimetres.
    pub pole_distance: Id,
    /// Where an axis is free, if one ever is.
    pub pole: Option<Pole>,
    /// Zero where the linear axes reach the tip, else how far it is from there, in millimetres.
    pub gap: Id,
    /// The axes whose values the inverse takes instead of giving.
    pub surplus: Vec<usize>,
    /// The joints for given rotary joints; inputs are tip, tool length, the rotary joints and the surplus ones.
    pub position: Vec<Id>,
    /// The tip, from tool length and joints.
    pub tip: [Id; 3],
    /// The tool axis, from the joints.
    pub axis: [Id; 3],
    /// Tip and tool axis with the machine's errors, from tool length, joints and errors.
    pub actual: ([Id; 3], [Id; 3]),
    /// How many errors there are.
    pub errors: usize,
    /// Which axes are rotary.
    pub rotary: Vec<bool>,
}

/// One candidate of the inverse.
#[derive(Debug, Clone)]
pub struct Branch {
    /// The joint of each axis, in the order of the model.
    pub joints: Vec<Id>,
}

/// The inputs of a plan.
#[derive(Debug, Clone)]
pub struct Inputs {
    /// The wanted tip.
    pub tip: [Id; 3],
    /// The wanted unit tool axis.
    pub axis: [Id; 3],
    /// The tool's gauge length.
    pub tool_length: Id,
    /// The joints, in the order of the model.
    pub joints: Vec<Id>,
    /// The errors, one for each of the model's tables: millimetres or radians.
    pub errors: Vec<Id>,
}

/// Where the inputs stand: tip, axis, tool length, joints; the errors follow the joints.
pub const TIP_INPUT: usize = 0;
/// See [`TIP_INPUT`].
pub const AXIS_INPUT: usize = 3;
/// See [`TIP_INPUT`].
pub const TOOL_LENGTH_INPUT: usize = 6;
/// See [`TIP_INPUT`].
pub const JOINT_INPUT: usize = 7;

impl Plan {
    /// Whether the inverse was derived.
    pub fn has_closed_form(&self) -> bool {
        !self.branches.is_empty()
    }

    /// The inputs of a plan for so many axes and errors.
    pub fn inputs(graph: &mut Graph, axes: usize, errors: usize) -> Inputs {
        Inputs {
            tip: std::array::from_fn(|i| graph.input(TIP_INPUT + i)),
            axis: std::array::from_fn(|i| graph.input(AXIS_INPUT + i)),
            tool_length: graph.input(TOOL_LENGTH_INPUT),
            joints: (0..axes).map(|axis| graph.input(JOINT_INPUT + axis)).collect(),
            errors: (0..errors).map(|error| graph.input(JOINT_INPUT + axes + error)).collect(),
        }
    }
}
