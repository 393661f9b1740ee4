//! Arcs and helices: from a circle and its ends to points within a tolerance.

use std::f64::consts::{FRAC_PI_4, TAU};

use crate::vector::{Vec3, add, cross, dot, norm, scale, sub};

/// The longest arc without a point between, in radians, however wide the tolerance.
const LONGEST_STEP_RAD: f64 = FRAC_PI_4;
/// Ends closer together than this, in millimetres, make a full circle.
const CLOSED_MM: f64 = 1e-6;

/// A circle in space, run through so that its normal points along the thumb of the left hand, as NX has it: seen from
/// the tip of the normal, the tool goes clockwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Circle {
    /// The centre, in millimetres.
    pub(super) centre_mm: Vec3,
    /// The unit normal.
    pub(super) normal: Vec3,
    /// The radius, in millimetres.
    pub(super) radius_mm: f64,
    /// How many turns are begun, at least 1.
    pub(super) times: u32,
}

impl Circle {
    /// How far a point is from the circle's cylinder, in millimetres.
    pub(super) fn distance_mm(&self, point_mm: Vec3) -> f64 {
        (norm(self.radial(point_mm)) - self.radius_mm).abs()
    }

    fn radial(&self, point_mm: Vec3) -> Vec3 {
        let v = sub(point_mm, self.centre_mm);
        sub(v, scale(dot(self.normal, v), self.normal))
    }

    /// The points that follow `start_mm` on the way to `end_mm`. Both lie close to the cylinder; radius and height go
    /// evenly from the one's to the other's, so that both ends are met.
    pub(super) fn points(&self, start_mm: Vec3, end_mm: Vec3, chord_tolerance_mm: f64) -> ArcPoints {
        let (start, end) = (self.radial(start_mm), self.radial(end_mm));
        let u = scale(1.0 / norm(start), start);
        let v = cross(u, self.normal);
        let angle = libm::atan2(dot(end, v), dot(end, u));
        let closed = norm(sub(end, start)) < CLOSED_MM;
        let last_turn_rad = match angle {
            _ if closed => TAU,
            _ if angle <= 0.0 => angle + TAU,
            _ => angle,
        };
        let sweep_rad = f64::from(self.times - 1) * TAU + last_turn_rad;
        // A chord of the angle 2h leaves the arc by r (1 - cos h) = 2 r sin²(h/2).
        let ratio = (chord_tolerance_mm / (2.0 * self.radius_mm)).min(1.0);
        let step_rad = (4.0 * libm::asin(ratio.sqrt())).min(LONGEST_STEP_RAD);
        let height = |point| dot(self.normal, sub(point, self.centre_mm));
        ArcPoints {
            centre_mm: self.centre_mm,
            basis: [u, v, self.normal],
            radius_mm: [norm(start), norm(end)],
            height_mm: [height(start_mm), height(end_mm)],
            end_mm,
            sweep_rad,
            count: (sweep_rad / step_rad).ceil().max(1.0) as u64,
            done: 0,
        }
    }
}

/// The points of an arc, made one by one: a long helix takes no memory.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ArcPoints {
    centre_mm: Vec3,
    /// Towards the start, a quarter turn on, along the normal.
    basis: [Vec3; 3],
    radius_mm: [f64; 2],
    height_mm: [f64; 2],
    end_mm: Vec3,
    sweep_rad: f64,
    count: u64,
    done: u64,
}

impl Iterator for ArcPoints {
    type Item = Vec3;

    fn next(&mut self) -> Option<Vec3> {
        if self.done == self.count {
            return None;
        }
        self.done += 1;
        if self.done == self.count {
            return Some(self.end_mm);
        }
        let share = self.done as f64 / self.count as f64;
        let between = |ends: [f64; 2]| ends[0] + share * (ends[1] - ends[0]);
        let (sine, cosine) = libm::sincos(share * self.sweep_rad);
        let radial = add(scale(cosine, self.basis[0]), scale(sine, self.basis[1]));
        let height = scale(between(self.height_mm), self.basis[2]);
        Some(add(self.centre_mm, add(scale(between(self.radius_mm), radial), height)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CIRCLE: Circle = Circle { centre_mm: [0.0; 3], normal: [0.0, 0.0, 1.0], radius_mm: 10.0, times: 1 };

    fn swept_deg(circle: Circle, start: Vec3, end: Vec3) -> f64 {
        circle.points(start, end, 0.01).sweep_rad.to_degrees()
    }

    #[test]
    fn the_normal_is_the_thumb_of_the_left_hand() {
        let (east, north) = ([10.0, 0.0, 0.0], [0.0, 10.0, 0.0]);
        assert!((swept_deg(CIRCLE, east, north) - 270.0).abs() < 1e-9);
        assert!((swept_deg(CIRCLE, north, east) - 90.0).abs() < 1e-9);
        assert!((swept_deg(Circle { normal: [0.0, 0.0, -1.0], ..CIRCLE }, east, north) - 90.0).abs() < 1e-9);
    }

    #[test]
    fn times_counts_the_turns_that_are_begun() {
        let (east, north) = ([10.0, 0.0, 0.0], [0.0, 10.0, -5.0]);
        assert!((swept_deg(CIRCLE, east, east) - 360.0).abs() < 1e-9);
        assert!((swept_deg(Circle { times: 3, ..CIRCLE }, east, east) - 1080.0).abs() < 1e-9);
        assert!((swept_deg(Circle { times: 3, ..CIRCLE }, east, north) - 990.0).abs() < 1e-9);
    }

    #[test]
    fn chords_stay_within_the_tolerance_and_meet_the_end() {
        let start = [10.0, 0.0, 0.0];
        let mut last = start;
        let points: Vec<Vec3> = CIRCLE.points(start, [0.0, 10.0, 4.0], 0.01).collect();
        for point in &points {
            assert!((norm([point[0], point[1], 0.0]) - 10.0).abs() < 1e-9);
            let middle = scale(0.5, add(last, *point));
            assert!(10.0 - norm([middle[0], middle[1], 0.0]) <= 0.01 + 1e-12);
            assert!(point[2] > last[2]);
            last = *point;
        }
        assert_eq!(last, [0.0, 10.0, 4.0]);
        assert_eq!(points.len(), 53);
    }

    #[test]
    fn a_tolerance_wider_than_the_circle_still_leaves_a_circle() {
        assert_eq!(CIRCLE.points([10.0, 0.0, 0.0], [10.0, 0.0, 0.0], 1000.0).count(), 8);
    }
}
