//! From candidates to one joint path: whole turns within the travel, a start rule, then the nearest.

mod candidate;
mod preference;

pub use candidate::{Candidate, Obstacle};

use crate::kinematics::{Kinematics, SolutionBlock};
use crate::machine::{Machine, Motion};
use crate::vector::Vec3;

/// Below this sine of the angle to the pole the first rotary is free: a few hundred roundings of a unit vector, so that
/// the axis is exact to 1e-12 rad whatever the free axis does.
const POLE_SINE: f64 = 1e-13;

/// What was chosen at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Choice {
    /// This candidate.
    Candidate {
        /// Its index.
        index: usize,
        /// Whether the travel kept the machine from a candidate that the policy prefers.
        forced: bool,
    },
    /// The direction is this far (in radians) from any that the machine can reach.
    OutOfReach(f64),
    /// Every candidate is beyond the travel; this is the one that is least so.
    OutOfTravel(usize),
    /// The linear axes do not span space there.
    Singular,
}

/// Chooses along a path.
#[derive(Debug)]
pub struct Chooser<'m> {
    machine: &'m Machine,
    /// The joints of the last point that could be reached.
    previous: Option<Vec<f64>>,
    candidates: Vec<Candidate>,
}

impl<'m> Chooser<'m> {
    /// A chooser at the start of a program.
    pub fn new(machine: &'m Machine, branches: usize) -> Self {
        let candidates = vec![Candidate::new(machine.axes.len()); branches];
        Self { machine, previous: None, candidates }
    }

    /// The candidates of the last point, in the order of the plan's branches.
    pub fn candidates(&self) -> &[Candidate] {
        &self.candidates
    }

    /// The joints of the last point that could be reached.
    pub fn position(&self) -> Option<&[f64]> {
        self.previous.as_deref()
    }

    /// Chooses among the candidates of one lane, and goes there.
    pub fn choose(
        &mut self,
        solutions: &SolutionBlock,
        lane: usize,
        tip_mm: Vec3,
        kinematics: &mut dyn Kinematics,
    ) -> Choice {
        if -solutions.reach_rad[lane] > self.machine.axis_tolerance_rad {
            return Choice::OutOfReach(-solutions.reach_rad[lane]);
        }
        self.fill(solutions, lane);
        if solutions.pole_sine[lane] < POLE_SINE {
            self.free_at_pole(tip_mm, kinematics);
        }
        let choice = self.pick();
        if let Choice::Candidate { index, .. } = choice {
            let joints = &self.candidates[index].joints;
            match &mut self.previous {
                Some(previous) => previous.copy_from_slice(joints),
                None => self.previous = Some(joints.clone()),
            }
        }
        choice
    }

    /// The lane's candidates, each with the whole turns that come nearest to the previous point within the travel.
    fn fill(&mut self, solutions: &SolutionBlock, lane: usize) {
        let previous = self.previous.as_deref();
        for (candidate, branch) in self.candidates.iter_mut().zip(&solutions.branches) {
            for (axis, joint) in branch.iter().enumerate() {
                candidate.joints[axis] = joint[lane];
            }
            candidate.settle(&self.machine.axes, previous);
        }
    }

    /// At the pole the free axis stays where it is, and the linear axes follow.
    fn free_at_pole(&mut self, tip_mm: Vec3, kinematics: &mut dyn Kinematics) {
        let Some(free) = kinematics.free_axis() else { return };
        let travel = self.machine.axes[free].travel;
        let stay = self.previous.as_ref().map_or(0.0_f64.clamp(travel.lower, travel.upper), |previous| previous[free]);
        for candidate in &mut self.candidates {
            candidate.joints[free] = stay;
            kinematics.position(tip_mm, self.machine.tool_length_mm, &mut candidate.joints);
            candidate.settle(&self.machine.axes, self.previous.as_deref());
        }
    }

    fn pick(&self) -> Choice {
        if self.candidates.iter().any(|candidate| candidate.joints.iter().any(|joint| !joint.is_finite())) {
            return Choice::Singular;
        }
        let order = if self.previous.is_some() { &self.machine.branch.then } else { &self.machine.branch.start };
        let previous = self.previous.as_deref();
        let axes = &self.machine.axes;
        let best = |admissible: &dyn Fn(&Candidate) -> bool, ideal: bool| {
            preference::best(&self.candidates, order, axes, previous, ideal, admissible)
        };
        match best(&|candidate| candidate.obstacle.is_none(), false) {
            Some(index) => {
                let limited = self.candidates.iter().any(|candidate| candidate.is_limited());
                let forced =
                    limited && (best(&|_| true, true) != Some(index) || self.candidates[index].is_turned(axes));
                Choice::Candidate { index, forced }
            }
            None => Choice::OutOfTravel(self.least_beyond()),
        }
    }

    /// The candidate that is least beyond the travel.
    fn least_beyond(&self) -> usize {
        let beyond = |index: &usize| self.candidates[*index].obstacle.map_or(0.0, |obstacle| obstacle.beyond);
        (0..self.candidates.len()).min_by(|a, b| beyond(a).total_cmp(&beyond(b))).expect("every plan has a branch")
    }
}

/// The travel of the rotary axes from one position to another, in degrees, summed.
pub(crate) fn rotary_travel_deg(axes: &[crate::machine::Axis], from: &[f64], to: &[f64]) -> f64 {
    let rotary = |index: &usize| axes[*index].motion == Motion::Rotary;
    (0..axes.len()).filter(rotary).map(|index| (to[index] - from[index]).abs()).fold(0.0, |sum, step| sum + step)
}
