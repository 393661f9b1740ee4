//! The data sheet of a machine: what `machc show` prints.

use super::equations::{Notation, number};
use super::measured;
use crate::derive::family;
use crate::derive::prove::Proof;
use crate::model::machine::{Axis, Model};
use crate::plan::{Id, Plan};
use mach_runtime::machine::{Motion, Written};
use nalgebra::Vector3;
use std::fmt::Write;

/// The whole sheet, as text of at most 80 columns where the equations allow it.
pub fn data_sheet(model: &Model, plan: &Plan, proof: &Proof) -> String {
    let mut sheet = heading(model);
    for (title, lines) in [
        ("axes", model.axes.iter().map(axis).collect()),
        ("errors", measured::errors(model)),
        ("constants", constants(model)),
        ("forward transformation", forward(model, plan)),
        ("inverse transformation", inverse(model, plan)),
        ("reach", reach(model)),
        ("proof", proved(proof)),
    ] {
        section(&mut sheet, title, lines);
    }
    sheet
}

fn heading(model: &Model) -> String {
    let title = model.title.as_ref().map(|title| format!("  {title}")).unwrap_or_default();
    format!("{}{title}\n\nchain   {}\nfamily  {}\n", model.name, chain(model), family::family(model))
}

fn section(sheet: &mut String, title: &str, lines: Vec<String>) {
    if lines.is_empty() {
        return;
    }
    let body = lines.iter().fold(String::new(), |body, line| body + "  " + line + "\n");
    write!(sheet, "\n{title}\n{body}").expect("writing to a string does not fail");
}

/// The structural code: `w C' A' b X Y Z t`.
fn chain(model: &Model) -> String {
    let mut links: Vec<String> = model
        .chain
        .iter()
        .map(|joint| format!("{}{}", model.axes[joint.axis].name, if joint.primed { "'" } else { "" }))
        .collect();
    links.insert(model.bed, "b".to_owned());
    format!("w {} t", links.join(" "))
}

fn axis(axis: &Axis) -> String {
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
    format!("{line}, travel {travel}{written}")
}

fn constants(model: &Model) -> Vec<String> {
    let mut lines: Vec<String> = model.parameters.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    lines.push(format!("tool axis at home {}, gauge point {}", vector(&model.tool.axis), vector(&model.tool.gauge_mm)));
    lines.push(format!("tool length L = {} mm, program zero {}", number(model.tool.length_mm), vector(&model.zero_mm)));
    lines
}

/// Tip (x, y, z) and tool axis (i, j, k) from the joints.
fn forward(model: &Model, plan: &Plan) -> Vec<String> {
    let axis = ["i", "j", "k"].into_iter().zip(plan.axis).collect::<Vec<_>>();
    let tip = ["x", "y", "z"].into_iter().zip(plan.tip).collect::<Vec<_>>();
    let mut notation = notation(model, plan);
    [axis, tip].iter().flat_map(|outputs| equations(&mut notation, outputs)).collect()
}

/// The joints from tip and tool axis: the rotary ones for each branch, then the linear ones for either.
fn inverse(model: &Model, plan: &Plan) -> Vec<String> {
    let of_kind = |ids: &[Id], motion: Motion| -> Vec<(&str, Id)> {
        let all = model.axes.iter().zip(ids);
        all.filter(|(axis, _)| axis.motion == motion).map(|(axis, &id)| (axis.name.as_str(), id)).collect()
    };
    let solutions: Vec<_> = plan.branches.iter().map(|branch| of_kind(&branch.joints, Motion::Rotary)).collect();
    let linear = equations(&mut notation(model, plan), &of_kind(&plan.position, Motion::Linear));
    if let [only] = &solutions[..] {
        return [equations(&mut notation(model, plan), only), linear].concat();
    }
    let mut notation = notation(model, plan);
    let roots: Vec<Id> = solutions.iter().flatten().map(|&(_, id)| id).collect();
    let mut lines = notation.shared(&roots);
    for (index, solution) in solutions.iter().enumerate() {
        lines.push(format!("solution {}", index + 1));
        lines.extend(solution.iter().map(|(name, id)| format!("  {}", notation.equation(name, *id))));
    }
    lines.push("for either solution".to_owned());
    lines.extend(linear.into_iter().map(|line| format!("  {line}")));
    lines
}

/// What the outputs share, then the outputs.
fn equations(notation: &mut Notation<'_>, outputs: &[(&str, Id)]) -> Vec<String> {
    let roots: Vec<Id> = outputs.iter().map(|&(_, id)| id).collect();
    let mut lines = notation.shared(&roots);
    lines.extend(outputs.iter().map(|(name, id)| notation.equation(name, *id)));
    lines
}

fn notation<'p>(model: &Model, plan: &'p Plan) -> Notation<'p> {
    let mut names: Vec<String> = ["x", "y", "z", "i", "j", "k", "L"].map(str::to_owned).to_vec();
    names.extend(model.axes.iter().map(|axis| axis.name.clone()));
    names.extend(model.errors.tables.iter().map(|table| model.error_name(table.component, table.axis, false)));
    Notation::new(&plan.graph, plan.graph.inputs().map(|(id, index)| (id, names[index].clone())))
}

fn reach(model: &Model) -> Vec<String> {
    let Some(reach) = family::reach(model) else {
        return vec![format!("tool axis {} only", vector(&model.tool.axis))];
    };
    let degrees = |angle_rad: f64| number((angle_rad.to_degrees() * 1e9).round() / 1e9);
    let (least, greatest) = (degrees(reach.least_rad), degrees(reach.greatest_rad));
    let mut lines = vec![match (least.as_str(), greatest.as_str()) {
        ("0", "180") => "every direction".to_owned(),
        (a, b) if a == b => format!("directions at {a} deg from {}", vector(&reach.about)),
        _ => format!("directions from {least} to {greatest} deg from {}", vector(&reach.about)),
    }];
    let first = family::rotaries(model)[0].0;
    let poles = family::poles(model).into_iter();
    lines.extend(poles.map(|pole| format!("singular at {}: {} is free", vector(&pole), model.axes[first].name)));
    lines
}

fn proved(proof: &Proof) -> Vec<String> {
    vec![
        format!("{} seeded poses through inverse and forward, every solution:", proof.poses),
        format!("tip within {:.1e} mm, tool axis within {:.1e} rad", proof.tip_mm, proof.axis_rad),
    ]
}

pub(super) fn vector(v: &Vector3<f64>) -> String {
    format!("({}, {}, {})", number(v.x), number(v.y), number(v.z))
}
