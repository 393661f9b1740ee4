//! Broyden's good method with continuation: the derivatives are computed once where a step of the path begins, and
//! corrected by what each iterate teaches. A step of the path that this does not get through is halved.
//!
//! It ends as Newton's does: within the bounds, or where the corrected derivatives see no step that is longer than the
//! bound. It has not converged when it takes too many iterates, or when even the smallest part of a path's step fails.

use super::end::End;
use super::residual::{BOUND, Target};
use super::workspace::Workspace;

/// Fewer than the good method needs to turn into a random walk: beyond it, halving the step is cheaper.
const MOST_ITERATIONS: u32 = 24;

/// The smallest part of a step of the path is a 1024th.
const MOST_BISECTIONS: u32 = 10;

/// Takes the joints from the pose where they are to the target, in parts where need be. Where that fails they are where
/// the iteration left them.
pub(super) fn follow(workspace: &mut Workspace, from: &Target, target: &Target, joints: &mut [f64]) -> End {
    in_parts(workspace, from, target, joints, MOST_BISECTIONS)
}

fn in_parts(workspace: &mut Workspace, from: &Target, target: &Target, joints: &mut [f64], depth: u32) -> End {
    let start = joints.to_vec();
    let end = solve(workspace, target, joints);
    let half_way = target.half_way_from(from).filter(|_| end == End::Lost && depth > 0);
    let Some(half_way) = half_way else { return end };
    workspace.effort.bisections += 1;
    joints.copy_from_slice(&start);
    match in_parts(workspace, from, &half_way, joints, depth - 1) {
        End::There => in_parts(workspace, &half_way, target, joints, depth - 1),
        end => end,
    }
}

/// Moves the joints towards the target in one go.
fn solve(workspace: &mut Workspace, target: &Target, joints: &mut [f64]) -> End {
    let mut pose = workspace.linearise(joints);
    for _ in 0..MOST_ITERATIONS {
        if target.is_met_by(&pose) {
            return End::There;
        }
        let residual = target.residual(&pose);
        let Some(next) = workspace.try_step(joints, &residual, BOUND) else { return End::Nearest };
        let reached = target.residual(&next);
        workspace.take_step(joints);
        workspace.learn(&std::array::from_fn(|i| reached[i] - residual[i]));
        pose = next;
    }
    End::Lost
}
