//! The chain as the derivation reads it: elements from the workpiece to the tool, all senses positive.

use super::symbolic::Vector;
use crate::model::errors::Line;
use crate::model::machine::Model;
use crate::plan::{Graph, Id};
use mach_runtime::error_table::Component;
use mach_runtime::machine::Motion;
use nalgebra::Vector3;

/// One joint. A primed joint enters with the opposite sense: the element's value is minus the joint's.
pub(super) struct Element {
    pub(super) axis: usize,
    pub(super) primed: bool,
    pub(super) carries_workpiece: bool,
    pub(super) motion: Motion,
    pub(super) direction: Vector3<f64>,
    pub(super) point_mm: Vector3<f64>,
}

/// The chain and the tool at home.
pub(super) struct Chain {
    pub(super) elements: Vec<Element>,
    pub(super) tool_axis: Vector3<f64>,
    pub(super) gauge_mm: Vector3<f64>,
    /// The errors that depend on positions, in the order of the plan's inputs.
    pub(super) tables: Vec<(usize, Component)>,
    axis_count: usize,
}

impl Chain {
    pub(super) fn of(model: &Model) -> Self {
        let element = |(place, joint): (usize, &crate::model::machine::Joint)| {
            let Line { direction, point_mm } = model.line(joint.axis);
            Element {
                axis: joint.axis,
                primed: joint.primed,
                carries_workpiece: place < model.bed,
                motion: model.axes[joint.axis].motion,
                direction,
                point_mm,
            }
        };
        Self {
            elements: model.chain.iter().enumerate().map(element).collect(),
            tables: model.errors.tables.iter().map(|table| (table.axis, table.component)).collect(),
            tool_axis: model.tool.axis,
            gauge_mm: model.tool.gauge_mm,
            axis_count: model.axes.len(),
        }
    }

    /// The rotary elements, from the workpiece to the tool.
    pub(super) fn rotaries(&self) -> impl Iterator<Item = &Element> {
        self.elements.iter().filter(|element| element.is_rotary())
    }

    /// The first rotary: with the tool along its direction it can turn freely.
    pub(super) fn free_axis(&self) -> Option<usize> {
        let mut rotaries = self.rotaries();
        let first = rotaries.next()?;
        rotaries.next().map(|_| first.axis)
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

    /// The angles of the rotary elements for given joints.
    pub(super) fn angles_from_joints(&self, graph: &mut Graph, joints: &[Id]) -> Vec<Id> {
        self.rotaries().map(|element| element.signed(graph, joints[element.axis])).collect()
    }

    /// The joints of all axes, in the order of the model, for the angles of the rotary elements and the values of the
    /// linear ones.
    pub(super) fn joint_values(&self, graph: &mut Graph, angles: &[Id], linear: &[Id], joints: &[Id]) -> Vec<Id> {
        let (mut angles, mut linear) = (angles.iter(), linear.iter());
        let mut values = joints.to_vec();
        assert_eq!(values.len(), self.axis_count, "a checked chain holds every axis once");
        for element in &self.elements {
            let value = if element.is_rotary() { angles.next() } else { linear.next() };
            let value = *value.expect("one value for each element");
            values[element.axis] = element.signed(graph, value);
        }
        values
    }
}

impl Element {
    /// A joint's value as the element's, or the other way round.
    pub(super) fn signed(&self, graph: &mut Graph, value: Id) -> Id {
        if self.primed { graph.neg(value) } else { value }
    }
}
