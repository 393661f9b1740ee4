//! Model to the runtime's tables.

use super::axis_line::AxisLine;
use super::machine::{Model, ModelAxis, ModelJoint};
use mach_runtime::machine::{Axis, Chain, Joint, Machine, Motion};
use nalgebra::{Matrix3, Vector3};

/// The tables of a checked machine.
pub fn machine(model: &Model) -> Machine {
    let at_zero = linear_values(model, &(model.zero_mm - model.tool.gauge_mm));
    let length_shares = linear_values(model, &model.tool.axis);
    let axis = |(index, axis): (usize, &ModelAxis)| Axis {
        name: axis.name.clone(),
        motion: axis.motion,
        travel: axis.travel,
        rule: axis.rule,
        written: axis.written,
        zero: at_zero[index],
        length_share: length_shares[index],
        rapid_per_min: axis.rapid_per_min,
    };
    Machine {
        name: model.name.clone(),
        axes: model.axes.iter().enumerate().map(axis).collect(),
        chain: chain(model),
        branch: model.branch.clone(),
        axis_tolerance_rad: model.axis_tolerance_rad,
        plane_tolerance_mm: model.plane_tolerance_mm,
        chord_tolerance_mm: model.chord_tolerance_mm,
        unknown_records: model.unknown_records,
        zero_mm: model.zero_mm.into(),
        tools: vec![model.tool.geometry()],
        errors: model.errors.tables.clone(),
    }
}

/// Every axis where it really lies: as it is declared, moved by its location errors.
fn chain(model: &Model) -> Chain {
    let joint = |joint: &ModelJoint| {
        let AxisLine { direction, point_mm } = model.line(joint.axis);
        Joint {
            axis: joint.axis,
            motion: model.axes[joint.axis].motion,
            direction: vector(&direction),
            point_mm: vector(&point_mm),
            primed: joint.primed,
        }
    };
    Chain {
        joints: model.chain.iter().map(joint).collect(),
        bed: model.bed,
        tool_axis: vector(&model.tool.axis),
        gauge_mm: vector(&model.tool.gauge_mm),
    }
}

/// Adding zero turns -0 into 0.
fn vector(vector: &Vector3<f64>) -> [f64; 3] {
    [vector.x + 0.0, vector.y + 0.0, vector.z + 0.0]
}

/// The values of the linear axes that move the tool by this vector with the rotary axes at zero, zero for the others; two
/// move it by as much of it as lies in their plane.
fn linear_values(model: &Model, vector: &Vector3<f64>) -> Vec<f64> {
    let is_linear = |axis: &ModelAxis| axis.motion == Motion::Linear && axis.is_solved();
    let linear: Vec<_> = model.chain.iter().filter(|joint| is_linear(&model.axes[joint.axis])).collect();
    let mut columns: Vec<_> =
        linear.iter().map(|joint| model.axes[joint.axis].direction * if joint.primed { -1.0 } else { 1.0 }).collect();
    if let [first, second] = columns[..] {
        columns.push(first.cross(&second));
    }
    let matrix = Matrix3::from_columns(&columns);
    let solution = matrix.try_inverse().expect("the linear axes of a checked machine span space") * vector;
    let mut values = vec![0.0; model.axes.len()];
    for (joint, value) in linear.iter().zip(solution.iter()) {
        values[joint.axis] = value + 0.0;
    }
    values
}
