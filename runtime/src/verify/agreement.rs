//! What a comparison has found, in numbers.

use super::pose::Pose;
use crate::certificate::Worst;
use std::fmt;

/// What a comparison has found.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Agreement {
    /// Points of the CL that the program reaches.
    pub points: u64,
    /// How far the tool is from them at most, at the line of the program.
    pub worst: Worst,
    /// Blocks that the CL did not ask for: to the way out and the reference point.
    pub retracts: u64,
    /// Blocks that the CL did not ask for: on the way to the first point behind a retract or a tool change.
    pub approaches: u64,
    /// Differences.
    pub differences: u64,
}

impl Agreement {
    /// A point of the CL is reached.
    pub(super) fn reach(&mut self, pose: Pose, there: Pose, line: u64) {
        self.points += 1;
        self.worst.meet(pose.deviation(there), line);
    }
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { points, worst: Worst { tip_mm, axis_rad }, retracts, approaches, differences } = self;
        writeln!(f, "against the CL: {differences} differences")?;
        writeln!(
            f,
            "  {:<22}{points} points reached, {approaches} blocks of approaches, {retracts} to the way out",
            "toolpath"
        )?;
        writeln!(f, "  {:<22}{:.6} mm at line {}", "largest tip error", tip_mm.value, tip_mm.line)?;
        write!(f, "  {:<22}{:.6} deg at line {}", "largest axis error", axis_rad.value.to_degrees(), axis_rad.line)
    }
}
