//! What the field calls such a machine.

use super::directions;
use super::machine::{Model, ModelJoint};
use super::number::number;
use mach_runtime::machine::{Motion, Rule};
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// Angles that differ by less than this are what they look like: far below any machine's squareness.
const SAME_ANGLE_RAD: f64 = 1e-9;

/// Which way the rotary axes stand to each other and to the tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reach {
    /// The direction the cone is about, in the workpiece.
    pub about: Vector3<f64>,
    /// The least angle from it.
    pub least_rad: f64,
    /// The greatest angle from it.
    pub greatest_rad: f64,
}

/// A rotary axis that the pose decides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotary {
    /// Its index in the model's axes.
    pub axis: usize,
    /// Whether it carries the workpiece.
    pub carries_workpiece: bool,
    /// Its direction where the axes stand that the pose does not decide.
    pub direction: Vector3<f64>,
}

/// The rotary axes that the pose decides, from the workpiece to the tool.
pub fn rotaries(model: &Model) -> Vec<Rotary> {
    let (directions, _) = directions::of_model(model);
    let rotary = |(place, joint): (usize, &ModelJoint)| {
        let axis = &model.axes[joint.axis];
        let rotary = Rotary { axis: joint.axis, carries_workpiece: place < model.bed, direction: directions[place] };
        (axis.motion == Motion::Rotary && axis.is_solved()).then_some(rotary)
    };
    model.chain.iter().enumerate().filter_map(rotary).collect()
}

/// The linear axes that the pose decides, by name, from the workpiece to the tool.
pub fn linears(model: &Model) -> Vec<&str> {
    let axes = model.chain.iter().map(|joint| &model.axes[joint.axis]);
    axes.filter(|axis| axis.motion == Motion::Linear && axis.is_solved()).map(|axis| axis.name.as_str()).collect()
}

/// The tool's direction where the axes stand that the pose does not decide.
pub fn tool(model: &Model) -> Vector3<f64> {
    directions::of_model(model).1
}

/// The rotary axis that the position decides, of a machine with two linear axes.
pub fn polar(model: &Model) -> Option<Rotary> {
    let [only] = rotaries(model)[..] else { return None };
    let turns_about_tool = only.direction.cross(&tool(model)).norm() < directions::ALONG_SINE;
    (linears(model).len() == 2 && turns_about_tool).then_some(only)
}

/// The class in the field's words: `5 axes, table/table, orthogonal`.
pub fn class(model: &Model) -> String {
    let rotaries = rotaries(model);
    let side = |rotary: &Rotary| if rotary.carries_workpiece { "table" } else { "head" };
    let kind = match &rotaries[..] {
        [only] if linears(model).len() == 2 => planar(model, only),
        [] => String::new(),
        [only] => format!(", rotary {}", side(only)),
        [first, second] => {
            // The field names the head first.
            let sides = if side(first) == side(second) { [side(first); 2] } else { ["head", "table"] };
            format!(", {}/{}, {}{}", sides[0], sides[1], squareness(model, first, second), between(model))
        }
        _ => unreachable!("of a checked machine the pose decides at most two rotary axes"),
    };
    format!("{} axes{kind}{}", model.axes.len(), surplus(model))
}

/// Two linear axes and a rotary one: `mill-turn, polar X Z C`.
fn planar(model: &Model, rotary: &Rotary) -> String {
    let kind = if rotary.carries_workpiece { ", mill-turn" } else { "" };
    let polar = if polar(model).is_some() { "polar " } else { "" };
    format!("{kind}, {polar}{} {}", in_order(model, &linears(model)).join(" "), model.axes[rotary.axis].name)
}

/// In the order of declaration.
fn in_order<'m>(model: &'m Model, names: &[&str]) -> Vec<&'m str> {
    model.axes.iter().map(|axis| axis.name.as_str()).filter(|name| names.contains(name)).collect()
}

/// What the other axes do: `, with a free A and W locked`.
fn surplus(model: &Model) -> String {
    let said = model.axes.iter().filter_map(|axis| match axis.rule {
        Rule::Pose => None,
        Rule::Locked(_) => Some(format!("{} locked", axis.name)),
        Rule::Preferred(_) => Some(format!("{} preferred", axis.name)),
        Rule::Free => Some(format!("a free {}", axis.name)),
    });
    let said: Vec<String> = said.collect();
    if said.is_empty() { String::new() } else { format!(", with {}", said.join(" and ")) }
}

fn squareness(model: &Model, first: &Rotary, second: &Rotary) -> String {
    let alpha = angle(&first.direction, &second.direction);
    let beta = angle(&second.direction, &tool(model));
    let is_square = |angle: f64| (angle - FRAC_PI_2).abs() < SAME_ANGLE_RAD;
    match (is_square(alpha), is_square(beta)) {
        (true, true) => "orthogonal".to_owned(),
        _ => format!("nutating at {} deg", number(alpha.min(std::f64::consts::PI - alpha).to_degrees())),
    }
}

fn between(model: &Model) -> &'static str {
    let is_linear = |place: usize| model.axes[model.chain[place].axis].motion == Motion::Linear;
    let linear: Vec<usize> = (0..model.chain.len()).filter(|&place| is_linear(place)).collect();
    let contiguous = linear.windows(2).all(|pair| pair[1] == pair[0] + 1);
    if contiguous { "" } else { ", with a rotary between linear axes" }
}

/// The cone of directions that the rotary axes can reach, by their directions alone; `None` where no rotary turns the tool.
pub fn reach(model: &Model) -> Option<Reach> {
    match rotaries(model)[..] {
        [] => None,
        _ if polar(model).is_some() => None,
        [only] => {
            let beta = angle(&only.direction, &tool(model));
            Some(Reach { about: only.direction, least_rad: beta, greatest_rad: beta })
        }
        [first, second, ..] => {
            let alpha = angle(&first.direction, &second.direction);
            let beta = angle(&second.direction, &tool(model));
            let sum = alpha + beta;
            let greatest_rad = sum.min(2.0 * std::f64::consts::PI - sum);
            Some(Reach { about: first.direction, least_rad: (alpha - beta).abs(), greatest_rad })
        }
    }
}

/// The directions of the tool in the workpiece at which the first of two rotaries is free.
pub fn poles(model: &Model) -> Vec<Vector3<f64>> {
    let (Some(reach), true) = (reach(model), rotaries(model).len() == 2) else { return Vec::new() };
    let at_zero = (reach.least_rad < SAME_ANGLE_RAD).then_some(reach.about);
    let at_half_turn = (reach.greatest_rad > std::f64::consts::PI - SAME_ANGLE_RAD).then_some(-reach.about);
    at_zero.into_iter().chain(at_half_turn).collect()
}

fn angle(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    libm::atan2(a.cross(b).norm(), a.dot(b))
}
