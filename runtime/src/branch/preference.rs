//! The machine's preferences, compared in order.

use super::candidate::{Candidate, TIE_DEG};
use crate::machine::Preference;

/// The list with what decides where it leaves a choice open: the least rotary travel.
pub(super) fn complete(order: &[Preference]) -> Vec<Preference> {
    let is_last = order.last() == Some(&Preference::Nearest);
    order.iter().copied().chain((!is_last).then_some(Preference::Nearest)).collect()
}

/// The index of the best of the admissible candidates, where one is.
pub(super) fn best(candidates: &[Candidate], order: &[Preference]) -> Option<usize> {
    let mut admissible = (0..candidates.len()).filter(|&index| candidates[index].obstacle.is_none());
    let first = admissible.next()?;
    let travel_deg = |candidate: &Candidate| candidate.rotary_travel_deg;
    Some(admissible.fold(first, |best, index| better(candidates, best, index, order, travel_deg)))
}

/// The index of the best candidate if there were no limits of the travel.
#[inline]
pub(super) fn ideal(candidates: &[Candidate], order: &[Preference]) -> usize {
    (1..candidates.len()).fold(0, |best, index| better(candidates, best, index, order, Candidate::ideal_travel_deg))
}

/// Which of two, by the first preference that sees a difference; the first of the two if none does.
#[inline]
fn better(
    candidates: &[Candidate],
    best: usize,
    index: usize,
    order: &[Preference],
    travel_deg: impl Fn(&Candidate) -> f64,
) -> usize {
    let cost = |by, index: usize| cost(by, &candidates[index], travel_deg(&candidates[index]));
    for &by in order {
        let saved = cost(by, best) - cost(by, index);
        if saved.abs() >= TIE_DEG {
            return if saved > 0.0 { index } else { best };
        }
    }
    best
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
