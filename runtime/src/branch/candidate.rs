//! One solution of the inverse, with whole turns chosen and the travel looked at.

use crate::machine::{Axis, Motion, Rule, Travel};

/// How far beyond its travel an axis may stand, in mm or degrees, before it counts as beyond: far above what rounding
/// does to a joint on its limit, far below what any program prints.
const TRAVEL_TOLERANCE: f64 = 1e-6;

/// A solution of the inverse at a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// In machine coordinates, millimetres and degrees, in the machine's order.
    pub joints: Vec<f64>,
    /// The axis that is farthest beyond its travel, if one is; rotary axes first.
    pub obstacle: Option<Obstacle>,
    /// The travel of the rotary axes from the previous position (from zero at the start), in degrees, summed.
    pub rotary_travel_deg: f64,
    /// The same if the travel's limits let each have the whole turns that are nearest.
    ideal_travel_deg: f64,
}

/// An axis beyond its travel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Obstacle {
    /// Its index.
    pub axis: usize,
    /// By how much, in millimetres or degrees.
    pub beyond: f64,
}

impl Obstacle {
    /// A rotary axis beyond its travel counts for more than a linear one: where the linear axes are is its doing.
    fn outweighs(&self, other: Self, axes: &[Axis]) -> bool {
        let is_rotary = |obstacle: &Self| axes[obstacle.axis].motion == Motion::Rotary;
        (is_rotary(self), self.beyond) > (is_rotary(&other), other.beyond)
    }
}

impl Candidate {
    pub(super) fn new(axes: usize) -> Self {
        Self { joints: vec![0.0; axes], obstacle: None, rotary_travel_deg: 0.0, ideal_travel_deg: 0.0 }
    }

    /// Turns the rotaries that the pose decides to where they are nearest to the previous position (to zero at the start)
    /// within their travel, puts the locked axes where they stand, and looks for obstacles.
    pub(super) fn settle(&mut self, axes: &[Axis], previous: Option<&[f64]>) {
        (self.obstacle, self.rotary_travel_deg, self.ideal_travel_deg) = (None, 0.0, 0.0);
        let Self { joints, obstacle, .. } = self;
        for (index, (axis, joint)) in axes.iter().zip(joints).enumerate() {
            if let Rule::Locked(value) = axis.rule {
                *joint = value;
            }
            if axis.motion == Motion::Rotary {
                let reference = previous.map_or(0.0, |previous| previous[index]);
                let (ideal, within) = match axis.rule {
                    Rule::Pose => turns(*joint, reference, axis.travel),
                    _ => (*joint, *joint),
                };
                self.ideal_travel_deg += (ideal - reference).abs();
                self.rotary_travel_deg += (within - reference).abs();
                *joint = within;
            }
            if !is_within(*joint, axis.travel) {
                let found = Obstacle { axis: index, beyond: beyond(*joint, axis.travel) };
                if found.beyond > TRAVEL_TOLERANCE && obstacle.is_none_or(|known| found.outweighs(known, axes)) {
                    *obstacle = Some(found);
                }
            }
        }
    }

    /// The rotary travel without any limit of the travel.
    pub(super) fn ideal_travel_deg(&self) -> f64 {
        self.ideal_travel_deg
    }

    /// Whether the travel asked for other whole turns.
    pub(super) fn is_turned(&self) -> bool {
        self.ideal_travel_deg != self.rotary_travel_deg
    }

    /// Whether the linear axes span space there: the joints are numbers.
    pub(super) fn is_regular(&self) -> bool {
        self.joints.iter().sum::<f64>().is_finite()
    }
}

/// Whether a value is inside of a travel.
#[inline]
fn is_within(value: f64, travel: Travel) -> bool {
    travel.lower <= value && value <= travel.upper
}

/// How far a value is outside of a travel.
fn beyond(value: f64, travel: Travel) -> f64 {
    (travel.lower - value).max(value - travel.upper).max(0.0)
}

/// The value with the whole turns nearest to the reference: at will, and within the travel.
fn turns(value: f64, reference: f64, travel: Travel) -> (f64, f64) {
    // The half turn is written as positive.
    let value = if value == -180.0 { 180.0 } else { value };
    let apart = reference - value;
    let nearest = if apart.abs() <= 180.0 { 0.0 } else { round_to_zero(apart / 360.0) };
    let ideal = value + 360.0 * nearest;
    if is_within(ideal, travel) {
        return (ideal, ideal);
    }
    let fewest = ((travel.lower - TRAVEL_TOLERANCE - value) / 360.0).ceil();
    let most = ((travel.upper + TRAVEL_TOLERANCE - value) / 360.0).floor();
    let within = if fewest <= most { nearest.clamp(fewest, most) } else { least_beyond(value, nearest, travel) };
    (ideal, value + 360.0 * within)
}

/// The whole turns that come nearest to the travel.
fn least_beyond(value: f64, nearest: f64, travel: Travel) -> f64 {
    let below = ((travel.lower - value) / 360.0).floor();
    let above = ((travel.upper - value) / 360.0).ceil();
    [nearest, below, above]
        .into_iter()
        .filter(|turns| turns.is_finite())
        .min_by(|a, b| beyond(value + 360.0 * a, travel).total_cmp(&beyond(value + 360.0 * b, travel)))
        .expect("the nearest is finite")
}

/// The nearest whole number, the one nearer to zero of two equally near.
fn round_to_zero(x: f64) -> f64 {
    (x.abs() - 0.5).ceil().copysign(x) + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_turns_come_near_the_reference_within_the_travel() {
        let travel = Travel { lower: -360.0, upper: 360.0 };
        assert_eq!(turns(-170.0, 170.0, travel), (190.0, 190.0));
        assert_eq!(turns(10.0, 359.0, travel), (370.0, 10.0));
        assert_eq!(turns(180.0, 0.0, travel), (180.0, 180.0));
        assert_eq!(turns(-180.0, 0.0, travel), (180.0, 180.0));
        assert_eq!(turns(-1e-15, 0.0, Travel { lower: 0.0, upper: 180.0 }), (-1e-15, -1e-15));
        assert_eq!(turns(5.0, 3600.0, Travel::UNLIMITED), (3605.0, 3605.0));
    }

    #[test]
    fn a_value_that_no_turn_brings_into_the_travel_is_brought_nearest() {
        let travel = Travel { lower: -30.0, upper: 120.0 };
        assert_eq!(turns(-170.0, 0.0, travel).1, 190.0);
        assert_eq!(turns(-31.0, 0.0, travel).1, -31.0);
    }
}
