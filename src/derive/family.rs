//! What the field calls such a machine.

use crate::model::machine::Model;
use mach_runtime::machine::Motion;
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

/// The rotary axes of the chain, from the workpiece to the tool, as indices into the model's axes, each with whether it
/// carries the workpiece.
pub fn rotaries(model: &Model) -> Vec<(usize, bool)> {
    let rotary = |(place, joint): (usize, &crate::model::machine::Joint)| {
        (model.axes[joint.axis].motion == Motion::Rotary).then_some((joint.axis, place < model.bed))
    };
    model.chain.iter().enumerate().filter_map(rotary).collect()
}

/// The family in the field's words: `table/table, orthogonal`.
pub fn family(model: &Model) -> String {
    let rotaries = rotaries(model);
    let side = |&(_, carries_workpiece): &(usize, bool)| if carries_workpiece { "table" } else { "head" };
    match &rotaries[..] {
        [] => "3 axes".to_owned(),
        [only] => format!("4 axes, rotary {}", side(only)),
        [first, second] => {
            // The field names the head first.
            let sides = if side(first) == side(second) { [side(first); 2] } else { ["head", "table"] };
            format!("5 axes, {}/{}, {}{}", sides[0], sides[1], squareness(model, first.0, second.0), between(model))
        }
        _ => unreachable!("a checked chain has at most two rotary axes"),
    }
}

fn squareness(model: &Model, first: usize, second: usize) -> String {
    let alpha = angle(&model.axes[first].direction, &model.axes[second].direction);
    let beta = angle(&model.axes[second].direction, &model.tool.axis);
    let is_square = |angle: f64| (angle - FRAC_PI_2).abs() < SAME_ANGLE_RAD;
    match (is_square(alpha), is_square(beta)) {
        (true, true) => "orthogonal".to_owned(),
        _ => format!(
            "nutating at {} deg",
            crate::emit::equations::number(alpha.min(std::f64::consts::PI - alpha).to_degrees())
        ),
    }
}

fn between(model: &Model) -> &'static str {
    let is_linear = |place: usize| model.axes[model.chain[place].axis].motion == Motion::Linear;
    let linear: Vec<usize> = (0..model.chain.len()).filter(|&place| is_linear(place)).collect();
    let contiguous = linear.windows(2).all(|pair| pair[1] == pair[0] + 1);
    if contiguous { "" } else { ", with a rotary between linear axes" }
}

/// The cone of directions that the rotary axes can reach, by their directions alone; `None` without a rotary.
pub fn reach(model: &Model) -> Option<Reach> {
    match rotaries(model)[..] {
        [] => None,
        [(only, _)] => {
            let about = model.line(only).direction;
            let beta = angle(&about, &model.tool.axis);
            Some(Reach { about, least_rad: beta, greatest_rad: beta })
        }
        [(first, _), (second, _), ..] => {
            let about = model.line(first).direction;
            let second = model.line(second).direction;
            let alpha = angle(&about, &second);
            let beta = angle(&second, &model.tool.axis);
            let sum = alpha + beta;
            let greatest_rad = sum.min(2.0 * std::f64::consts::PI - sum);
            Some(Reach { about, least_rad: (alpha - beta).abs(), greatest_rad })
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
