//! The words of two machines, paired by the axes' names.

use mach_runtime::certificate::Extreme;
use mach_runtime::machine::{Axis, Motion};

/// Printed values that differ by less than this, in millimetres or degrees, are equal: a value in inches may be.
const SAME: f64 = 1e-9;

/// How the words of one axis differ.
#[derive(Debug, Clone, PartialEq)]
pub struct WordChange {
    /// The axis.
    pub name: String,
    /// How it moves.
    pub motion: Motion,
    /// Points at which the words differ.
    pub points: u64,
    /// The largest difference, in millimetres or degrees.
    pub largest: Extreme,
    /// The old word there: millimetres or degrees from the program zero.
    pub old: f64,
    /// The new word there.
    pub new: f64,
}

/// Which axis of one machine is which of the other.
pub(super) struct Correspondence {
    /// Indices of axes that both machines have, moving in the same way.
    pub(super) pairs: Vec<(usize, usize)>,
    /// How many axes the new machine has.
    new_axes: usize,
}

impl Correspondence {
    pub(super) fn of(old: &[Axis], new: &[Axis]) -> Self {
        let same = |a: &Axis, b: &Axis| (&a.name, a.motion) == (&b.name, b.motion);
        let partner = |(index, axis)| Some((index, new.iter().position(|other| same(axis, other))?));
        Self { pairs: old.iter().enumerate().filter_map(partner).collect(), new_axes: new.len() }
    }

    /// No changes yet.
    pub(super) fn words(&self, old: &[Axis]) -> Vec<WordChange> {
        let unchanged = |&(index, _): &(usize, usize)| WordChange {
            name: old[index].name.clone(),
            motion: old[index].motion,
            points: 0,
            largest: Extreme::default(),
            old: 0.0,
            new: 0.0,
        };
        self.pairs.iter().map(unchanged).collect()
    }

    pub(super) fn only_old(&self, old: &[Axis]) -> Vec<String> {
        let alone = |(index, _): &(usize, &Axis)| !self.pairs.iter().any(|(a, _)| a == index);
        old.iter().enumerate().filter(alone).map(|(_, axis)| axis.name.clone()).collect()
    }

    pub(super) fn only_new(&self, new: &[Axis]) -> Vec<String> {
        let alone = |(index, _): &(usize, &Axis)| !self.pairs.iter().any(|(_, b)| b == index);
        new.iter().enumerate().filter(alone).map(|(_, axis)| axis.name.clone()).collect()
    }

    /// Whether the new machine has no axis that the old one has not.
    pub(super) fn covers_new(&self) -> bool {
        self.pairs.len() == self.new_axes
    }

    /// The pairs of rotary axes.
    pub(super) fn rotaries(&self, old: &[Axis]) -> Vec<(usize, usize)> {
        self.pairs.iter().copied().filter(|&(index, _)| old[index].motion == Motion::Rotary).collect()
    }

    /// Whether both machines have the same rotary axes.
    pub(super) fn same_rotaries(&self, old: &[Axis], new: &[Axis]) -> bool {
        let count = |axes: &[Axis]| axes.iter().filter(|axis| axis.motion == Motion::Rotary).count();
        let paired = self.rotaries(old).len();
        count(old) == paired && count(new) == paired
    }

    /// Notes how the words at a point differ, and says whether they do.
    pub(super) fn compare(&self, line: u64, old: &[f64], new: &[f64], changes: &mut [WordChange]) -> bool {
        let mut differ = false;
        for (change, &(a, b)) in changes.iter_mut().zip(&self.pairs) {
            let by = (new[b] - old[a]).abs();
            if by > SAME {
                differ = true;
                change.points += 1;
                if by > change.largest.value {
                    (change.largest, change.old, change.new) = (Extreme { value: by, line }, old[a], new[b]);
                }
            }
        }
        differ
    }

    /// The old machine's words in the new machine's order, when that has no other axes.
    pub(super) fn carried(&self, old: &[f64]) -> Vec<f64> {
        let mut words = vec![0.0; self.new_axes];
        for &(a, b) in &self.pairs {
            words[b] = old[a];
        }
        words
    }
}
