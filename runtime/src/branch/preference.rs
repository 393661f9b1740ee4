//! The machine's preferences, compared in order.

use super::candidate::Candidate;
use super::rotary_travel_deg;
use crate::machine::{Axis, Preference};
use std::cmp::Ordering;

/// Angles that differ by less than this, in degrees, are equal to a preference: rounding must not decide.
const TIE_DEG: f64 = 1e-9;

/// The index of the best admissible candidate. With `ideal`, the values compared are those without the travel.
pub(super) fn best(
    candidates: &[Candidate],
    order: &[Preference],
    axes: &[Axis],
    previous: Option<&[f64]>,
    ideal: bool,
    admissible: &dyn Fn(&Candidate) -> bool,
) -> Option<usize> {
    let values = |index: usize| if ideal { candidates[index].ideal() } else { &candidates[index].joints[..] };
    (0..candidates.len()).filter(|&index| admissible(&candidates[index])).reduce(|best, index| {
        match compare(order, axes, previous, values(best), values(index)) {
            Ordering::Greater => index,
            _ => best,
        }
    })
}

/// `Less` when `a` is preferred. What the list leaves open, the least rotary travel decides.
fn compare(order: &[Preference], axes: &[Axis], previous: Option<&[f64]>, a: &[f64], b: &[f64]) -> Ordering {
    let by = |preference: Preference| {
        let difference = cost(preference, axes, previous, a) - cost(preference, axes, previous, b);
        if difference.abs() < TIE_DEG { Ordering::Equal } else { difference.total_cmp(&0.0) }
    };
    let listed = order.iter().map(|&preference| by(preference));
    listed.chain([by(Preference::Nearest)]).find(|ordering| ordering.is_ne()).unwrap_or(Ordering::Equal)
}

/// What a candidate costs by one preference.
fn cost(preference: Preference, axes: &[Axis], previous: Option<&[f64]>, joints: &[f64]) -> f64 {
    match preference {
        Preference::Least(axis) => joints[axis].abs(),
        Preference::Positive(axis) => f64::from(joints[axis] < -TIE_DEG),
        Preference::Negative(axis) => f64::from(joints[axis] > TIE_DEG),
        Preference::Nearest => match previous {
            Some(previous) => rotary_travel_deg(axes, previous, joints),
            None => rotary_travel_deg(axes, &vec![0.0; joints.len()], joints),
        },
    }
}
