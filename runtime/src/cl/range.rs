//! How large the numbers of a record may be.

use crate::cl::record::Record;
use crate::diagnostic::{Code, Diagnostic};
use crate::vector::Vec3;

/// No machine tool is a kilometre long.
pub(super) const FARTHEST_MM: f64 = 1e6;

/// A number that cannot be meant.
pub(super) static OUT_OF_RANGE: Code = Code {
    id: "E1015",
    title: "a number of the CL is out of range",
    explanation: "\
The number is larger than anything a machine tool can do (a coordinate beyond 1,000,000 mm, say), or zero or negative where
only a positive number makes sense. The file may be damaged.
",
};

/// An error about a number that is out of range.
pub(super) fn out_of_range(record: &Record, index: usize, text: &str) -> Diagnostic {
    let message = format!("{} has a number that is out of range", record.word());
    Diagnostic::error(&OUT_OF_RANGE, message).at(record.place_of(index), text)
}

/// The point, if it is not farther than any machine reaches.
pub(super) fn checked(point_mm: Vec3, record: &Record) -> Result<Vec3, Diagnostic> {
    match point_mm.iter().position(|mm| mm.is_nan() || mm.abs() > FARTHEST_MM) {
        Some(index) => Err(out_of_range(record, index, "no coordinate is beyond 1,000,000 mm")),
        None => Ok(point_mm),
    }
}
