//! The inverse by iteration, on the plan's forward chain and its derivatives alone: an independent check of the closed
//! form, and a way for machines that have none.
//!
//! - [`Method::Newton`]: Newton–Raphson with least squares (`newton`): a damped Gauss–Newton step on all joints at once,
//!   with the derivatives at every iterate.
//! - [`Method::Broyden`]: Broyden's good method with continuation (`broyden`): the derivatives where a step of the path
//!   begins, updated along the way; a step that does not succeed is halved.
//!
//! Both solve for what is left between a pose and the wanted one (`residual`), in metres and radians, until the tip and the
//! axis are within the bounds that the closed form is proved to. [`Numeric`] follows every solution along a path from the
//! last pose to the next (`kinematics`), and looks from a grid of starts (`seeds`) where there is none to follow.
//!
//! No solution is an answer, too: the joints are then those that come nearest, and the runtime hears how far that is.

mod broyden;
mod compare;
mod effort;
mod end;
mod forward;
mod found;
mod kinematics;
mod least_squares;
mod newton;
mod residual;
mod seeds;
mod solver;
mod workspace;

pub use compare::{Compared, Measured, compare};
pub use effort::Effort;
pub use kinematics::Numeric;
pub use solver::{Inverse, Solver};

use end::End;
use residual::Target;
use workspace::Workspace;

/// How a pose is iterated for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Newton–Raphson with least squares.
    Newton,
    /// Broyden's good method with continuation.
    Broyden,
}

impl Method {
    /// Moves the joints, which solve for the pose `from`, towards the target.
    fn solve(self, workspace: &mut Workspace, from: &Target, target: &Target, joints: &mut [f64]) -> End {
        match self {
            Self::Newton => newton::solve(workspace, target, joints),
            Self::Broyden => broyden::follow(workspace, from, target, joints),
        }
    }
}
