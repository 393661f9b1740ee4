//! The functions of a plan under the names of its machine: inverse, position and forward.

use super::listing::{Argument, Function, Input, Output, Remark};
use crate::compile::Compiled;
use crate::model::machine::Axis;
use crate::plan::{AXIS_INPUT, Id, JOINT_INPUT, TIP_INPUT, TOOL_LENGTH_INPUT};
use mach_runtime::machine::Motion;

/// A vector's coordinates: names in code, and what people write.
type Coordinates = [(&'static str, &'static str); 3];

const TIP: Coordinates = [("tip_x", "x"), ("tip_y", "y"), ("tip_z", "z")];
const DIRECTION: Coordinates = [("i", "i"), ("j", "j"), ("k", "k")];

/// The indices of the axes that move like this.
pub fn axes(compiled: &Compiled, motion: Motion) -> Vec<usize> {
    (0..compiled.model.axes.len()).filter(|&axis| compiled.model.axes[axis].motion == motion).collect()
}

/// From tip, tool axis and tool length to every solution: the joints of each in the order of the model, then the reach and
/// the sine at the pole.
pub fn inverse(compiled: &Compiled) -> Function {
    let branches = &compiled.plan.branches;
    let mut outputs = Vec::new();
    for (branch, solution) in branches.iter().enumerate() {
        let suffix = if branches.len() > 1 { (branch + 1).to_string() } else { String::new() };
        outputs.extend(solution.joints.iter().enumerate().map(|(axis, &id)| joint(compiled, axis, &suffix, id)));
    }
    outputs.push(scalar("reach", compiled.plan.reach, "Zero within reach, else minus the angle to it.".to_owned()));
    outputs.push(scalar("pole_sine", compiled.plan.pole_sine, pole(compiled)));
    // The angles of a solution come before what follows from them.
    let axes = compiled.model.axes.len();
    let key = |&output: &usize| {
        let is_linear = compiled.model.axes[output % axes].motion == Motion::Linear;
        (output / axes, output < branches.len() * axes && is_linear)
    };
    let mut order: Vec<usize> = (0..outputs.len()).collect();
    order.sort_by_key(key);
    Function { arguments: vec![tip(), tool_axis(), tool_length()], outputs, order }
}

fn scalar(name: &str, id: Id, meaning: String) -> Output {
    Output { id, name: name.to_owned(), symbol: None, remark: Remark::Meaning(meaning) }
}

fn pole(compiled: &Compiled) -> String {
    match compiled.plan.free_axis {
        Some(axis) => {
            let name = &compiled.model.axes[axis].name;
            format!("The sine of the angle between the tool and the axis of {name}: at zero, {name} is free.")
        }
        None => "No axis is ever free.".to_owned(),
    }
}

/// From tip, tool length and rotary joints to the linear joints.
pub fn position(compiled: &Compiled) -> Function {
    let linear = axes(compiled, Motion::Linear);
    let outputs: Vec<Output> =
        linear.into_iter().map(|axis| joint(compiled, axis, "", compiled.plan.position[axis])).collect();
    let rotary = axes(compiled, Motion::Rotary).into_iter().map(|axis| joint_input(compiled, axis)).collect();
    let order = (0..outputs.len()).collect();
    Function { arguments: vec![tip(), tool_length(), Argument::Array("rotary", rotary)], outputs, order }
}

/// From joints and tool length to the tip, then to the tool axis.
pub fn forward(compiled: &Compiled) -> Function {
    let coordinates = TIP.into_iter().zip(compiled.plan.tip).chain(DIRECTION.into_iter().zip(compiled.plan.axis));
    let output = |((name, symbol), id): ((&str, &str), Id)| Output {
        id,
        name: name.to_owned(),
        symbol: Some(symbol.to_owned()),
        remark: Remark::Stated(compiled.origins.tool.clone()),
    };
    let joints = (0..compiled.model.axes.len()).map(|axis| joint_input(compiled, axis)).collect();
    Function {
        arguments: vec![Argument::Array("joints", joints), tool_length()],
        outputs: coordinates.map(output).collect(),
        order: vec![3, 4, 5, 0, 1, 2],
    }
}

fn joint(compiled: &Compiled, axis: usize, suffix: &str, id: Id) -> Output {
    let name = &compiled.model.axes[axis].name;
    Output {
        id,
        name: format!("{name}_{suffix}"),
        symbol: Some(format!("{name}{suffix}")),
        remark: Remark::Stated(compiled.origins.axes[axis].clone()),
    }
}

fn joint_input(compiled: &Compiled, axis: usize) -> Input {
    let Axis { name, motion, .. } = &compiled.model.axes[axis];
    Input { index: JOINT_INPUT + axis, name: name.clone(), symbol: name.clone(), is_angle: *motion == Motion::Rotary }
}

fn tip() -> Argument {
    vector("tip", TIP_INPUT, TIP)
}

fn tool_axis() -> Argument {
    vector("axis", AXIS_INPUT, DIRECTION)
}

fn vector(name: &'static str, first: usize, coordinates: Coordinates) -> Argument {
    let inputs = coordinates.into_iter().zip(first..);
    Argument::Array(name, inputs.map(|((name, symbol), index)| length(name, symbol, index)).collect())
}

fn tool_length() -> Argument {
    Argument::Number(length("tool_length", "L", TOOL_LENGTH_INPUT))
}

fn length(name: &str, symbol: &str, index: usize) -> Input {
    Input { index, name: name.to_owned(), symbol: symbol.to_owned(), is_angle: false }
}
