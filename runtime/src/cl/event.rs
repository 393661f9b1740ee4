//! What the CL says, once its records are understood: points, and commands between them.

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

/// Which way the spindle turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spindle {
    /// Clockwise.
    Clockwise,
    /// Counter-clockwise.
    Counterclockwise,
}

/// Which coolant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coolant {
    /// Flood, also plain ON.
    Flood,
    /// Mist.
    Mist,
    /// Through the tool.
    Through,
}

/// Something between the points.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// `TOOL PATH/`: an operation begins.
    Operation {
        /// Its name.
        name: String,
        /// Its tool's name.
        tool: String,
    },
    /// `LOAD/TOOL`: a tool change.
    Tool {
        /// The tool's number.
        number: u64,
        /// Its length register.
        register: Option<u64>,
    },
    /// `SPINDL/`: the spindle turns.
    SpindleOn(Spindle, f64),
    /// `SPINDL/OFF`.
    SpindleOff,
    /// `COOLNT/`.
    CoolantOn(Coolant),
    /// `COOLNT/OFF`.
    CoolantOff,
    /// `STOP`.
    Stop,
    /// `OPSTOP`.
    OptionalStop,
    /// `DELAY/`: seconds.
    Dwell(f64),
    /// `PPRINT`, `INSERT` and the like: text for the operator.
    Message(String),
}
