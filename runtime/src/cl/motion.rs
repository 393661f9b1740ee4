//! Motion: where the tool is, and the records that move it.

pub(super) mod circle;
pub(super) mod pose;

use crate::cl::arc::{ArcPoints, Circle};
use crate::cl::once::Once;
use crate::cl::range::{FARTHEST_MM, checked};
use crate::cl::record::Record;
use crate::diagnostic::{Code, Diagnostic};
use crate::place::{Frame, Placement};
use crate::toolpath::{Approach, Feed, Point};
use crate::unit::LengthUnit;
use crate::vector::{Vec3, add, norm, scale};
use circle::OPEN_ARC;
use pose::UNIT_TOLERANCE;

/// An MSYS that spans no frame.
pub(super) static FLAT_FRAME: Code = Code {
    id: "E1030",
    title: "the axes of an MSYS span no plane",
    explanation: "\
MSYS gives an origin and the directions of X and Y; Z is their product. Neither direction may be zero, and they may not be
parallel:

    MSYS/0.0,0.0,0.0,1.0,0.0,0.0,0.0,1.0,0.0
",
};

/// The tool axis in a frame, as long as no record gives one.
const ALONG_Z: Vec3 = [0.0, 0.0, 1.0];

/// What a record came to.
#[derive(Debug)]
pub(super) enum Moved {
    /// To a point.
    To(Point),
    /// Along an arc, in points that share everything with the last one but the place.
    Along(ArcPoints, Point),
}

/// What holds until a record changes it.
#[derive(Debug)]
pub(super) struct Motion {
    /// Millimetres in a unit of the file's lengths.
    pub(super) unit_mm: f64,
    pub(super) feed: Option<Feed>,
    /// The next motion is in rapid traverse.
    pub(super) rapid: bool,
    pub(super) chord_tolerance_mm: f64,
    pub(super) placement: Placement,
    pub(super) tip_mm: Option<Vec3>,
    pub(super) axis: Vec3,
    home_mm: Option<Vec3>,
    /// The circle that the next GOTO ends, and what is to be said if none comes.
    pub(super) circle: Option<(Circle, Diagnostic)>,
    pub(super) once: Once,
}

impl Motion {
    pub(super) fn new(unit: LengthUnit, chord_tolerance_mm: f64) -> Self {
        Self {
            unit_mm: unit.mm(),
            feed: None,
            rapid: false,
            chord_tolerance_mm,
            placement: Placement::default(),
            tip_mm: None,
            axis: ALONG_Z,
            home_mm: None,
            circle: None,
            once: Once::default(),
        }
    }

    /// A plain GOTO in the common case: the point, or `None` when the record wants a closer look.
    #[inline]
    pub(super) fn plain_goto(&mut self, tip: Vec3, axis: Option<Vec3>, line: u64) -> Option<Point> {
        let axis = match axis {
            None => self.axis,
            Some(axis) => {
                let length = norm(axis);
                let usual = (length - 1.0).abs() <= UNIT_TOLERANCE;
                self.placement.direction(usual.then(|| scale(1.0 / length, axis))?)
            }
        };
        let tip_mm = self.placement.point(scale(self.unit_mm, tip));
        let usual = tip_mm.iter().all(|mm| mm.abs() <= FARTHEST_MM);
        usual.then(|| self.go(tip_mm, axis, line))
    }

    /// Whether a GOTO now is the end of an arc.
    pub(super) fn has_circle(&self) -> bool {
        self.circle.is_some()
    }

    /// A circle that waits in vain for its end.
    pub(super) fn take_circle(&mut self) -> Option<Diagnostic> {
        self.circle.take().map(|(_, open)| open)
    }

    pub(super) fn go(&mut self, tip_mm: Vec3, axis: Vec3, line: u64) -> Point {
        let approach = if self.rapid { Approach::Rapid } else { Approach::Feed(self.feed) };
        self.rapid = false;
        self.axis = axis;
        self.tip_mm = Some(tip_mm);
        Point { tip_mm, axis, approach, line }
    }

    /// `GOTO/x,y,z[,i,j,k]`, also the end of an arc.
    pub(super) fn goto(&mut self, record: &Record) -> Result<Moved, Diagnostic> {
        let (tip_mm, axis) = self.pose(record)?;
        match self.circle.take() {
            Some((circle, open)) => self.arc_to(tip_mm, axis, &circle, open, record),
            None => Ok(Moved::To(self.go(tip_mm, axis, record.last_line()))),
        }
    }

    /// `GODLTA/dx,dy,dz[,i,j,k]`: an increment; the axis is absolute.
    pub(super) fn godlta(&mut self, record: &Record) -> Result<Moved, Diagnostic> {
        let step_mm = match record.len() {
            1 => scale(record.number(0)? * self.unit_mm, self.axis),
            3 | 6 => self.placement.direction(scale(self.unit_mm, record.numbers::<3>(0)?)),
            _ => return Err(record.missing(3, "expected 1, 3 or 6 numbers")),
        };
        let axis = if record.len() == 6 { self.direction(record, 3)? } else { self.axis };
        let Some(tip_mm) = self.tip_mm else {
            let error = Diagnostic::error(&OPEN_ARC, "GODLTA has no position to start from");
            return Err(error.at(record.place(), "needs a GOTO or FROM before it"));
        };
        let tip_mm = checked(add(tip_mm, step_mm), record)?;
        Ok(Moved::To(self.go(tip_mm, axis, record.last_line())))
    }

    /// `GOHOME[/x,y,z[,i,j,k]]`; without numbers, to where FROM was.
    pub(super) fn gohome(&mut self, record: &Record) -> Result<Moved, Diagnostic> {
        if record.len() > 0 {
            return self.goto(record);
        }
        let Some(home_mm) = self.home_mm else {
            return Err(record.missing(0, "needs coordinates, as there is no FROM before it"));
        };
        Ok(Moved::To(self.go(home_mm, self.axis, record.last_line())))
    }

    /// `FROM/x,y,z[,i,j,k]`: where the tool stands; no motion.
    pub(super) fn from(&mut self, record: &Record) -> Result<Point, Diagnostic> {
        let (tip_mm, axis) = self.pose(record)?;
        (self.home_mm, self.tip_mm, self.axis) = (Some(tip_mm), Some(tip_mm), axis);
        Ok(Point { tip_mm, axis, approach: Approach::Rapid, line: record.last_line() })
    }

    /// `MSYS/ox,oy,oz,xx,xy,xz,yx,yy,yz`. The tool axis is its Z until a record gives another.
    pub(super) fn frame(&mut self, record: &Record) -> Result<(), Diagnostic> {
        if record.len() != 9 {
            return Err(record.missing(9, "expected 9 numbers: the origin, the directions of X and of Y"));
        }
        let origin_mm = scale(self.unit_mm, record.numbers(0)?);
        let frame = Frame::new(origin_mm, record.numbers(3)?, record.numbers(6)?).ok_or_else(|| {
            let error = Diagnostic::error(&FLAT_FRAME, "the axes of this MSYS span no plane");
            error.at(record.place_of_all(), "X and Y are parallel, or one of them is zero")
        })?;
        self.placement.set(frame);
        self.axis = self.placement.direction(ALONG_Z);
        Ok(())
    }
}
