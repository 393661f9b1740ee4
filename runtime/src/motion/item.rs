//! One item of motion: a move or an event.

use crate::vector::Vec3;

/// What happens next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Item {
    /// The line of the text that it comes from, from 1.
    pub line: u64,
    /// The index of the state during it.
    pub state: u32,
    /// What it is.
    pub what: What,
}

/// A move or an event.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum What {
    /// The axes go somewhere.
    Move(Move),
    /// Something else happens.
    Event(Event),
}

/// From where the axes are to where they are sent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    /// What lies between.
    pub law: Law,
    /// Where the joints of its end begin in their column.
    pub joints: u32,
    /// The axes whose position is known at its end, the first one in the lowest bit.
    pub known: u64,
    /// The axes that the block names.
    pub named: u64,
    /// Whether the block's words are machine coordinates, or it goes to the reference point.
    pub is_machine: bool,
}

/// What lies between the ends of a move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Law {
    /// In rapid traverse.
    Rapid,
    /// At feed, the axes linear.
    Line,
    /// At feed, on the arc with this index, other axes linear.
    Arc(u32),
}

/// A circular arc, or a helix, of the linear axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// The centre in machine coordinates of X, Y, Z, in millimetres; along the normal it is where the arc starts.
    pub centre_mm: Vec3,
    /// Its radius in millimetres.
    pub radius_mm: f64,
    /// The unit normal of its plane.
    pub normal: Vec3,
    /// How far it turns about the normal, in radians, positive counter-clockwise; a full turn and more are possible.
    pub sweep_rad: f64,
}

/// What happens between moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Event {
    /// This tool comes into the spindle.
    ToolChange(u32),
    /// A pause of so many seconds.
    Dwell(f64),
    /// The program stops until it is started again.
    Stop,
    /// The same, where the operator wants it.
    OptionalStop,
    /// The program is over.
    End,
}
