//! The solutions found for a pose.

use super::end::End;
use std::f64::consts::{PI, TAU};

/// Angles that differ by less are one solution found twice. Where two solutions meet, the residual is the square of the
/// angle, so that this is what the bound leaves open.
const SAME_ANGLE_RAD: f64 = 1e-6;

/// Distinct solutions, and what comes nearest where there are none. Joints are scaled.
#[derive(Debug, Default)]
pub(super) struct Found {
    pub(super) solutions: Vec<Vec<f64>>,
    nearest: Option<(f64, Vec<f64>)>,
}

impl Found {
    /// Takes what an iteration came to: these joints, with a residual of this size.
    pub(super) fn add(&mut self, end: End, residual: f64, joints: Vec<f64>, rotary: &[bool]) {
        let is_nearer = self.nearest.as_ref().is_none_or(|(nearest, _)| residual < *nearest);
        let is_new = !self.solutions.iter().any(|known| is_same(known, &joints, rotary));
        match end {
            End::There if is_new => self.solutions.push(joints),
            End::Nearest | End::Lost if residual.is_finite() && is_nearer => self.nearest = Some((residual, joints)),
            _ => {}
        }
    }

    /// The joints that come nearest of those that are no solution.
    pub(super) fn nearest(self) -> Option<Vec<f64>> {
        self.nearest.map(|(_, joints)| joints)
    }
}

/// Whether the rotary joints are the same up to whole turns.
fn is_same(a: &[f64], b: &[f64], rotary: &[bool]) -> bool {
    let angles = a.iter().zip(b).zip(rotary).filter(|(_, rotary)| **rotary);
    angles.map(|((a, b), _)| within_one_turn(a - b).abs()).all(|apart| apart < SAME_ANGLE_RAD)
}

/// From -π (excluded) to π.
pub(super) fn within_one_turn(angle_rad: f64) -> f64 {
    if -PI < angle_rad && angle_rad <= PI { angle_rad } else { angle_rad - TAU * ((angle_rad - PI) / TAU).ceil() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_is_taken_within_one_turn() {
        for (angle_rad, expected) in [(1.0, 1.0), (PI, PI), (-PI, PI), (-4.0, TAU - 4.0), (7.0, 7.0 - TAU)] {
            assert!((within_one_turn(angle_rad) - expected).abs() < 1e-15, "{angle_rad}");
        }
    }

    #[test]
    fn a_solution_found_twice_is_one() {
        let rotary = [false, true];
        let mut found = Found::default();
        found.add(End::There, 0.0, vec![1.0, 0.5], &rotary);
        found.add(End::There, 0.0, vec![1.0, 0.5 + TAU], &rotary);
        found.add(End::There, 0.0, vec![1.0, -0.5], &rotary);
        assert_eq!(found.solutions, [[1.0, 0.5], [1.0, -0.5]]);
    }
}
