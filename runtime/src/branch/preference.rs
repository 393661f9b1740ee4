//! The machine's preferences, compared in order.

use super::candidate::Candidate;
use crate::machine::Preference;
use std::cmp::Ordering;

/// Angles that differ by less than this, in degrees, are equal to a preference: rounding must not decide.
const TIE_DEG: f64 = 1e-9;

/// The index of the best of the admissible candidates, where one is.
pub(super) fn best(candidates: &[Candidate], order: &[Preference]) -> Option<usize> {
    let admissible = (0..candidates.len()).filter(|&index| candidates[index].obstacle.is_none());
    first_choice(admissible, order, |index, preference| {
        cost(preference, &candidates[index], candidates[index].rotary_travel_deg)
    })
}

/// The index of the best candidate if there were no limits of the travel.
pub(super) fn ideal(candidates: &[Candidate], order: &[Preference]) -> Option<usize> {
    first_choice(0..candidates.len(), order, |index, preference| {
        cost(preference, &candidates[index], candidates[index].ideal_travel_deg())
    })
}

fn first_choice(
    mut indices: impl Iterator<Item = usize>,
    order: &[Preference],
    cost: impl Fn(usize, Preference) -> f64,
) -> Option<usize> {
    let first = indices.next()?;
    Some(indices.fold(first, |best, index| match compare(order, |by| cost(best, by) - cost(index, by)) {
        Ordering::Greater => index,
        _ => best,
    }))
}

/// By the first preference that sees a difference. What the list leaves open, the least rotary travel decides.
fn compare(order: &[Preference], difference: impl Fn(Preference) -> f64) -> Ordering {
    for &preference in order.iter().chain(&[Preference::Nearest]) {
        let difference = difference(preference);
        if difference.abs() >= TIE_DEG {
            return difference.total_cmp(&0.0);
        }
    }
    Ordering::Equal
}

/// What a candidate costs by one preference.
fn cost(preference: Preference, candidate: &Candidate, travel_deg: f64) -> f64 {
    let joints = &candidate.joints;
    match preference {
        Preference::Least(axis) => joints[axis].abs(),
        Preference::Positive(axis) => f64::from(joints[axis] < -TIE_DEG),
        Preference::Negative(axis) => f64::from(joints[axis] > TIE_DEG),
        Preference::Nearest => travel_deg,
    }
}
