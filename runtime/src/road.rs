//! The road of all who go along a CL: it is read in blocks of points that are solved together, and most are there for the points
//! alone. A post reads the same blocks, many at a time.

use crate::cl::{Next, Reader};
use crate::diagnostic::Diagnostic;
use crate::kinematics::LANES;
use crate::toolpath::{Command, Point};
use std::io::{self, Read};

/// Who goes along it.
pub trait Traveller {
    /// Goes to points that follow each other; at most [`LANES`], perhaps none.
    fn go(&mut self, points: &[Point]);

    /// Stands at a point before the next motion.
    fn stand_at(&mut self, point: &Point);

    /// Hears what is said between the points, at a line of the CL. Most go along it for its points alone.
    fn carry_out(&mut self, _command: &Command, _line: u64) {}

    /// Hears of a mistake in the CL.
    fn hear(&mut self, diagnostic: Diagnostic);
}

/// Takes a traveller along a CL.
///
/// # Errors
/// When the CL cannot be read.
pub fn travel<R: Read>(reader: &mut Reader<R>, traveller: &mut impl Traveller) -> io::Result<()> {
    let mut points = Vec::with_capacity(LANES);
    while stage(reader, &mut points, traveller)? {}
    Ok(())
}

/// One block, and what comes behind it. Says whether the road goes on. The points are a place to work in.
///
/// # Errors
/// When the CL cannot be read.
pub fn stage<R: Read>(
    reader: &mut Reader<R>,
    points: &mut Vec<Point>,
    traveller: &mut impl Traveller,
) -> io::Result<bool> {
    points.clear();
    let next = reader.next_into(points, LANES)?;
    traveller.go(points);
    match next {
        Next::Full => {}
        Next::Command(command, place) => traveller.carry_out(&command, place.line),
        Next::From(point) => traveller.stand_at(&point),
        Next::Diagnostic(diagnostic) => traveller.hear(diagnostic),
        Next::End => return Ok(false),
    }
    Ok(true)
}
