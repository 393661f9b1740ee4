//! Newton–Raphson with least squares: damped Gauss–Newton steps (Levenberg, Marquardt), derivatives at every iterate.
//!
//! It ends when the pose is within the bounds, or when no step longer than the bound makes the residual less: then these
//! joints come nearest, at least of those about them. A freedom that does nothing (the first rotary at the pole) stays
//! where it is.

use super::end::End;
use super::residual::{BOUND, Target};
use super::workspace::{Workspace, size};
use crate::plan::Pose;

/// From a start that leads anywhere it takes fewer than ten. Where two solutions meet, each halves what is left at worst:
/// then it takes 20 from a radian to where the residual, its square, is within the bound.
const MOST_ITERATIONS: u32 = 64;

/// The least damping: what changes the residual by less than the bound for a whole unit of motion stays still.
const LEAST_DAMPING: f64 = BOUND;

/// The first damping that limits a step: to about half of a thousand residuals.
const FIRST_DAMPING: f64 = 1e-3;

/// From one damping to the next.
const FACTOR: f64 = 10.0;

/// Moves the joints towards the target, as near as it goes.
pub(super) fn solve(workspace: &mut Workspace, target: &Target, joints: &mut [f64]) -> End {
    let mut damping = LEAST_DAMPING;
    for _ in 0..MOST_ITERATIONS {
        let pose = workspace.linearise(joints);
        if target.is_met_by(&pose) {
            return End::There;
        }
        if !descend(workspace, target, joints, &target.residual(&pose), &mut damping) {
            return End::Nearest;
        }
    }
    End::Lost
}

/// Takes a step that makes the residual less, damped as far as that needs; says whether there is one.
///
/// A long turn about a far centre takes the tip along an arc, where the derivatives foresee a line. Before such a step is
/// damped it gets a second try, with the linear joints put where they hold the tip.
fn descend(workspace: &mut Workspace, target: &Target, joints: &mut [f64], residual: &Pose, damping: &mut f64) -> bool {
    let is_less = |pose: &Pose| size(&target.residual(pose)) < size(residual);
    while let Some(pose) = workspace.try_step(joints, residual, *damping) {
        if is_less(&pose) || is_less(&workspace.try_held(target)) {
            workspace.take_step(joints);
            *damping = if *damping > FIRST_DAMPING { *damping / FACTOR } else { LEAST_DAMPING };
            return true;
        }
        workspace.linearise(joints);
        *damping = (*damping * FACTOR).max(FIRST_DAMPING);
    }
    false
}
