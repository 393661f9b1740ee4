//! Points and directions of a record, checked and placed.

use super::Motion;
use crate::cl::range::{checked, out_of_range};
use crate::cl::record::Record;
use crate::diagnostic::{Code, Diagnostic};
use crate::vector::{Vec3, norm, scale};

/// How far the length of a unit vector may be from 1.
pub(super) const UNIT_TOLERANCE: f64 = 1e-3;

/// A direction without length.
pub(crate) static ZERO_VECTOR: Code = Code {
    id: "E1016",
    title: "a direction has no length",
    explanation: "\
A tool axis or a circle's normal is a unit vector. One of length zero points nowhere:

    GOTO/10.0,20.0,30.0,0.0,0.0,0.0

Leave the three numbers out to keep the last tool axis.
",
};

/// A unit vector that is none.
pub(crate) static NOT_UNIT: Code = Code {
    id: "W1002",
    title: "a direction is not a unit vector",
    explanation: "\
The length of a tool axis or of a circle's normal is off 1 by more than 0.001. It has been made a unit vector; but CAM
systems write unit vectors, so this may be another kind of data (a point on the axis, angles). Reported once a file.
",
};

impl Motion {
    pub(super) fn pose(&mut self, record: &Record) -> Result<(Vec3, Vec3), Diagnostic> {
        let axis = match record.len() {
            3 => self.axis,
            6 => self.direction(record, 3)?,
            _ => return Err(record.missing(6, "expected 3 or 6 numbers")),
        };
        Ok((self.point(record, 0)?, axis))
    }

    pub(super) fn point(&self, record: &Record, from: usize) -> Result<Vec3, Diagnostic> {
        checked(self.placement.point(scale(self.unit_mm, record.numbers(from)?)), record)
    }

    pub(super) fn direction(&mut self, record: &Record, from: usize) -> Result<Vec3, Diagnostic> {
        let given = record.numbers::<3>(from)?;
        let length = norm(given);
        if length < f64::MIN_POSITIVE.sqrt() {
            let error = Diagnostic::error(&ZERO_VECTOR, format!("{} has a direction of length zero", record.word()));
            return Err(error.at(record.place_of(from), "this direction points nowhere"));
        }
        if !length.is_finite() {
            return Err(out_of_range(record, from, "a unit vector is expected"));
        }
        if (length - 1.0).abs() > UNIT_TOLERANCE {
            let first = || {
                let warning = Diagnostic::warning(&NOT_UNIT, format!("a direction has the length {length:.4}"));
                (warning.at(record.place_of(from), "should have the length 1"), 0)
            };
            self.once.not_unit.get_or_insert_with(first).1 += 1;
        }
        Ok(self.placement.direction(scale(1.0 / length, given)))
    }
}
