//! The data sheet of a machine: what `machc show` prints.

use super::measured;
use super::spelling::Spelling;
use super::transformation::{self, Inverse};
use crate::model::class::{self, Rotary};
use crate::model::directions;
use crate::model::machine::{Model, ModelAxis};
use crate::model::number::{number, vector};
use crate::plan::{Interpreter, Plan};
use crate::prove::Proof;
use mach_runtime::kinematics::{Kinematics, LANES, Miss, Outcome, PoseBlock, SolutionBlock, Tolerances};
use mach_runtime::machine::{Motion, Rule, Written};
use std::fmt::Write;

/// The whole sheet, as text of at most 80 columns where the equations allow it.
pub fn data_sheet(model: &Model, plan: &Plan, proof: &Proof) -> String {
    let mut sheet = heading(model);
    for (title, lines) in [
        ("axes", model.axes.iter().map(axis).collect()),
        ("errors", measured::errors(model)),
        ("constants", constants(model)),
        ("forward transformation", transformation::forward(model, plan, Spelling::Plain).concat()),
        ("inverse transformation", inverse(model, plan)),
        ("reach", reach(model, plan)),
        ("proof", proved(proof)),
    ] {
        section(&mut sheet, title, lines);
    }
    sheet
}

fn heading(model: &Model) -> String {
    let title = model.title.as_ref().map(|title| format!("  {title}")).unwrap_or_default();
    format!("{}{title}\n\nchain   {}\nfamily  {}\n", model.name, chain(model), class::class(model))
}

fn section(sheet: &mut String, title: &str, lines: Vec<String>) {
    if lines.is_empty() {
        return;
    }
    let body = lines.iter().fold(String::new(), |body, line| body + "  " + line + "\n");
    write!(sheet, "\n{title}\n{body}").expect("writing to a string does not fail");
}

/// The structural code: `w C' A' b X Y Z t`.
pub(super) fn chain(model: &Model) -> String {
    let mut links: Vec<String> = model
        .chain
        .iter()
        .map(|joint| format!("{}{}", model.axes[joint.axis].name, if joint.primed { "'" } else { "" }))
        .collect();
    links.insert(model.bed, "b".to_owned());
    format!("w {} t", links.join(" "))
}

pub(super) fn axis(axis: &ModelAxis) -> String {
    let (kind, preposition, unit) = match axis.motion {
        Motion::Linear => ("linear", "along", "mm"),
        Motion::Rotary => ("rotary", "about", "deg"),
    };
    let mut line = format!("{}  {kind} {preposition} {}", axis.name, vector(&axis.direction));
    if axis.motion == Motion::Rotary {
        line += &format!(" through {}", vector(&axis.point_mm));
    }
    let travel = match (axis.travel.lower.is_finite(), axis.travel.upper.is_finite()) {
        (false, false) => "unlimited".to_owned(),
        _ => format!("{} .. {} {unit}", number(axis.travel.lower), number(axis.travel.upper)),
    };
    let written = match axis.written {
        Written::Unwound => String::new(),
        Written::Wrapped { from_deg } => format!(", written {} .. {}", number(from_deg), number(from_deg + 360.0)),
    };
    let rule = match axis.rule {
        Rule::Pose => String::new(),
        Rule::Locked(value) => format!(", locked at {} {unit}", number(value)),
        Rule::Preferred(value) => format!(", preferred at {} {unit}", number(value)),
        Rule::Free => ", free".to_owned(),
    };
    format!("{line}, travel {travel}{written}{rule}")
}

pub(super) fn constants(model: &Model) -> Vec<String> {
    let mut lines: Vec<String> = model.parameters.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    lines.push(format!("tool axis at home {}, gauge point {}", vector(&model.tool.axis), vector(&model.tool.gauge_mm)));
    lines.push(format!("tool length L = {} mm, program zero {}", number(model.tool.length_mm), vector(&model.zero_mm)));
    lines
}

/// The joints from tip and tool axis: the rotary ones for each branch, then the linear ones for either.
fn inverse(model: &Model, plan: &Plan) -> Vec<String> {
    let Inverse { given, shared, solutions, linear } = transformation::inverse(model, plan, Spelling::Plain);
    if let [only] = &solutions[..] {
        return given.into_iter().chain(shared).chain(only.clone()).chain(linear).collect();
    }
    let indented = |lines: Vec<String>| lines.into_iter().map(|line| format!("  {line}"));
    let mut lines: Vec<String> = given.into_iter().chain(shared).collect();
    for (index, solution) in solutions.into_iter().enumerate() {
        lines.push(format!("solution {}", index + 1));
        lines.extend(indented(solution));
    }
    lines.push("for either solution".to_owned());
    lines.extend(indented(linear));
    lines
}

pub(super) fn reach(model: &Model, plan: &Plan) -> Vec<String> {
    let turns = |axis: &&ModelAxis| axis.motion == Motion::Rotary && axis.rule.is_surplus();
    let stands = |axis: &ModelAxis| format!("{} at {} deg", axis.name, number(directions::value(axis)));
    let surplus: Vec<String> = model.axes.iter().filter(turns).map(stands).collect();
    let standing = format!("with {}:", surplus.join(" and "));
    let lines = if let Some(rotary) = class::polar(model) { polar(model, plan, &rotary) } else { cone(model) };
    (!surplus.is_empty()).then_some(standing).into_iter().chain(lines).collect()
}

/// The tips that X Z C reaches.
fn polar(model: &Model, plan: &Plan, rotary: &Rotary) -> Vec<String> {
    let (axis, mut poses) = (&model.axes[rotary.axis], PoseBlock::ZERO);
    poses.set(0, model.line(rotary.axis).point_mm.into(), class::tool(model).into());
    let mut machine = Interpreter::new(plan);
    let mut solutions = SolutionBlock::of(&machine);
    let surplus = vec![[0.0; LANES]; machine.surplus_axes().len()];
    machine.inverse(&poses, &surplus, model.tool.geometry(), &mut solutions);
    let tolerances = Tolerances { axis_rad: model.axis_tolerance_rad, plane_mm: 0.0 };
    let dead_mm = match solutions.outcome(0, tolerances) {
        Outcome::Missed(Miss::InsideDeadRadius { gap_mm, .. }) => (gap_mm * 1e9).round() / 1e9,
        _ => 0.0,
    };
    let only = format!("tool axis {} only", vector(&class::tool(model)));
    let at_centre = match (dead_mm == 0.0, rotary.carries_workpiece) {
        (true, _) => format!("singular at the axis of {0}: {0} is free", axis.name),
        (false, true) => format!("dead radius {} mm about the axis of {}", number(dead_mm), axis.name),
        (false, false) => return vec![only],
    };
    vec![only, at_centre]
}

/// The directions of the tool.
fn cone(model: &Model) -> Vec<String> {
    let Some(reach) = class::reach(model) else {
        return vec![format!("tool axis {} only", vector(&class::tool(model)))];
    };
    let degrees = |angle_rad: f64| number((angle_rad.to_degrees() * 1e9).round() / 1e9);
    let (least, greatest) = (degrees(reach.least_rad), degrees(reach.greatest_rad));
    let mut lines = vec![match (least.as_str(), greatest.as_str()) {
        ("0", "180") => "every direction".to_owned(),
        (a, b) if a == b => format!("directions at {a} deg from {}", vector(&reach.about)),
        _ => format!("directions from {least} to {greatest} deg from {}", vector(&reach.about)),
    }];
    if let [one, other] = class::linears(model)[..] {
        lines.push(format!("tips in the plane of {one} and {other} only"));
    }
    let first = class::rotaries(model)[0].axis;
    let poles = class::poles(model).into_iter();
    lines.extend(poles.map(|pole| format!("singular at {}: {} is free", vector(&pole), model.axes[first].name)));
    lines
}

fn proved(proof: &Proof) -> Vec<String> {
    vec![
        format!("{} seeded poses through inverse and forward, every solution:", proof.poses),
        format!("tip within {} mm, tool axis within {} rad", bound(proof.tip_mm), bound(proof.axis_rad)),
    ]
}

/// The order of magnitude matters; nothing is plainly 0.
fn bound(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.1e}") }
}
