//! Motion: where the tool is, and the records that move it.

use crate::cl::arc::{ArcPoints, Circle};
use crate::cl::event::{Approach, Feed, Point};
use crate::cl::record::Record;
use crate::diagnostic::{Code, Diagnostic};
use crate::nc::dialect::LengthUnit;
use crate::place::{Frame, Placement};
use crate::vector::{Vec3, add, norm, scale, sub};

/// No machine tool is a kilometre long.
const FARTHEST_MM: f64 = 1e6;
/// How far an arc's ends may be from its circle, in millimetres: what four decimals of an inch can do to them, and some.
const ARC_END_TOLERANCE_MM: f64 = 0.01;
/// How far the length of a unit vector may be from 1.
const UNIT_TOLERANCE: f64 = 1e-3;
/// The most turns of one helix.
const MOST_TURNS: f64 = 10_000.0;

/// A number that cannot be meant.
pub(super) static OUT_OF_RANGE: Code = Code {
    id: "E1015",
    title: "a number of the CL is out of range",
    explanation: "\
The number is larger than anything a machine tool can do (a coordinate beyond 1,000,000 mm, say), or zero or negative where
only a positive number makes sense. The file may be damaged.
",
};

/// A direction without length.
pub(super) static ZERO_VECTOR: Code = Code {
    id: "E1016",
    title: "a direction has no length",
    explanation: "\
A tool axis or a circle's normal is a unit vector. One of length zero points nowhere:

    GOTO/10.0,20.0,30.0,0.0,0.0,0.0

Leave the three numbers out to keep the last tool axis.
",
};

/// A unit vector that is none.
pub(super) static NOT_UNIT: Code = Code {
    id: "W1002",
    title: "a direction is not a unit vector",
    explanation: "\
The length of a tool axis or of a circle's normal is off 1 by more than 0.001. It has been made a unit vector; but CAM
systems write unit vectors, so this may be another kind of data (a point on the axis, angles). Reported once a file.
",
};

/// An arc whose ends are not on its circle.
pub(super) static OFF_CIRCLE: Code = Code {
    id: "E1020",
    title: "an end of an arc is not on its circle",
    explanation: "\
A CIRCLE record gives centre, normal and radius; the arc goes from where the tool is to the GOTO that follows. Both must lie
on the circle (or, for a helix, on its cylinder) within 0.01 mm:

    GOTO/10.0,0.0,0.0
    CIRCLE/0.0,0.0,0.0,0.0,0.0,1.0,10.0,0.06,0.5,10.0,0.0
    GOTO/0.0,10.0,0.0
",
};

/// An arc that lacks an end or a beginning.
pub(super) static OPEN_ARC: Code = Code {
    id: "E1021",
    title: "an arc has no beginning or no end",
    explanation: "\
A CIRCLE record needs a position to start from, and it is followed by one GOTO with the end of the arc. Only display records
(PAINT) may stand between.
",
};

/// An arc along which the tool would have to tilt.
pub(super) static TILTING_ARC: Code = Code {
    id: "E1023",
    title: "the tool axis changes along an arc",
    explanation: "\
The GOTO that ends an arc has another tool axis than the one at its beginning, and nothing says how the axis goes from the
one to the other. Let the CAM system put out lines instead of arcs here.
",
};

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

/// An MSYS with another number of numbers.
pub(super) static ODD_FRAME: Code = Code {
    id: "W1001",
    title: "an MSYS without nine numbers is left out",
    explanation: "\
MSYS has nine numbers: the origin, the direction of X, the direction of Y. With another number of them nobody knows which
one is missing, so the frame is taken as unchanged. If it should have changed, mend the record.
",
};

/// Text that goes to the control as it is.
pub(super) static INSERTED: Code = Code {
    id: "W1005",
    title: "the text of an INSERT becomes a comment",
    explanation: "\
INSERT hands its text to the control as it is. Such text cannot be checked, so it is written as a comment. Reported once a
file.
",
};

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
    chord_tolerance_mm: f64,
    placement: Placement,
    tip_mm: Option<Vec3>,
    axis: Vec3,
    home_mm: Option<Vec3>,
    circle: Option<(Circle, Diagnostic)>,
    pub(super) once: Once,
}

/// Warnings that are given once a file, at its end.
#[derive(Debug, Default)]
pub(super) struct Once {
    not_unit: Option<(Diagnostic, u64)>,
    inserted: Option<Diagnostic>,
}

impl Once {
    /// The warnings, with how often there was a cause.
    pub(super) fn take(&mut self) -> Vec<Diagnostic> {
        let not_unit = self.not_unit.take().map(|(first, count)| match count {
            1 => first,
            _ => first.note(format!("{count} records of the file have such a direction")),
        });
        [self.inserted.take(), not_unit].into_iter().flatten().collect()
    }

    /// Remembers the first INSERT.
    pub(super) fn inserted(&mut self, record: &Record) {
        let warning = || Diagnostic::warning(&INSERTED, "the text of an INSERT is written as a comment");
        self.inserted.get_or_insert_with(|| warning().at(record.place(), "not handed to the control"));
    }
}

impl Motion {
    pub(super) fn new(unit: LengthUnit, chord_tolerance_mm: f64) -> Self {
        Self {
            unit_mm: unit_mm(unit),
            feed: None,
            rapid: false,
            chord_tolerance_mm,
            placement: Placement::default(),
            tip_mm: None,
            axis: [0.0, 0.0, 1.0],
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

    fn go(&mut self, tip_mm: Vec3, axis: Vec3, line: u64) -> Point {
        let approach = if self.rapid { Approach::Rapid } else { Approach::Feed(self.feed) };
        self.rapid = false;
        self.axis = axis;
        self.tip_mm = Some(tip_mm);
        Point { tip_mm, axis, approach, line }
    }

    /// `GOTO/x,y,z[,i,j,k]`, also the end of an arc.
    pub(super) fn goto(&mut self, record: &Record) -> Result<Moved, Diagnostic> {
        let (tip_mm, axis) = self.pose(record)?;
        let start_mm = self.tip_mm;
        let Some((circle, open)) = self.circle.take() else {
            return Ok(Moved::To(self.go(tip_mm, axis, record.last_line())));
        };
        let Some(start_mm) = start_mm else { return Err(open) };
        let start_axis = self.axis;
        let last = self.go(tip_mm, axis, record.last_line());
        if norm(sub(axis, start_axis)) > UNIT_TOLERANCE {
            let error = Diagnostic::error(&TILTING_ARC, "the tool axis changes along this arc");
            return Err(error.at(record.place_of_all(), "another axis than at the arc's beginning"));
        }
        for (point_mm, end) in [(start_mm, "the beginning"), (tip_mm, "the end")] {
            let off_mm = circle.distance_mm(point_mm);
            if off_mm > ARC_END_TOLERANCE_MM {
                let message = format!("{end} of the arc is {off_mm:.3} mm off its circle");
                let error = Diagnostic::error(&OFF_CIRCLE, message).at(record.place_of_all(), "the arc ends here");
                return Err(open.labels.into_iter().fold(error, |error, label| error.at(label.place, "the circle")));
            }
        }
        Ok(Moved::Along(circle.points(start_mm, tip_mm, self.chord_tolerance_mm), last))
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

    /// `CIRCLE/cx,cy,cz,i,j,k,r,t,f,d,e[,TIMES,n]`: what the next GOTO ends.
    pub(super) fn circle(&mut self, record: &Record) -> Result<(), Diagnostic> {
        let times = match record.len() {
            11 => 1.0,
            13 if record.argument(11) == "TIMES" => record.number(12)?,
            7 => {
                let error = record.missing(7, "NX writes 11 numbers");
                return Err(error.note("a CIRCLE of 7 numbers is another system's: it would turn the other way"));
            }
            _ => return Err(record.missing(13, "expected 11 numbers, and `TIMES` with a number where turns are meant")),
        };
        record.numbers::<11>(0)?;
        if times.fract() != 0.0 || !(1.0..=MOST_TURNS).contains(&times) {
            return Err(out_of_range(record, 12, "turns are counted from 1 to 10000"));
        }
        let radius_mm = record.number(6)? * self.unit_mm;
        if !(radius_mm > 0.0 && radius_mm <= FARTHEST_MM) {
            return Err(out_of_range(record, 6, "a radius is positive"));
        }
        let centre_mm = self.point(record, 0)?;
        let normal = self.direction(record, 3)?;
        let open = Diagnostic::error(&OPEN_ARC, "this arc has no beginning or no end");
        let open = open.at(record.place(), "needs a position before it and a GOTO after it");
        if self.tip_mm.is_none() {
            return Err(open);
        }
        self.circle = Some((Circle { centre_mm, normal, radius_mm, times: times as u32 }, open));
        Ok(())
    }

    /// `MSYS/ox,oy,oz,xx,xy,xz,yx,yy,yz`.
    pub(super) fn frame(&mut self, record: &Record) -> Result<(), Diagnostic> {
        if record.len() != 9 {
            let message = format!("MSYS has {} numbers instead of 9 and is left out", record.len());
            return Err(Diagnostic::warning(&ODD_FRAME, message).at(record.place_of_all(), "origin, X, Y: 9 numbers"));
        }
        let origin_mm = scale(self.unit_mm, record.numbers(0)?);
        let frame = Frame::new(origin_mm, record.numbers(3)?, record.numbers(6)?).ok_or_else(|| {
            let error = Diagnostic::error(&FLAT_FRAME, "the axes of this MSYS span no plane");
            error.at(record.place_of_all(), "X and Y are parallel, or one of them is zero")
        })?;
        self.placement.set(frame);
        Ok(())
    }

    fn pose(&mut self, record: &Record) -> Result<(Vec3, Vec3), Diagnostic> {
        let axis = match record.len() {
            3 => self.axis,
            6 => self.direction(record, 3)?,
            _ => return Err(record.missing(6, "expected 3 or 6 numbers")),
        };
        Ok((self.point(record, 0)?, axis))
    }

    fn point(&self, record: &Record, from: usize) -> Result<Vec3, Diagnostic> {
        checked(self.placement.point(scale(self.unit_mm, record.numbers(from)?)), record)
    }

    fn direction(&mut self, record: &Record, from: usize) -> Result<Vec3, Diagnostic> {
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

/// Millimetres in a unit.
pub(super) fn unit_mm(unit: LengthUnit) -> f64 {
    match unit {
        LengthUnit::Millimetre => 1.0,
        LengthUnit::Inch => 25.4,
    }
}

/// An error about a number that is out of range.
pub(super) fn out_of_range(record: &Record, index: usize, text: &str) -> Diagnostic {
    let message = format!("{} has a number that is out of range", record.word());
    Diagnostic::error(&OUT_OF_RANGE, message).at(record.place_of(index), text)
}

fn checked(point_mm: Vec3, record: &Record) -> Result<Vec3, Diagnostic> {
    match point_mm.iter().position(|mm| mm.is_nan() || mm.abs() > FARTHEST_MM) {
        Some(index) => Err(out_of_range(record, index, "no coordinate is beyond 1,000,000 mm")),
        None => Ok(point_mm),
    }
}
