//! What a comparison has found, in numbers.

use super::pose::Pose;
use crate::certificate::Extreme;
use std::fmt;

/// What a comparison has found.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Agreement {
    /// Points of the CL that the program reaches.
    pub points: u64,
    /// The largest distance of the tip from the CL's point, in millimetres, at the line of the program.
    pub tip_mm: Extreme,
    /// The largest angle of the tool axis from the CL's, in radians.
    pub axis_rad: Extreme,
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
        let (tip_mm, axis_rad) = pose.apart(there);
        self.points += 1;
        self.tip_mm.meet(tip_mm, line);
        self.axis_rad.meet(axis_rad, line);
    }
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { points, tip_mm, axis_rad, retracts, approaches, differences } = self;
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
