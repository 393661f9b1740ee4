//! The forward and the inverse transformation as equations, for whoever lays them out.

use super::equations::Notation;
use super::spelling::Spelling;
use crate::model::machine::Model;
use crate::plan::{Id, Plan};
use mach_runtime::machine::Motion;

/// The joints from tip and tool axis.
pub(super) struct Inverse {
    /// The axes of which any value is taken, if there are any: `for any A`.
    pub(super) given: Option<String>,
    /// What the solutions share.
    pub(super) shared: Vec<String>,
    /// The rotary joints: one for each branch.
    pub(super) solutions: Vec<Vec<String>>,
    /// The linear joints, from the rotary ones.
    pub(super) linear: Vec<String>,
}

/// The tool axis (i, j, k) and the tip (x, y, z) from the joints.
pub(super) fn forward(model: &Model, plan: &Plan, spelling: Spelling) -> [Vec<String>; 2] {
    let axis = ["i", "j", "k"].into_iter().zip(plan.axis).collect::<Vec<_>>();
    let tip = ["x", "y", "z"].into_iter().zip(plan.tip).collect::<Vec<_>>();
    let mut notation = notation(model, plan, spelling);
    [axis, tip].map(|outputs| equations(&mut notation, &outputs))
}

/// The joints from tip and tool axis: the rotary ones for each branch, then the linear ones for either.
pub(super) fn inverse(model: &Model, plan: &Plan, spelling: Spelling) -> Inverse {
    let of_kind = |ids: &[Id], motion: Motion| -> Vec<(&str, Id)> {
        let all = model.axes.iter().zip(ids);
        let solved = all.filter(|(axis, _)| axis.motion == motion && axis.is_solved());
        solved.map(|(axis, &id)| (axis.name.as_str(), id)).collect()
    };
    let branches: Vec<_> = plan.branches.iter().map(|branch| of_kind(&branch.joints, Motion::Rotary)).collect();
    let linear = equations(&mut notation(model, plan, spelling), &of_kind(&plan.position, Motion::Linear));
    let mut notation = notation(model, plan, spelling);
    let roots: Vec<Id> = branches.iter().flatten().map(|&(_, id)| id).collect();
    let shared = notation.shared(&roots);
    let mut solution =
        |branch: &Vec<(&str, Id)>| branch.iter().map(|(name, id)| notation.equation(name, *id)).collect();
    Inverse { given: given(model), shared, solutions: branches.iter().map(&mut solution).collect(), linear }
}

/// What the inverse takes besides the pose.
fn given(model: &Model) -> Option<String> {
    let surplus = model.axes.iter().filter(|axis| axis.rule.is_surplus());
    let names: Vec<&str> = surplus.map(|axis| axis.name.as_str()).collect();
    (!names.is_empty()).then(|| format!("for any {}", names.join(", ")))
}

/// What the outputs share, then the outputs.
fn equations(notation: &mut Notation<'_>, outputs: &[(&str, Id)]) -> Vec<String> {
    let roots: Vec<Id> = outputs.iter().map(|&(_, id)| id).collect();
    let mut lines = notation.shared(&roots);
    lines.extend(outputs.iter().map(|(name, id)| notation.equation(name, *id)));
    lines
}

fn notation<'p>(model: &Model, plan: &'p Plan, spelling: Spelling) -> Notation<'p> {
    let mut names: Vec<String> = ["x", "y", "z", "i", "j", "k", "L"].map(str::to_owned).to_vec();
    names.extend(model.axes.iter().map(|axis| axis.name.clone()));
    let named = plan.graph.inputs().filter_map(|(id, index)| Some((id, names.get(index)?.clone())));
    Notation::new(&plan.graph, named).spelled(spelling)
}
