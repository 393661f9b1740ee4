//! CIRCLE: the record, and the GOTO that ends the arc.

use super::pose::UNIT_TOLERANCE;
use super::{Motion, Moved};
use crate::cl::arc::Circle;
use crate::cl::range::{FARTHEST_MM, out_of_range};
use crate::cl::record::Record;
use crate::diagnostic::{Code, Diagnostic};
use crate::vector::{Vec3, norm, sub};

/// How far an arc's ends may be from its circle, in millimetres: what four decimals of an inch can do to them, and some.
const ARC_END_TOLERANCE_MM: f64 = 0.01;
/// The most turns of one helix.
const MOST_TURNS: f64 = 10_000.0;

/// An arc whose ends are not on its circle.
pub(crate) static OFF_CIRCLE: Code = Code {
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
pub(crate) static OPEN_ARC: Code = Code {
    id: "E1021",
    title: "an arc has no beginning or no end",
    explanation: "\
A CIRCLE record needs a position to start from, and it is followed by one GOTO with the end of the arc. Only display records
(PAINT) may stand between.
",
};

/// An arc along which the tool would have to tilt.
pub(crate) static TILTING_ARC: Code = Code {
    id: "E1023",
    title: "the tool axis changes along an arc",
    explanation: "\
The GOTO that ends an arc has another tool axis than the one at its beginning, and nothing says how the axis goes from the
one to the other. Let the CAM system put out lines instead of arcs here.
",
};

impl Motion {
    /// `CIRCLE/cx,cy,cz,i,j,k,r,t,f,d,e[,TIMES,n]`: what the next GOTO ends.
    pub(crate) fn circle(&mut self, record: &Record) -> Result<(), Diagnostic> {
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

    /// The GOTO after a CIRCLE: from where the tool is, along the circle, to `tip_mm`.
    pub(super) fn arc_to(
        &mut self,
        tip_mm: Vec3,
        axis: Vec3,
        circle: &Circle,
        open: Diagnostic,
        record: &Record,
    ) -> Result<Moved, Diagnostic> {
        let Some(start_mm) = self.tip_mm else { return Err(open) };
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
}
