//! Points to joints, block by block: the kinematics gives every candidate, the choice goes through them in order.

use crate::branch::{Candidate, Choice, Chooser};
use crate::cl::event::{Approach, Point};
use crate::compensation::Compensated;
use crate::kinematics::{Kinematics, LANES, PoseBlock, SolutionBlock};
use crate::machine::Machine;
use crate::vector::add;

/// Solves a path of any length, with the machine's errors compensated. The points of a block are solved together: where the first rotary is free and the tool
/// not in a cut, it looks ahead to the end of the block, so that it stands right when the cut begins to tilt.
pub struct PathSolver<'a> {
    machine: &'a Machine,
    kinematics: Compensated<'a, &'a mut (dyn Kinematics + Send)>,
    /// The poses of the last block, in the machine frame; lanes beyond its points repeat its last point.
    poses: PoseBlock,
    solutions: SolutionBlock,
    chooser: Chooser<'a>,
}

/// One solved point.
#[derive(Debug)]
pub struct Solved<'s> {
    /// The point.
    pub point: &'s Point,
    /// Its lane in the block.
    pub lane: usize,
    /// What was chosen.
    pub choice: Choice,
    /// What there was to choose from.
    pub candidates: &'s [Candidate],
    /// Whether there is no position before it.
    pub is_first: bool,
}

impl Solved<'_> {
    /// The chosen candidate, if one could be chosen.
    pub fn chosen(&self) -> Option<&Candidate> {
        match self.choice {
            Choice::Candidate { index, .. } => Some(&self.candidates[index]),
            _ => None,
        }
    }
}

impl<'a> PathSolver<'a> {
    /// A solver at the start of a program.
    pub fn new(machine: &'a Machine, kinematics: &'a mut (dyn Kinematics + Send)) -> Self {
        let (branches, axes) = (kinematics.branch_count(), kinematics.axis_count());
        assert_eq!(axes, machine.axes.len(), "tables and kinematics are of one machine");
        Self {
            machine,
            kinematics: Compensated::new(kinematics, machine),
            poses: PoseBlock::ZERO,
            solutions: SolutionBlock::new(branches, axes),
            chooser: Chooser::new(machine, branches),
        }
    }

    /// Solves up to [`LANES`] points, and hands each to `each`, in order.
    pub fn solve(&mut self, points: &[Point], each: &mut dyn FnMut(&Solved<'_>)) {
        let Some(last) = points.last() else { return };
        assert!(points.len() <= LANES, "a block holds {LANES} points");
        for lane in 0..LANES {
            let point = points.get(lane).unwrap_or(last);
            self.poses.set(lane, add(point.tip_mm, self.machine.zero_mm), point.axis);
        }
        self.kinematics.inverse(&self.poses, &[], self.machine.tool_length_mm, &mut self.solutions);
        for (lane, point) in points.iter().enumerate() {
            let is_first = !self.chooser.has_position();
            let in_cut = !is_first && matches!(point.approach, Approach::Feed(_));
            let ahead = if in_cut { 0..0 } else { lane + 1..points.len() };
            let choice = self.chooser.choose(&self.solutions, lane, ahead, self.poses.tip(lane), &mut self.kinematics);
            each(&Solved { point, lane, choice, candidates: self.chooser.candidates(), is_first });
        }
    }
}
