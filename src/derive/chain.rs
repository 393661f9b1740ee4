//! The chain as the derivation reads it: elements from the workpiece to the tool, all senses positive.

use super::symbolic::Vector;
use crate::model::axis_line::AxisLine;
use crate::model::machine::{Model, ModelJoint};
use crate::plan::{Graph, Id};
use mach_runtime::machine::{Component, Motion, Rule};
use nalgebra::Vector3;

/// One joint. A primed joint enters with the opposite sense: the element's value is minus the joint's.
pub(super) struct Element {
    pub(super) axis: usize,
    pub(super) primed: bool,
    pub(super) carries_workpiece: bool,
    pub(super) motion: Motion,
    pub(super) direction: Vector3<f64>,
    pub(super) point_mm: Vector3<f64>,
    rule: Rule,
}

/// The chain and the tool at home.
pub(super) struct Chain {
    pub(super) elements: Vec<Element>,
    pub(super) tool_axis: Vector3<f64>,
    pub(super) gauge_mm: Vector3<f64>,
    /// The errors that depend on positions, in the order of the plan's inputs.
    pub(super) tables: Vec<(usize, Component)>,
}

/// What is known of each element's value (in radians or millimetres), in the order of the chain.
pub(super) type Values = Vec<Option<Id>>;

impl Chain {
    pub(super) fn of(model: &Model) -> Self {
        let element = |(place, joint): (usize, &ModelJoint)| {
            let AxisLine { direction, point_mm } = model.line(joint.axis);
            Element {
                axis: joint.axis,
                primed: joint.primed,
                carries_workpiece: place < model.bed,
                motion: model.axes[joint.axis].motion,
                direction,
                point_mm,
                rule: model.axes[joint.axis].rule,
            }
        };
        assert_eq!(model.chain.len(), model.axes.len(), "a checked chain holds every axis once");
        Self {
            elements: model.chain.iter().enumerate().map(element).collect(),
            tables: model.errors.tables.iter().map(|table| (table.axis, table.component)).collect(),
            tool_axis: model.tool.axis,
            gauge_mm: model.tool.gauge_mm,
        }
    }

    /// Whether there are only two linear axes to be solved for.
    pub(super) fn is_planar(&self) -> bool {
        self.elements.iter().filter(|element| element.motion == Motion::Linear && element.is_solved()).count() == 2
    }

    /// The axes that the pose leaves open, in the order of the model.
    pub(super) fn surplus_axes(&self) -> Vec<usize> {
        let surplus = self.elements.iter().filter(|element| element.rule.is_surplus());
        let mut axes: Vec<usize> = surplus.map(|element| element.axis).collect();
        axes.sort_unstable();
        axes
    }

    /// The tip with every axis at zero.
    pub(super) fn tip_at_home(&self, graph: &mut Graph, tool_length: Id) -> Vector {
        std::array::from_fn(|i| {
            let gauge = graph.constant(self.gauge_mm[i]);
            let along = graph.constant(self.tool_axis[i]);
            let length = graph.mul(along, tool_length);
            graph.sub(gauge, length)
        })
    }

    /// What an inverse knows: the locked axes and the surplus ones.
    pub(super) fn given(&self, graph: &mut Graph, joints: &[Id]) -> Values {
        let value = |element: &Element| match element.rule {
            Rule::Pose => None,
            Rule::Locked(value) => {
                let value = if element.is_rotary() { value.to_radians() } else { value };
                let value = graph.constant(value);
                Some(element.signed(graph, value))
            }
            Rule::Preferred(_) | Rule::Free => Some(element.signed(graph, joints[element.axis])),
        };
        self.elements.iter().map(value).collect()
    }

    /// What is known when all joints are given but the linear ones that follow from the tip.
    pub(super) fn known_from_joints(&self, graph: &mut Graph, joints: &[Id]) -> Values {
        let follows = |element: &Element| !element.is_rotary() && element.is_solved();
        let value = |element: &Element| (!follows(element)).then(|| element.signed(graph, joints[element.axis]));
        self.elements.iter().map(value).collect()
    }

    /// The joints of all axes, in the order of the model, for the values of the elements.
    pub(super) fn joint_values(&self, graph: &mut Graph, values: &Values, joints: &[Id]) -> Vec<Id> {
        let mut joints = joints.to_vec();
        for (element, value) in self.elements.iter().zip(values) {
            joints[element.axis] = element.signed(graph, value.expect("every element has been solved for"));
        }
        joints
    }
}

impl Element {
    pub(super) fn is_rotary(&self) -> bool {
        self.motion == Motion::Rotary
    }

    /// Whether its value follows from the pose.
    pub(super) fn is_solved(&self) -> bool {
        self.rule == Rule::Pose
    }

    /// A joint's value as the element's, or the other way round.
    pub(super) fn signed(&self, graph: &mut Graph, value: Id) -> Id {
        if self.primed { graph.neg(value) } else { value }
    }
}

/// The values with these in the places that were open, in their order.
pub(super) fn filled(values: &Values, into: impl Fn(&Element) -> bool, elements: &[Element], with: &[Id]) -> Values {
    let mut with = with.iter().copied();
    let fill = |(value, element): (&Option<Id>, &Element)| match value {
        None if into(element) => Some(with.next().expect("one value for each open place")),
        known => *known,
    };
    values.iter().zip(elements).map(fill).collect()
}
