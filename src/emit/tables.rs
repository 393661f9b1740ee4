//! Model to the runtime's tables.

use crate::model::machine::Model;
use mach_runtime::machine::{Axis, Machine, Motion};
use nalgebra::{Matrix3, Vector3};

/// The tables of a checked machine.
pub fn machine(model: &Model) -> Machine {
    let at_zero = linear_values(model, &(model.zero_mm - model.tool.gauge_mm));
    let length_shares = linear_values(model, &model.tool.axis);
    let axis = |(index, axis): (usize, &crate::model::machine::Axis)| Axis {
        name: axis.name.clone(),
        motion: axis.motion,
        travel: axis.travel,
        written: axis.written,
        zero: at_zero[index],
        length_share: length_shares[index],
        rapid_per_min: axis.rapid_per_min,
    };
    Machine {
        name: model.name.clone(),
        axes: model.axes.iter().enumerate().map(axis).collect(),
        branch: model.branch.clone(),
        axis_tolerance_rad: model.axis_tolerance_rad,
        chord_tolerance_mm: model.chord_tolerance_mm,
        unknown_records: model.unknown_records,
        zero_mm: model.zero_mm.into(),
        tool_length_mm: model.tool.length_mm,
        errors: model.errors.tables.clone(),
    }
}

/// The values of the linear axes that move the tool by this vector with the rotary axes at zero; zero for the rotary ones.
fn linear_values(model: &Model, vector: &Vector3<f64>) -> Vec<f64> {
    let linear: Vec<_> = model.chain.iter().filter(|joint| model.axes[joint.axis].motion == Motion::Linear).collect();
    let columns: Vec<_> =
        linear.iter().map(|joint| model.axes[joint.axis].direction * if joint.primed { -1.0 } else { 1.0 }).collect();
    let matrix = Matrix3::from_columns(&columns);
    let solution = matrix.try_inverse().expect("the linear axes of a checked machine span space") * vector;
    let mut values = vec![0.0; model.axes.len()];
    for (joint, value) in linear.iter().zip(solution.iter()) {
        values[joint.axis] = value + 0.0;
    }
    values
}
