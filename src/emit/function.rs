//! The functions of a plan under the names of its machine: inverse, position and forward.

use super::listing::{Function, Input, Output, Remark};
use crate::compile::Compiled;
use crate::plan::{AXIS_INPUT, Id, JOINT_INPUT, TIP_INPUT, TOOL_LENGTH_INPUT};
use mach_runtime::error_table::ErrorTable;
use mach_runtime::machine::Motion;

/// The indices of the axes whose joints a position is given, and of those it gives.
pub fn given_and_solved(compiled: &Compiled) -> (Vec<usize>, Vec<usize>) {
    let is_given = |&axis: &usize| compiled.plan.rotary[axis] || compiled.plan.surplus.contains(&axis);
    (0..compiled.model.axes.len()).partition(is_given)
}

/// From tip, tool axis, tool length and surplus joints to every solution: the joints of each in the order of the model,
/// then the reach, the sine at the pole and the gap.
pub fn inverse(compiled: &Compiled) -> Function {
    let (plan, several) = (&compiled.plan, compiled.plan.branches.len() > 1);
    let mut outputs = Vec::new();
    for (branch, solution) in plan.branches.iter().enumerate() {
        let suffix = if several { format!("{}", branch + 1) } else { String::new() };
        outputs.extend(solution.joints.iter().enumerate().map(|(axis, &id)| joint(compiled, axis, &suffix, id)));
    }
    outputs.push(Output {
        id: plan.reach,
        name: "reach".to_owned(),
        symbol: None,
        remark: Remark::Meaning("Zero within reach, else minus the angle to it.".to_owned()),
    });
    outputs.push(Output {
        id: plan.pole_sine,
        name: "pole_sine".to_owned(),
        symbol: None,
        remark: Remark::Meaning(pole(compiled)),
    });
    outputs.push(Output {
        id: plan.gap,
        name: "gap".to_owned(),
        symbol: None,
        remark: Remark::Meaning("Zero where the linear axes reach the tip, else how far it is from there.".to_owned()),
    });
    let motion = |output: usize| compiled.model.axes[output % compiled.model.axes.len()].motion;
    let of_branch = |branch: usize| {
        let all = branch * compiled.model.axes.len()..(branch + 1) * compiled.model.axes.len();
        let (rotary, linear): (Vec<usize>, Vec<usize>) = all.partition(|&output| motion(output) == Motion::Rotary);
        rotary.into_iter().chain(linear)
    };
    let joints = plan.branches.len() * compiled.model.axes.len();
    let order = (0..plan.branches.len()).flat_map(of_branch).chain(joints..outputs.len()).collect();
    let surplus = plan.surplus.iter().map(|&axis| joint_input(compiled, axis)).collect();
    Function { inputs: [tip(), tool_axis(), vec![tool_length()], surplus].concat(), outputs, order }
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

/// From tip, tool length and the given joints to the others.
pub fn position(compiled: &Compiled) -> Function {
    let (given, solved) = given_and_solved(compiled);
    let outputs: Vec<Output> =
        solved.into_iter().map(|axis| joint(compiled, axis, "", compiled.plan.position[axis])).collect();
    let given = given.into_iter().map(|axis| joint_input(compiled, axis)).collect();
    let order = (0..outputs.len()).collect();
    Function { inputs: [tip(), vec![tool_length()], given].concat(), outputs, order }
}

/// From joints and tool length to the tip, then to the tool axis.
pub fn forward(compiled: &Compiled) -> Function {
    pose(compiled, (compiled.plan.tip, compiled.plan.axis), vec![])
}

/// From joints, tool length and the errors of the axes to the tip, then to the tool axis.
pub fn forward_actual(compiled: &Compiled) -> Function {
    let tables = compiled.model.errors.tables.iter().enumerate();
    let error = |(place, table): (usize, &ErrorTable)| {
        let name = format!("E{}{}", table.component.letter(), compiled.model.axes[table.axis].name);
        Input { index: JOINT_INPUT + compiled.model.axes.len() + place, name: name.clone(), symbol: name }
    };
    pose(compiled, compiled.plan.actual, tables.map(error).collect())
}

fn pose(compiled: &Compiled, (tip, axis): ([Id; 3], [Id; 3]), errors: Vec<Input>) -> Function {
    let tip = named(["tip_x", "tip_y", "tip_z"], ["x", "y", "z"], tip);
    let axis = named(["i", "j", "k"], ["i", "j", "k"], axis);
    let output = |(name, symbol, id): (&str, &str, _)| Output {
        id,
        name: name.to_owned(),
        symbol: Some(symbol.to_owned()),
        remark: Remark::Stated(compiled.origins.tool.clone()),
    };
    let joints = (0..compiled.model.axes.len()).map(|axis| joint_input(compiled, axis)).collect();
    Function {
        inputs: [joints, vec![tool_length()], errors].concat(),
        outputs: tip.chain(axis).map(output).collect(),
        order: vec![3, 4, 5, 0, 1, 2],
    }
}

fn named<const N: usize, T>(
    names: [&'static str; N],
    symbols: [&'static str; N],
    ids: [T; N],
) -> impl Iterator<Item = (&'static str, &'static str, T)> {
    names.into_iter().zip(symbols).zip(ids).map(|((name, symbol), id)| (name, symbol, id))
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
    let name = &compiled.model.axes[axis].name;
    Input { index: JOINT_INPUT + axis, name: name.clone(), symbol: name.clone() }
}

fn tip() -> Vec<Input> {
    inputs(TIP_INPUT, ["tip_x", "tip_y", "tip_z"], ["x", "y", "z"])
}

fn tool_axis() -> Vec<Input> {
    inputs(AXIS_INPUT, ["i", "j", "k"], ["i", "j", "k"])
}

fn inputs(first: usize, names: [&'static str; 3], symbols: [&'static str; 3]) -> Vec<Input> {
    let input =
        |(name, symbol, index): (&str, &str, usize)| Input { index, name: name.to_owned(), symbol: symbol.to_owned() };
    named(names, symbols, [first, first + 1, first + 2]).map(input).collect()
}

fn tool_length() -> Input {
    Input { index: TOOL_LENGTH_INPUT, name: "tool_length".to_owned(), symbol: "L".to_owned() }
}
