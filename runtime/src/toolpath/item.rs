//! One item of a toolpath.

use super::command::Command;
use super::point::Point;
use super::state::State;
use crate::place::Frame;

/// What happens next.
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    /// The line that it comes from, from 1.
    pub line: u64,
    /// What is in force with it.
    pub state: State,
    /// What it is.
    pub what: What,
}

/// A point or something else.
#[derive(Debug, Clone, PartialEq)]
pub enum What {
    /// The tool goes there.
    Point(Point),
    /// `FROM/`: the tool stands there; no motion.
    From(Point),
    /// `MSYS/`: the coordinates of the file are those of this frame from here on. The frame is given, and all points are, in that
    /// of the program zero.
    Frame(Frame),
    /// Something between the points.
    Command(Command),
}
