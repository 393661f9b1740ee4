//! The forward chain of the machine as it is: each joint with the six errors that were measured of it.
//!
//! Behind its nominal motion a joint makes a small one: a turn about x, then about y, then about z of the frame, and a shift
//! along these. The directions are those of the side that does not move with the axis (the one nearer to the bed), the
//! centre is a point of the side that does: on the line of a rotary axis; for a linear axis the point that is at the origin
//! of the frame with the axis at zero. The errors count as the axis does: for the tool's side relative to the
//! workpiece's, with a prime for the workpiece's relative to the tool's.

use super::chain::{Chain, Element};
use super::symbolic::{Turn, Vector, add, constant, scale, sub};
use crate::plan::{Graph, Id, Inputs};
use mach_runtime::machine::Component;
use nalgebra::Vector3;

/// Tip and tool axis, from the tool outwards through the joints.
pub(super) fn pose(graph: &mut Graph, chain: &Chain, inputs: &Inputs) -> (Vector, Vector) {
    let mut pose = Pose { tip: chain.tip_at_home(graph, inputs.tool_length), axis: constant(graph, &chain.tool_axis) };
    for element in chain.elements.iter().rev() {
        let value = element.signed(graph, inputs.joints[element.axis]);
        let small = SmallMotion::of(chain, element, inputs);
        // A linear axis carries its errors' centre along, a rotary axis turns about it.
        if element.is_rotary() == element.carries_workpiece {
            small.apply(graph, &mut pose);
            pose.move_by(graph, element, value);
        } else {
            pose.move_by(graph, element, value);
            small.apply(graph, &mut pose);
        }
    }
    (pose.tip, pose.axis)
}

struct Pose {
    tip: Vector,
    axis: Vector,
}

impl Pose {
    /// The nominal motion of a joint.
    fn move_by(&mut self, graph: &mut Graph, element: &Element, value: Id) {
        if element.is_rotary() {
            let turn = Turn::by(graph, value);
            self.turn(graph, turn, &element.direction, &element.point_mm);
        } else {
            let direction = constant(graph, &element.direction);
            let motion = scale(graph, value, direction);
            self.tip = add(graph, self.tip, motion);
        }
    }

    fn turn(&mut self, graph: &mut Graph, turn: Turn, direction: &Vector3<f64>, centre: &Vector3<f64>) {
        self.tip = turn.apply_about(graph, direction, centre, self.tip);
        self.axis = turn.apply(graph, direction, self.axis);
    }
}

/// The six errors of a joint, as far as they were measured.
struct SmallMotion {
    errors: [Option<Id>; 6],
    centre: Vector3<f64>,
    is_inverse: bool,
}

impl SmallMotion {
    fn of(chain: &Chain, element: &Element, inputs: &Inputs) -> Self {
        let input = |component: Component| {
            let place = chain.tables.iter().position(|&table| table == (element.axis, component))?;
            Some(inputs.errors[place])
        };
        let centre = if element.is_rotary() { element.point_mm } else { Vector3::zeros() };
        Self { errors: Component::ALL.map(input), centre, is_inverse: element.primed }
    }

    fn apply(&self, graph: &mut Graph, pose: &mut Pose) {
        let zero = graph.constant(0.0);
        let shift: Vector = std::array::from_fn(|i| self.errors[i].unwrap_or(zero));
        if self.is_inverse {
            pose.tip = sub(graph, pose.tip, shift);
            (0..3).rev().for_each(|about| self.turn(graph, about, pose));
        } else {
            (0..3).for_each(|about| self.turn(graph, about, pose));
            pose.tip = add(graph, pose.tip, shift);
        }
    }

    fn turn(&self, graph: &mut Graph, about: usize, pose: &mut Pose) {
        let Some(angle) = self.errors[3 + about] else { return };
        let angle = if self.is_inverse { graph.neg(angle) } else { angle };
        let turn = Turn::by(graph, angle);
        pose.turn(graph, turn, &Vector3::ith(about, 1.0), &self.centre);
    }
}
