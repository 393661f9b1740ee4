//! Chain to forward transformation, forward transformation to inverse, both as one plan.
//!
//! Walk the chain from the workpiece to the tool; each joint turns about or moves along its line in the machine frame with
//! every axis at zero, and the product of these exponentials gives the tool in the workpiece frame. The inverse is
//! closed-form: the spherical triangle of the two rotary directions and the tool for the angles (`orientation`), or,
//! where the position decides the only one, the two angles that bring the tip to the linear axes (`polar`); and what is
//! linear in the linear joints for those (`position`). Locked joints are constants in all of this, surplus ones inputs.

mod actual;
mod chain;
mod forward;
mod orientation;
mod polar;
mod position;
mod symbolic;

use crate::model::machine::Model;
use crate::plan::{Branch, Graph, Id, Inputs, Plan};
use chain::{Chain, Values};
use mach_runtime::kinematics::Pole;
use mach_runtime::machine::Motion;
use orientation::Orientation;

/// The angles of the rotaries that are solved for, and how far off a solution the pose is.
struct Angles {
    /// For each branch the angle of each solved rotary element, from the workpiece to the tool.
    branches: Vec<Vec<Id>>,
    /// Zero inside the reach, else minus the angle to it.
    reach: Id,
    /// How far it is to the pole: a sine or millimetres.
    pole_distance: Id,
    /// Where the first of them is free, if it ever is.
    pole: Option<Pole>,
    /// How far the tip is from what the linear axes reach, where that is known with the angles.
    gap: Option<Id>,
}

/// Derives the plan of a checked machine.
pub fn derive(model: &Model) -> Plan {
    let chain = Chain::of(model);
    let mut graph = Graph::default();
    let inputs = Plan::inputs(&mut graph, model.axes.len(), model.errors.tables.len());
    let given = chain.given(&mut graph, &inputs.joints);
    let orientation = Orientation::of(&mut graph, &chain, &given, inputs.axis);
    let angles = match orientation.rotary_along_tool(&graph) {
        Some(rotary) if chain.is_planar() => polar::solve(&mut graph, &chain, &inputs, &given, rotary, &orientation),
        _ => orientation.solve(&mut graph),
    };
    let solve = |angles: &Vec<Id>| {
        let known = chain::filled(&given, chain::Element::is_rotary, &chain.elements, angles);
        solved(&mut graph, &chain, &inputs, &known)
    };
    let (branches, gaps): (Vec<_>, Vec<_>) = angles.branches.iter().map(solve).unzip();
    let known = chain.known_from_joints(&mut graph, &inputs.joints);
    let (position, _) = solved(&mut graph, &chain, &inputs, &known);
    let (tip, axis) = forward::pose(&mut graph, &chain, &inputs);
    let actual = actual::pose(&mut graph, &chain, &inputs);
    Plan {
        branches: branches.into_iter().map(|joints| Branch { joints }).collect(),
        reach: angles.reach,
        pole_distance: angles.pole_distance,
        gap: angles.gap.unwrap_or(gaps[0]),
        surplus: chain.surplus_axes(),
        pole: angles.pole,
        position,
        tip,
        axis,
        actual,
        errors: inputs.errors.len(),
        rotary: model.axes.iter().map(|axis| axis.motion == Motion::Rotary).collect(),
        graph,
    }
}

/// The joints of all axes with these elements known and the linear ones solved for; and the gap that is left.
fn solved(graph: &mut Graph, chain: &Chain, inputs: &Inputs, known: &Values) -> (Vec<Id>, Id) {
    let placed = position::solve(graph, chain, inputs.tip, inputs.tool_length, known);
    let values = chain::filled(known, |_| true, &chain.elements, &placed.linear);
    (chain.joint_values(graph, &values, &inputs.joints), placed.gap)
}
