//! What rounding of the program's words explains.

use super::pose::Pose;
use crate::certificate::Deviation;
use crate::machine::{Machine, Motion};
use crate::motion::Arc;
use crate::nc::dialect::{Dialect, Word};
use crate::number::Picture;
use crate::vector::{Vec3, cross, dot, norm, sub};

/// CL data is written with four digits behind the point, or more.
const CL_MM: f64 = 0.000_1;

/// How far what a program says may be from what its CL says.
#[derive(Debug, Clone)]
pub(super) struct Tolerance<'m> {
    machine: &'m Machine,
    /// Half of the last digits of all linear words, in millimetres.
    linear_mm: f64,
    /// Half of the last digit of each axis' word, in degrees; zero for a linear one.
    rotary_deg: Vec<f64>,
    /// The last digit of each axis' word, in millimetres or degrees.
    digit: Vec<f64>,
    /// Of the angle that the tool axis may be off by.
    axis_sine: f64,
    /// Half of the last digit of a feed.
    pub(super) feed_mm_per_min: f64,
    pub(super) feed_mm_per_rev: f64,
}

impl<'m> Tolerance<'m> {
    pub(super) fn of(machine: &'m Machine, dialect: &Dialect) -> Self {
        let unit_mm = dialect.units.mm();
        let words = machine.axes.iter().zip(&dialect.axes);
        let linear = words.clone().filter(|(axis, _)| axis.motion == Motion::Linear);
        let squares: f64 = linear.map(|(_, word)| (unit_mm * half_digit(word)) * (unit_mm * half_digit(word))).sum();
        let rotary = |(axis, word): (&crate::machine::Axis, &Word)| match axis.motion {
            Motion::Rotary => half_digit(word),
            Motion::Linear => 0.0,
        };
        let rotary_deg: Vec<f64> = words.map(rotary).collect();
        let words_rad = rotary_deg.iter().sum::<f64>().to_radians();
        let axis_rad = words_rad + machine.axis_tolerance_rad + left_alone_rad(machine);
        let digit = |(axis, word): (&crate::machine::Axis, &Word)| match axis.motion {
            Motion::Linear => 2.0 * unit_mm * half_digit(word),
            Motion::Rotary => 2.0 * half_digit(word),
        };
        Self {
            machine,
            digit: machine.axes.iter().zip(&dialect.axes).map(digit).collect(),
            linear_mm: squares.sqrt() + CL_MM + machine.plane_tolerance_mm,
            rotary_deg,
            axis_sine: libm::sin((1.01 * axis_rad).min(std::f64::consts::FRAC_PI_2)),
            feed_mm_per_min: 1.01 * dialect.feed_unit_mm() * half_digit(&dialect.feed),
            feed_mm_per_rev: 1.01 * unit_mm * half_digit(&dialect.feed_per_revolution),
        }
    }

    /// Whether two poses differ by no more than rounding of the words, where the joints are these.
    pub(super) fn agrees(&self, found: Pose, wanted: Pose, joints: &[f64]) -> bool {
        let Deviation { tip_mm_squared, .. } = found.deviation(wanted);
        let within = |bound_mm: f64| tip_mm_squared <= bound_mm * bound_mm;
        self.is_same_axis(found, wanted) && (within(self.linear_mm) || within(self.tip_mm(joints)))
    }

    /// The axis whose word is off by more than its last digit, and by how much.
    pub(super) fn wrong_word(&self, off: &[f64]) -> Option<(&str, f64)> {
        let wrong = off.iter().zip(&self.digit).position(|(off, digit)| *off > *digit + CL_MM)?;
        Some((&self.machine.axes[wrong].name, off[wrong]))
    }

    /// Whether two poses are one.
    pub(super) fn is_same(&self, a: Pose, b: Pose) -> bool {
        self.is_same_axis(a, b) && a.deviation(b).tip_mm_squared <= self.linear_mm * self.linear_mm
    }

    fn is_same_axis(&self, a: Pose, b: Pose) -> bool {
        let Deviation { sine_squared, cosine, .. } = a.deviation(b);
        cosine > 0.0 && sine_squared <= self.axis_sine * self.axis_sine
    }

    /// Whether two values of a word are one.
    pub(super) fn is_same_word(&self, a: f64, b: f64) -> bool {
        (a - b).abs() <= self.linear_mm
    }

    /// What rounding does to the tip, in millimetres.
    fn tip_mm(&self, joints: &[f64]) -> f64 {
        let chain = &self.machine.chain;
        let mut pose = (chain.tip_at_home(self.machine.tool()), chain.tool_axis);
        let mut bound_mm = self.linear_mm;
        for joint in chain.joints.iter().rev() {
            let radius_mm = norm(cross(joint.direction, sub(pose.0, joint.point_mm)));
            bound_mm += self.rotary_deg[joint.axis].to_radians() * radius_mm;
            pose = joint.moved(joint.signed(joints[joint.axis]), pose);
        }
        bound_mm
    }

    /// Whether a tip lies on an arc: of a machine whose other axes stand.
    pub(super) fn is_on_arc(&self, arc: &Arc, there: Pose) -> bool {
        let from_centre: Vec3 = sub(self.in_machine(there.tip_mm), arc.centre_mm);
        let along = dot(from_centre, arc.normal);
        let flat = norm(sub(from_centre, arc.normal.map(|n| along * n)));
        (flat - arc.radius_mm).abs() <= self.machine.chord_tolerance_mm + self.linear_mm
    }

    /// Where the linear axes stand for a tip of a machine whose rotary axes are at zero, in machine coordinates.
    fn in_machine(&self, tip_mm: Vec3) -> Vec3 {
        sub(tip_mm, self.machine.chain.tip_at_home(self.machine.tool()))
    }
}

/// The turns of the tool by measured errors, which next to a pole are not compensated.
fn left_alone_rad(machine: &Machine) -> f64 {
    let turns = machine.errors.iter().filter(|table| table.component.is_turn());
    turns.map(|table| table.rows.iter().map(|(_, error_rad)| error_rad.abs()).fold(0.0, f64::max)).sum()
}

/// Half of the last digit of a word, in its unit.
fn half_digit(word: &Word) -> f64 {
    let Word { picture, .. } = word;
    0.5 / Picture::units_per_one(picture) as f64
}
