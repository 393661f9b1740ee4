//! The solutions of a block of poses, and what can be said of all of them at once.

use super::candidate::takes_turns;
use crate::kinematics::{Kinematics, LANES, Lane, Outcome, PoseBlock, SolutionBlock, Tolerances};
use crate::machine::Machine;

/// Every candidate for each pose of a block.
#[derive(Debug, Clone)]
pub struct Solutions {
    block: SolutionBlock,
    outcomes: [Outcome; LANES],
    /// For each candidate of each lane, how many of the axes that take no whole turns are not within their travel.
    beyond: Vec<[u64; LANES]>,
}

impl Solutions {
    /// Room for a block of this machine.
    pub fn new(kinematics: &dyn Kinematics) -> Self {
        let (block, beyond) = (SolutionBlock::of(kinematics), vec![[0; LANES]; kinematics.branch_count()]);
        Self { block, outcomes: [Outcome::Reached; LANES], beyond }
    }

    /// Solves for each pose, with these values of the surplus axes.
    pub fn solve(&mut self, poses: &PoseBlock, surplus: &[Lane], machine: &Machine, kinematics: &mut dyn Kinematics) {
        kinematics.inverse(poses, surplus, machine.tool(), &mut self.block);
        let tolerances = Tolerances { axis_rad: machine.axis_tolerance_rad, plane_mm: machine.plane_tolerance_mm };
        self.outcomes = self.block.outcomes(tolerances);
        for (beyond, branch) in self.beyond.iter_mut().zip(&self.block.branches) {
            *beyond = [0; LANES];
            for (axis, joints) in machine.axes.iter().zip(branch).filter(|(axis, _)| !takes_turns(axis)) {
                let travel = axis.travel.numbers();
                for lane in 0..LANES {
                    beyond[lane] += u64::from(!travel.contains(joints[lane]));
                }
            }
        }
    }

    /// What came of each pose.
    pub(super) fn outcomes(&self) -> &[Outcome; LANES] {
        &self.outcomes
    }

    /// For each candidate its joints, and how many of those that take no whole turns are not within their travel: by lanes.
    pub(super) fn branches(&self) -> impl Iterator<Item = (&[Lane], &[u64; LANES])> {
        self.block.branches.iter().map(Vec::as_slice).zip(&self.beyond)
    }
}
