//! The road of all who take machines along a CL for its points alone: it is read in blocks of points that are solved together. A
//! post reads the same blocks, many at a time, and minds the commands between them.

use crate::cl::{Next, Reader};
use crate::diagnostic::Diagnostic;
use crate::kinematics::LANES;
use crate::toolpath::Point;
use std::io::{self, Read};

/// Who goes along it.
pub trait Traveller {
    /// Goes to points that follow each other; at most [`LANES`], perhaps none.
    fn go(&mut self, points: &[Point]);

    /// Stands at a point before the next motion.
    fn stand_at(&mut self, point: &Point);

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
        Next::Full | Next::Command(..) => {}
        Next::From(point) => traveller.stand_at(&point),
        Next::Diagnostic(diagnostic) => traveller.hear(diagnostic),
        Next::End => return Ok(false),
    }
    Ok(true)
}
