//! Where the axes may stand that the pose leaves open: samples of their travel, the nearest first.

use crate::machine::{Axis, Motion, Rule, Travel};

/// The distance of two samples, in millimetres or degrees, unless that makes too many of them.
const STEP: f64 = 1.0;

/// No more samples than this are tried for a point, all surplus axes together.
const MOST_SAMPLES: usize = 4096;

/// Values of the surplus axes, in the order of the machine's axes, in millimetres and degrees: from what is wanted
/// outwards, by the sum of the steps that they are away from it. `wanted` itself is not among them.
pub(crate) fn samples(axes: &[&Axis], wanted: &[f64]) -> Vec<Vec<f64>> {
    let most = most_of_one(axes.len());
    let of_each: Vec<Vec<(usize, f64)>> =
        axes.iter().zip(wanted).map(|(axis, &wanted)| of_one(axis, wanted, most)).collect();
    let none = vec![(0, Vec::new())];
    let mut all = of_each.iter().fold(none, |all: Vec<(usize, Vec<f64>)>, one| {
        let with = |(steps, values): &(usize, Vec<f64>)| -> Vec<(usize, Vec<f64>)> {
            one.iter().map(|&(more, value)| (steps + more, [&values[..], &[value]].concat())).collect()
        };
        all.iter().flat_map(with).collect()
    });
    // Stable: of two equally near the first axis' lesser motion, and of that the upward one, comes first.
    all.sort_by_key(|&(steps, _)| steps);
    all.into_iter().filter(|&(steps, _)| steps > 0).map(|(_, values)| values).collect()
}

/// How many samples each of so many axes may have.
fn most_of_one(axes: usize) -> usize {
    let total = |each: usize| (0..axes).try_fold(1_usize, |product, _| product.checked_mul(each));
    (1..=MOST_SAMPLES).rev().find(|&each| total(each).is_some_and(|total| total <= MOST_SAMPLES)).unwrap_or(1)
}

/// The samples of an axis with the steps they are away: what is wanted, then one step up and down, and so on. A rotary
/// axis without limits is tried half a turn either way, a linear one not at all.
fn of_one(axis: &Axis, wanted: f64, most: usize) -> Vec<(usize, f64)> {
    let Some(Travel { lower, upper }) = tried(axis, wanted) else { return vec![(0, wanted)] };
    let step = ((upper - lower) / most as f64).max(STEP);
    let count = |span: f64| (span / step).floor() as usize;
    let (up, down) = (count(upper - wanted), count(wanted - lower));
    let mut values = vec![(0, wanted)];
    for steps in 1..=up.max(down) {
        let apart = steps as f64 * step;
        values.extend((steps <= up).then_some((steps, wanted + apart)));
        values.extend((steps <= down).then_some((steps, wanted - apart)));
    }
    values
}

fn tried(axis: &Axis, wanted: f64) -> Option<Travel> {
    let Travel { lower, upper } = axis.travel;
    match axis.motion {
        _ if lower.is_finite() && upper.is_finite() => Some(axis.travel),
        Motion::Rotary => Some(Travel { lower: lower.max(wanted - 180.0), upper: upper.min(wanted + 180.0) }),
        Motion::Linear => None,
    }
}

/// Where a surplus axis is wanted, given where it is.
pub(crate) fn wanted(rule: Rule, at_rest: f64) -> f64 {
    match rule {
        Rule::Preferred(value) => value,
        _ => at_rest,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Written;

    fn axis(motion: Motion, lower: f64, upper: f64) -> Axis {
        Axis {
            name: "W".into(),
            motion,
            travel: Travel { lower, upper },
            rule: Rule::Free,
            written: Written::Unwound,
            zero: 0.0,
            length_share: 0.0,
            rapid_per_min: None,
        }
    }

    #[test]
    fn samples_go_outwards_and_stay_within_the_travel() {
        let quill = axis(Motion::Linear, -2.5, 1.0);
        assert_eq!(samples(&[&quill], &[0.0]), [[1.0], [-1.0], [-2.0]]);
        let endless = axis(Motion::Rotary, f64::NEG_INFINITY, f64::INFINITY);
        let all = samples(&[&endless], &[90.0]);
        assert_eq!((all.len(), &all[358..]), (360, &[vec![270.0], vec![-90.0]][..]));
        assert!(samples(&[&axis(Motion::Linear, 0.0, f64::INFINITY)], &[0.0]).is_empty());
    }

    #[test]
    fn several_axes_share_the_number_of_samples() {
        let (quill, head) = (axis(Motion::Linear, 0.0, 640.0), axis(Motion::Rotary, -90.0, 90.0));
        let all = samples(&[&quill, &head], &[0.0, 0.0]);
        assert_eq!(&all[..3], [[0.0, 2.8125], [0.0, -2.8125], [10.0, 0.0]].map(Vec::from).as_slice());
        assert!(all.len() <= 2 * MOST_SAMPLES, "{}", all.len());
    }
}
