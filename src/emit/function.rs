//! The functions of a plan under the names of its machine: inverse, position and forward.

use super::listing::{Argument, Function, Input, Output, Remark};
use crate::compile::Compiled;
use crate::model::machine::ModelAxis;
use crate::plan::{AXIS_INPUT, Id, InverseOutput, JOINT_INPUT, TIP_INPUT, TOOL_LENGTH_INPUT};
use mach_runtime::kinematics::Pole;
use mach_runtime::machine::{ErrorTable, Motion};

/// A vector's coordinates: names in code, and what people write.
type Coordinates = [(&'static str, &'static str); 3];

const TIP: Coordinates = [("tip_x", "x"), ("tip_y", "y"), ("tip_z", "z")];
const DIRECTION: Coordinates = [("i", "i"), ("j", "j"), ("k", "k")];

/// The indices of the axes whose joints a position is given, and of those it gives.
pub fn given_and_solved(compiled: &Compiled) -> (Vec<usize>, Vec<usize>) {
    let is_given = |&axis: &usize| compiled.plan.rotary[axis] || !compiled.model.axes[axis].is_solved();
    (0..compiled.model.axes.len()).partition(is_given)
}

/// From tip, tool axis, tool length and surplus joints to every solution: the joints of each in the order of the model,
/// then the reach, the distance to the pole and the gap.
pub fn inverse(compiled: &Compiled) -> Function {
    let all = compiled.plan.inverse_outputs();
    // The angles of a solution come before what follows from them.
    let key = |&place: &usize| match all[place].0 {
        InverseOutput::Joint { branch, axis } => (branch, compiled.model.axes[axis].motion == Motion::Linear),
        _ => (compiled.plan.branches.len(), false),
    };
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by_key(key);
    let outputs = all.iter().map(|&(output, id)| solution_part(compiled, output, id)).collect();
    let surplus: Vec<Input> = compiled.plan.surplus.iter().map(|&axis| joint_input(compiled, axis)).collect();
    let mut arguments = vec![tip(), tool_axis(), tool_length()];
    arguments.extend((!surplus.is_empty()).then_some(Argument::Array("surplus", surplus)));
    Function { arguments, outputs, order }
}

fn solution_part(compiled: &Compiled, output: InverseOutput, id: Id) -> Output {
    match output {
        InverseOutput::Joint { branch, axis } => {
            let is_one_of_several = compiled.plan.branches.len() > 1;
            let suffix = if is_one_of_several { (branch + 1).to_string() } else { String::new() };
            joint(compiled, axis, &suffix, id)
        }
        InverseOutput::Reach => scalar("reach", id, "Zero within reach, else minus the angle to it.".to_owned()),
        InverseOutput::PoleDistance => pole(compiled, id),
        InverseOutput::Gap => {
            scalar("gap", id, "Zero where the linear axes reach the tip, else how far it is from there.".to_owned())
        }
    }
}

fn scalar(name: &str, id: Id, meaning: String) -> Output {
    Output { id, name: name.to_owned(), symbol: None, remark: Remark::Meaning(meaning) }
}

fn pole(compiled: &Compiled, id: Id) -> Output {
    let name = |axis: usize| &compiled.model.axes[axis].name;
    let (distance, meaning) = match compiled.plan.pole {
        Some(Pole::Position { axis }) => {
            let what = format!("The distance of the tip from the axis of {0}: at zero, {0} is free.", name(axis));
            ("pole_distance", what)
        }
        Some(Pole::Direction { axis }) => {
            let of = format!("The sine of the angle between the tool and the axis of {0}", name(axis));
            ("pole_sine", format!("{of}: at zero, {} is free.", name(axis)))
        }
        None => ("pole", "No axis is ever free.".to_owned()),
    };
    scalar(distance, id, meaning)
}

/// From tip, tool length and the given joints to the others.
pub fn position(compiled: &Compiled) -> Function {
    let (given, solved) = given_and_solved(compiled);
    let outputs: Vec<Output> =
        solved.into_iter().map(|axis| joint(compiled, axis, "", compiled.plan.position[axis])).collect();
    let given = given.into_iter().map(|axis| joint_input(compiled, axis)).collect();
    let order = (0..outputs.len()).collect();
    Function { arguments: vec![tip(), tool_length(), Argument::Array("given", given)], outputs, order }
}

/// From joints and tool length to the tip, then to the tool axis.
pub fn forward(compiled: &Compiled) -> Function {
    let joints = Argument::Array("joints", joint_inputs(compiled));
    pose(compiled, (compiled.plan.tip, compiled.plan.axis), vec![joints, tool_length()])
}

/// From joints, tool length and the errors of the axes to the tip, then to the tool axis.
pub fn forward_actual(compiled: &Compiled) -> Function {
    let error = |(place, table): (usize, &ErrorTable)| {
        let name = format!("E{}{}", table.component.letter(), compiled.model.axes[table.axis].name);
        Input { index: JOINT_INPUT + compiled.model.axes.len() + place, symbol: name.clone(), name, is_angle: false }
    };
    let errors = compiled.model.errors.tables.iter().enumerate().map(error).collect();
    let joints = Argument::Array("joints", joint_inputs(compiled));
    pose(compiled, compiled.plan.actual, vec![joints, tool_length(), Argument::Array("errors", errors)])
}

fn joint_inputs(compiled: &Compiled) -> Vec<Input> {
    (0..compiled.model.axes.len()).map(|axis| joint_input(compiled, axis)).collect()
}

fn pose(compiled: &Compiled, (tip, axis): ([Id; 3], [Id; 3]), arguments: Vec<Argument>) -> Function {
    let coordinates = TIP.into_iter().zip(tip).chain(DIRECTION.into_iter().zip(axis));
    let output = |((name, symbol), id): ((&str, &str), Id)| Output {
        id,
        name: name.to_owned(),
        symbol: Some(symbol.to_owned()),
        remark: Remark::Stated(compiled.origins.in_generated_text(&compiled.origins.tool)),
    };
    Function { arguments, outputs: coordinates.map(output).collect(), order: vec![3, 4, 5, 0, 1, 2] }
}

fn joint(compiled: &Compiled, axis: usize, suffix: &str, id: Id) -> Output {
    let name = &compiled.model.axes[axis].name;
    Output {
        id,
        name: format!("{name}_{suffix}"),
        symbol: Some(format!("{name}{suffix}")),
        remark: Remark::Stated(compiled.origins.in_generated_text(&compiled.origins.axes[axis])),
    }
}

fn joint_input(compiled: &Compiled, axis: usize) -> Input {
    let ModelAxis { name, motion, .. } = &compiled.model.axes[axis];
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
