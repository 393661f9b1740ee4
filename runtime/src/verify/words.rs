//! The words of points that are reached: each is a solution's but for its last digit.

use super::mismatch::{Difference, Found};
use super::pose::{Pose, Solver};
use super::tolerance::Tolerance;
use crate::kinematics::{Kinematics, LANES};
use crate::motion::Motion;

/// A point of the CL that a move has reached.
#[derive(Debug, Clone, Copy)]
pub(super) struct PointReached {
    /// Where the joints of its end begin in the motion's column.
    pub(super) joints: u32,
    /// What the CL wants.
    pub(super) wanted: Pose,
    /// The line of the program.
    pub(super) line: u64,
    /// The line of the CL.
    pub(super) cl_line: u64,
}

/// Judges the words of these points.
pub(super) fn judge<K: Kinematics>(
    points: &[PointReached],
    motion: &Motion,
    solver: &mut Solver<'_, K>,
    tolerance: &Tolerance<'_>,
    differ: &mut dyn FnMut(Found, &PointReached),
) {
    let mut off = Vec::new();
    for points in points.chunks(LANES) {
        solver.solve(points.iter().map(|point| (point.wanted, motion.joints_at(point.joints))));
        for (lane, point) in points.iter().enumerate() {
            if solver.off(lane, point.wanted, motion.joints_at(point.joints), &mut off)
                && let Some((axis, by)) = tolerance.wrong_word(&off)
            {
                let message = format!("{axis} is off by {by:.4} from where the CL's point needs it");
                differ((Difference::Elsewhere, message), point);
            }
        }
    }
}
