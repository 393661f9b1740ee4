//! A stretch of the program on its way: read from the CL, printed, checked. Then it is empty, and used again.

use crate::cl::{Next, Reader};
use crate::diagnostic::Diagnostic;
use crate::kinematics::LANES;
use crate::toolpath::Point;
use std::io::{self, Read};
use std::ops::Range;

/// So many points make a stretch: enough that handing it over costs nothing beside the work, few enough to stay in the
/// processor's cache.
const POINTS: usize = 1024;

/// So many commands do too.
const BLOCKS: usize = 256;

#[derive(Debug, Default)]
pub(super) struct Stretch {
    /// As the CL has them.
    pub(super) points: Vec<Point>,
    /// Blocks of up to [`LANES`] points, each with what comes after it.
    pub(super) blocks: Vec<(Range<usize>, Next)>,
    /// Whether the program ends with it: the CL does, or it has too many errors.
    pub(super) is_last: bool,
    /// What is printed.
    pub(super) text: Vec<u8>,
    pub(super) printed: Vec<PrintedPoint>,
    /// The joints of each printed point, one point after the other: millimetres or degrees, machine coordinates.
    pub(super) joints: Vec<f64>,
    /// Whether something of the CL could not be printed, here or before.
    pub(super) is_refused: bool,
    /// What is to be told.
    pub(super) diagnostics: Vec<Diagnostic>,
}

/// A point, and what was printed for it.
#[derive(Debug)]
pub(super) struct PrintedPoint {
    /// Its index in the stretch.
    pub(super) point: usize,
    /// So many blocks lead there; none where no word changed.
    pub(super) blocks: u64,
    /// The rotary motion there in degrees, summed, where it is a motion at feed from another point.
    pub(super) rotary_step_deg: Option<f64>,
    /// Whether the program goes there from the point before, with nothing between that moves an axis.
    pub(super) is_next: bool,
}

impl Stretch {
    /// Reads the points and commands of an empty stretch.
    pub(super) fn read<R: Read>(&mut self, reader: &mut Reader<R>) -> io::Result<()> {
        while !self.is_last && self.points.len() < POINTS && self.blocks.len() < BLOCKS {
            let start = self.points.len();
            let next = reader.next_into(&mut self.points, LANES)?;
            self.is_last = next == Next::End;
            self.blocks.push((start..self.points.len(), next));
        }
        Ok(())
    }

    /// Empties it; what it holds has its use behind it.
    pub(super) fn clear(&mut self) {
        self.points.clear();
        self.blocks.clear();
        self.text.clear();
        self.printed.clear();
        self.joints.clear();
        self.diagnostics.clear();
    }
}
