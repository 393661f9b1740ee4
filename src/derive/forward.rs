//! The forward chain: joints in, tip and tool axis in the workpiece frame out.

use super::chain::Chain;
use super::symbolic::{Turn, Vector, add, constant, scale};
use crate::plan::{Graph, Inputs};

/// Tip and tool axis, from the tool outwards through the joints.
pub(super) fn pose(graph: &mut Graph, chain: &Chain, inputs: &Inputs) -> (Vector, Vector) {
    let mut tip = chain.tip_at_home(graph, inputs.tool_length);
    let mut axis = constant(graph, &chain.tool_axis);
    for element in chain.elements.iter().rev() {
        let value = element.signed(graph, inputs.joints[element.axis]);
        if element.is_rotary() {
            let turn = Turn::by(graph, value);
            tip = turn.apply_about(graph, &element.direction, &element.point_mm, tip);
            axis = turn.apply(graph, &element.direction, axis);
        } else {
            let direction = constant(graph, &element.direction);
            let motion = scale(graph, value, direction);
            tip = add(graph, tip, motion);
        }
    }
    (tip, axis)
}
