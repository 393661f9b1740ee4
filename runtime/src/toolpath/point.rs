//! Points, and how the tool gets there.

use crate::vector::Vec3;

/// How the tool gets to a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Approach {
    /// In rapid traverse.
    Rapid,
    /// At feed; `None` while the CL has given no feed rate.
    Feed(Option<Feed>),
}

/// A feed rate, already in metric units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Feed {
    /// Millimetres a minute.
    PerMinute(f64),
    /// Millimetres a revolution.
    PerRevolution(f64),
}

/// One point of the toolpath, in the frame of the first MSYS of the file, in millimetres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// The tip.
    pub tip_mm: Vec3,
    /// The unit tool axis, from the tip to the spindle.
    pub axis: Vec3,
    /// How to get there.
    pub approach: Approach,
    /// The line of the CL file it comes from, from 1 (for a point of an arc, the line of its end).
    pub line: u64,
}
