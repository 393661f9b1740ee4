//! Chain to forward transformation, forward transformation to inverse, both as one plan.
//!
//! Walk the chain from the workpiece to the tool; each joint turns about or moves along its line in the machine frame with
//! every axis at zero, and the product of these exponentials gives the tool in the workpiece frame. The inverse is
//! closed-form: the spherical triangle of the two rotary directions and the tool for the angles (`orientation`), and
//! what is linear in the linear joints for those (`position`).

mod actual;
mod chain;
pub mod family;
mod forward;
mod orientation;
mod position;
pub mod prove;
mod symbolic;

use crate::model::machine::Model;
use crate::plan::{Branch, Graph, Plan};
use chain::{Chain, Element};
use mach_runtime::machine::Motion;

/// Derives the plan of a checked machine.
pub fn derive(model: &Model) -> Plan {
    let chain = Chain::of(model);
    let mut graph = Graph::default();
    let inputs = Plan::inputs(&mut graph, model.axes.len(), model.errors.tables.len());
    let orientation = orientation::solve(&mut graph, &chain, inputs.axis);
    let branches = orientation.branches.iter().map(|angles| branch(&mut graph, &chain, &inputs, angles)).collect();
    let given = chain.angles_from_joints(&mut graph, &inputs.joints);
    let placed = position::solve(&mut graph, &chain, inputs.tip, inputs.tool_length, &given);
    let (tip, axis) = forward::pose(&mut graph, &chain, &inputs);
    let actual = actual::pose(&mut graph, &chain, &inputs);
    Plan {
        branches,
        reach: orientation.reach,
        pole_sine: orientation.pole_sine,
        gap: graph.constant(0.0),
        surplus: Vec::new(),
        free_axis: chain.free_axis(),
        position: chain.joint_values(&mut graph, &given, &placed, &inputs.joints),
        tip,
        axis,
        actual,
        errors: inputs.errors.len(),
        rotary: model.axes.iter().map(|axis| axis.motion == Motion::Rotary).collect(),
        graph,
    }
}

/// One candidate: the joints of all axes for these angles of the rotary elements.
fn branch(graph: &mut Graph, chain: &Chain, inputs: &crate::plan::Inputs, angles: &[crate::plan::Id]) -> Branch {
    let placed = position::solve(graph, chain, inputs.tip, inputs.tool_length, angles);
    Branch { joints: chain.joint_values(graph, angles, &placed, &inputs.joints) }
}

impl Element {
    fn is_rotary(&self) -> bool {
        self.motion == Motion::Rotary
    }
}
