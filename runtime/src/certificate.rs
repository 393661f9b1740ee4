//! The certificate: how close the printed program is to the CL, and how close the machine comes to its limits.

use crate::machine::{Axis, Motion};
use crate::number::fixed;
use crate::vector::{Vec3, cross, dot, sub};
use std::fmt;

/// The largest of something, and the CL line it was met at.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Extreme {
    /// Its value.
    pub value: f64,
    /// The line, from 1; 0 when nothing was met.
    pub line: u64,
}

impl Extreme {
    /// Takes the value if it is larger.
    #[inline]
    pub fn meet(&mut self, value: f64, line: u64) {
        if value > self.value || self.line == 0 {
            *self = Self { value, line };
        }
    }
}

/// The range an axis went through, as solved: millimetres or degrees, machine coordinates.
#[derive(Debug, Clone, PartialEq)]
pub struct Range {
    /// The axis.
    pub axis: Axis,
    /// Minus the least value, so that both ends are largest values.
    minus_least: Extreme,
    greatest: Extreme,
}

impl Range {
    /// An axis that has not gone anywhere yet.
    pub fn new(axis: &Axis) -> Self {
        Self { axis: axis.clone(), minus_least: Extreme::default(), greatest: Extreme::default() }
    }

    /// The axis goes to this joint value.
    #[inline]
    pub fn visit(&mut self, line: u64, joint: f64) {
        self.minus_least.meet(-joint, line);
        self.greatest.meet(joint, line);
    }

    /// The least value.
    pub fn least(&self) -> Extreme {
        Extreme { value: 0.0 - self.minus_least.value, ..self.minus_least }
    }

    /// The greatest value.
    pub fn greatest(&self) -> Extreme {
        self.greatest
    }

    /// Whether it has gone anywhere.
    pub fn is_visited(&self) -> bool {
        self.greatest.line != 0
    }

    /// From the lower travel limit to the least value; infinite without a limit.
    pub fn lower_margin(&self) -> f64 {
        self.least().value - self.axis.travel.lower
    }

    /// From the greatest value to the upper travel limit; infinite without a limit.
    pub fn upper_margin(&self) -> f64 {
        self.axis.travel.upper - self.greatest.value
    }
}

/// What was found when the printed program was read back and compared with the CL at every point, and what the machine does
/// between two points, when its axes move linearly.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// Points of the toolpath, those of arcs included.
    pub points: u64,
    /// Motion blocks printed; a point at which no word changes prints none.
    pub blocks: u64,
    /// How far the tool is from the CL's points at most, at the CL's line.
    pub worst: Worst,
    /// The largest sum of rotary motion in one block at feed, in degrees.
    pub rotary_step_deg: Extreme,
    /// How far the tip leaves the straight line between two points at most.
    pub between: Between,
    /// Of each axis.
    pub ranges: Vec<Range>,
}

impl Certificate {
    /// Nothing compared yet.
    pub fn new(axes: &[Axis]) -> Self {
        Self {
            points: 0,
            blocks: 0,
            worst: Worst::default(),
            rotary_step_deg: Extreme::default(),
            between: Between::default(),
            ranges: axes.iter().map(Range::new).collect(),
        }
    }

    /// The joints of a point.
    pub(crate) fn visit(&mut self, line: u64, joints: &[f64]) {
        for (range, &joint) in self.ranges.iter_mut().zip(joints) {
            range.visit(line, joint);
        }
    }

    /// The rotary motion of a block at feed.
    pub(crate) fn step(&mut self, line: u64, rotary_deg: f64) {
        self.rotary_step_deg.meet(rotary_deg, line);
    }
}

/// How far the tip leaves the straight line between two points, while every axis moves linearly: bounds that are proved
/// ([`crate::segment`]), in millimetres, at the line of the point where the block ends.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Between {
    /// At feed.
    pub feed_mm: Extreme,
    /// In rapid traverse, if the axes move linearly there too.
    pub rapid_mm: Extreme,
    /// How many blocks at feed may leave their line by more than the machine's chord tolerance, by the quick bound.
    pub beyond_tolerance: u64,
}

/// The way to a point from the one before it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Way {
    /// Whether it is gone at feed.
    pub(crate) is_cut: bool,
    /// The line of the point where it ends.
    pub(crate) line: u64,
    /// A bound on how far the tip leaves its line that costs little.
    pub(crate) quick_mm: f64,
}

impl Between {
    /// Takes a way. Only what may be the worst is looked at closely.
    #[inline]
    pub(crate) fn meet(&mut self, way: Way, tolerance_mm: f64, deviation_mm: impl FnOnce() -> f64) {
        let Way { is_cut, line, quick_mm } = way;
        let worst = if is_cut { &mut self.feed_mm } else { &mut self.rapid_mm };
        if worst.line == 0 || quick_mm > worst.value {
            worst.meet(deviation_mm(), line);
        }
        self.beyond_tolerance += u64::from(is_cut && quick_mm > tolerance_mm);
    }
}

/// How far poses are from the wanted ones at most.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Worst {
    /// The distance of the tips, in millimetres.
    pub tip_mm: Extreme,
    /// The angle between the axes, in radians.
    pub axis_rad: Extreme,
}

/// How far a pose is from the wanted one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Deviation {
    /// The square of the distance of the tips, in mm².
    pub(crate) tip_mm_squared: f64,
    /// The square of the sine of the angle between the axes.
    pub(crate) sine_squared: f64,
    /// The cosine of that angle.
    pub(crate) cosine: f64,
}

impl Deviation {
    /// From where a tip and a unit axis should be to where they are.
    #[inline]
    pub(crate) fn new(wanted: [Vec3; 2], found: [Vec3; 2]) -> Self {
        let [apart_mm, normal] = [sub(found[0], wanted[0]), cross(found[1], wanted[1])];
        Self {
            tip_mm_squared: dot(apart_mm, apart_mm),
            sine_squared: dot(normal, normal),
            cosine: dot(found[1], wanted[1]),
        }
    }
}

impl Worst {
    /// Takes a deviation, at a line.
    #[inline]
    pub(crate) fn meet(&mut self, Deviation { tip_mm_squared, sine_squared, cosine }: Deviation, line: u64) {
        // Roots and arc tangents are for the few points that may be the worst; an angle is at most its tangent.
        if self.tip_mm.line == 0 || tip_mm_squared > lower_square(self.tip_mm.value) {
            self.tip_mm.meet(tip_mm_squared.sqrt(), line);
        }
        if self.axis_rad.line == 0 || cosine <= 0.0 || sine_squared > lower_square(self.axis_rad.value * cosine) {
            self.axis_rad.meet(libm::atan2(sine_squared.sqrt(), cosine), line);
        }
    }
}

/// A little less than the square, so that no root above the value has a square below it, whatever rounding does.
#[inline]
fn lower_square(value: f64) -> f64 {
    (1.0 - 8.0 * f64::EPSILON) * (value * value)
}

impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "certificate: the program was read back and compared with the CL at every point")?;
        writeln!(f, "  {:<22}{} points, {} motion blocks", "toolpath", self.points, self.blocks)?;
        let worst = |f: &mut fmt::Formatter<'_>, title: &str, value: String, extreme: &Extreme| {
            writeln!(f, "  {title:<22}{value} at line {}", extreme.line)
        };
        worst(f, "largest tip error", format!("{:.6} mm", self.worst.tip_mm.value), &self.worst.tip_mm)?;
        worst(
            f,
            "largest axis error",
            format!("{:.6} deg", self.worst.axis_rad.value.to_degrees()),
            &self.worst.axis_rad,
        )?;
        if !self.ranges.iter().any(|range| range.axis.motion == Motion::Rotary) {
            return self.ranges.iter().try_for_each(|range| writeln!(f, "  {range}"));
        }
        if self.rotary_step_deg.line != 0 {
            let step = format!("{:.3} deg", self.rotary_step_deg.value);
            worst(f, "largest rotary step", step, &self.rotary_step_deg)?;
        }
        let Between { feed_mm, rapid_mm, .. } = &self.between;
        for (title, bound_mm) in [("off the line in cuts", feed_mm), ("off the line in rapid", rapid_mm)] {
            if bound_mm.line != 0 {
                worst(f, title, format!("at most {:.6} mm", bound_mm.value), bound_mm)?;
            }
        }
        self.ranges.iter().try_for_each(|range| writeln!(f, "  {range}"))
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unit = self.axis.motion.unit();
        let span = format!("{} .. {} {unit}", fixed(self.least().value, 3), fixed(self.greatest.value, 3));
        write!(f, "{:<22}{span:<30}", format!("{} goes", self.axis.name))?;
        match (self.lower_margin().is_finite(), self.upper_margin().is_finite()) {
            (false, false) => write!(f, "no limit"),
            (true, false) => write!(f, "{:.3} {unit} to the lower limit", self.lower_margin()),
            (false, true) => write!(f, "{:.3} {unit} to the upper limit", self.upper_margin()),
            (true, true) => {
                write!(f, "{:.3} and {:.3} {unit} to the limits", self.lower_margin(), self.upper_margin())
            }
        }
    }
}
