//! A tool as the kinematics sees it.

/// Where its tip is, seen from the gauge point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToolGeometry {
    /// The gauge length: from the gauge point to the tip along the tool axis, in millimetres.
    pub length_mm: f64,
}

impl ToolGeometry {
    /// A tool with the tip on the spindle's axis.
    pub const fn of_length(length_mm: f64) -> Self {
        Self { length_mm }
    }
}
