//! A stretch of the program as it was printed: what the checker is given.

use crate::cl::event::Point;
use std::ops::Range;

/// So many points make a stretch: enough that handing it over costs nothing beside the work, few enough to stay in the
/// processor's cache.
const POINTS: usize = 1024;

/// So much text does too, where a program has no points.
const TEXT_BYTES: usize = 1 << 16;

/// Some blocks' text, and the points printed in it.
#[derive(Debug, Default)]
pub(super) struct Printed {
    pub(super) text: Vec<u8>,
    pub(super) points: Vec<PrintedPoint>,
    /// The joints of each point, one point after the other: millimetres or degrees, machine coordinates.
    pub(super) joints: Vec<f64>,
}

/// A point, and what was printed for it.
#[derive(Debug)]
pub(super) struct PrintedPoint {
    pub(super) point: Point,
    /// Its blocks in the text; empty where no word changed.
    pub(super) text: Range<usize>,
    /// The rotary motion there in degrees, summed, where it is a motion at feed from another point.
    pub(super) rotary_step_deg: Option<f64>,
}

impl Printed {
    /// A point whose text begins at `start` and ends where the text ends.
    pub(super) fn add(&mut self, point: Point, start: usize, joints: &[f64], rotary_step_deg: Option<f64>) {
        self.points.push(PrintedPoint { point, text: start..self.text.len(), rotary_step_deg });
        self.joints.extend_from_slice(joints);
    }

    pub(super) fn clear(&mut self) {
        self.text.clear();
        self.points.clear();
        self.joints.clear();
    }

    /// Whether it should be handed on.
    pub(super) fn is_full(&self) -> bool {
        self.points.len() >= POINTS || self.text.len() >= TEXT_BYTES
    }
}
