//! One solution of the inverse, with whole turns chosen and the travel looked at.

use crate::kinematics::Lane;
use crate::machine::{Axis, Motion, Rule, Travel};

/// Angles that differ by less than this, in degrees, are equal: rounding must not decide.
pub(super) const TIE_DEG: f64 = 1e-9;

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

/// What the axes ask of a candidate.
#[derive(Debug)]
pub(super) struct Rules<'m> {
    axes: &'m [Axis],
    locked: Vec<(usize, f64)>,
    rotaries: Vec<Rotary>,
}

#[derive(Debug)]
struct Rotary {
    axis: usize,
    travel: Travel,
    turns: bool,
}

impl<'m> Rules<'m> {
    pub(super) fn of(axes: &'m [Axis]) -> Self {
        let locked = axes.iter().enumerate().filter_map(|(index, axis)| match axis.rule {
            Rule::Locked(value) => Some((index, value)),
            _ => None,
        });
        let rotaries = axes.iter().enumerate().filter(|(_, axis)| axis.motion == Motion::Rotary);
        let rotary = |(index, axis): (usize, &Axis)| Rotary {
            axis: index,
            travel: axis.travel.numbers(),
            turns: takes_turns(axis),
        };
        Self { axes, locked: locked.collect(), rotaries: rotaries.map(rotary).collect() }
    }
}

/// Whether the axis may stand elsewhere than a solution says: whole turns away.
pub(super) fn takes_turns(axis: &Axis) -> bool {
    axis.motion == Motion::Rotary && axis.rule == Rule::Pose
}

impl Candidate {
    pub(super) fn new(axes: usize) -> Self {
        let joints = vec![0.0; axes];
        Self { joints, obstacle: None, rotary_travel_deg: 0.0, ideal_travel_deg: 0.0 }
    }

    /// Takes over what a solution says in one lane.
    #[inline]
    pub(super) fn load(&mut self, solution: &[Lane], lane: usize) {
        for (joint, lanes) in self.joints.iter_mut().zip(solution) {
            *joint = lanes[lane];
        }
    }

    /// Puts the locked axes where they stand, and turns the rotaries that the pose decides to where they are nearest to the
    /// reference. False where that is not within their travel: then the candidate has to be settled within it.
    #[inline]
    pub(super) fn settle_freely(&mut self, rules: &Rules<'_>, reference: &[f64]) -> bool {
        let (mut travel_deg, mut is_within) = (0.0, true);
        self.lock(rules);
        for Rotary { axis, travel, turns } in &rules.rotaries {
            let (joint, reference) = (&mut self.joints[*axis], reference[*axis]);
            *joint = if *turns { turned(*joint, reference) } else { *joint };
            travel_deg += (*joint - reference).abs();
            is_within &= travel.contains(*joint);
        }
        (self.ideal_travel_deg, self.rotary_travel_deg) = (travel_deg, travel_deg);
        self.obstacle = None;
        is_within
    }

    /// The same for the nearest to the reference that is within the travel; then looks for obstacles.
    #[cold]
    pub(super) fn settle_within_travel(&mut self, rules: &Rules<'_>, reference: &[f64]) {
        self.lock(rules);
        (self.ideal_travel_deg, self.rotary_travel_deg) = (0.0, 0.0);
        for Rotary { axis, travel, turns } in &rules.rotaries {
            let (joint, reference) = (&mut self.joints[*axis], reference[*axis]);
            let nearest = if *turns { turned(*joint, reference) } else { *joint };
            *joint =
                if *turns && !travel.contains(nearest) { turned_within(*joint, reference, *travel) } else { nearest };
            self.ideal_travel_deg += (nearest - reference).abs();
            self.rotary_travel_deg += (*joint - reference).abs();
        }
        self.look_for_obstacles(rules.axes);
    }

    #[inline]
    fn lock(&mut self, rules: &Rules<'_>) {
        for &(axis, value) in &rules.locked {
            self.joints[axis] = value;
        }
    }

    fn look_for_obstacles(&mut self, axes: &[Axis]) {
        self.obstacle = None;
        for (index, (axis, joint)) in axes.iter().zip(&self.joints).enumerate() {
            let found = Obstacle { axis: index, beyond: beyond(*joint, axis.travel) };
            if found.beyond > TRAVEL_TOLERANCE && self.obstacle.is_none_or(|known| found.outweighs(known, axes)) {
                self.obstacle = Some(found);
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
}

/// How far a value is outside of a travel.
fn beyond(value: f64, travel: Travel) -> f64 {
    (travel.lower - value).max(value - travel.upper).max(0.0)
}

/// An angle with the whole turns nearest to the reference, all in degrees.
#[inline]
fn turned(angle: f64, reference: f64) -> f64 {
    let angle = positive_half_turn(angle);
    angle + 360.0 * nearest_turns(reference - angle)
}

/// The half turn is written as positive, on whichever side of it rounding has put the angle.
#[inline]
fn positive_half_turn(angle: f64) -> f64 {
    if angle < TIE_DEG - 180.0 { angle + 360.0 } else { angle }
}

/// The whole turns that come nearest to so many degrees, the fewer of two equally near.
#[inline]
fn nearest_turns(apart_deg: f64) -> f64 {
    let size_deg = apart_deg.abs();
    if size_deg <= 180.0 + TIE_DEG {
        0.0
    } else if size_deg <= 540.0 + TIE_DEG {
        1.0_f64.copysign(apart_deg)
    } else {
        ((size_deg - TIE_DEG) / 360.0 - 0.5).ceil().copysign(apart_deg)
    }
}

/// The same within a travel that the nearest turns leave; where no turns bring it there, those that bring it nearest.
fn turned_within(angle: f64, reference: f64, travel: Travel) -> f64 {
    let angle = positive_half_turn(angle);
    let nearest = nearest_turns(reference - angle);
    let fewest = ((travel.lower - TRAVEL_TOLERANCE - angle) / 360.0).ceil();
    let most = ((travel.upper + TRAVEL_TOLERANCE - angle) / 360.0).floor();
    angle + 360.0 * if fewest <= most { nearest.clamp(fewest, most) } else { least_beyond(angle, nearest, travel) }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_turns_come_near_the_reference() {
        for (angle, reference, expected) in [
            (-170.0, 170.0, 190.0),
            (10.0, 359.0, 370.0),
            (180.0, 0.0, 180.0),
            (-180.0, 0.0, 180.0),
            (-1e-15, 0.0, -1e-15),
            (5.0, 3600.0, 3605.0),
            (5.0, -545.0, -715.0),
            (90.0, 630.0, 450.0),
            (-180.0 + 1e-13, 0.0, 180.0 + 1e-13),
            (10.0, 190.0 + 1e-12, 10.0),
            (10.0, -170.0 - 1e-12, 10.0),
            (10.0, 550.0 + 1e-12, 370.0),
            (10.0, 910.0 + 1e-12, 730.0),
        ] {
            assert!((turned(angle, reference) - expected).abs() < 1e-12, "{angle} near {reference}");
        }
    }

    #[test]
    fn whole_turns_stay_within_the_travel() {
        let travel = Travel { lower: -360.0, upper: 360.0 };
        assert_eq!(turned_within(10.0, 359.0, travel), 10.0);
        assert_eq!(turned_within(-170.0, 170.0, travel), 190.0);
        assert_eq!(turned_within(-1e-15, 0.0, Travel { lower: 0.0, upper: 180.0 }), -1e-15);
    }

    #[test]
    fn an_angle_that_no_turn_brings_into_the_travel_is_brought_nearest() {
        let travel = Travel { lower: -30.0, upper: 120.0 };
        assert_eq!(turned_within(-170.0, 0.0, travel), 190.0);
        assert_eq!(turned_within(-31.0, 0.0, travel), -31.0);
    }
}
