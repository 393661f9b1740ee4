//! From candidates to one joint path: whole turns within the travel, a start rule, then the nearest.

mod candidate;
mod preference;
mod solutions;
pub(crate) mod surplus;

pub use candidate::{Candidate, Obstacle};
pub use solutions::Solutions;

use crate::kinematics::{Kinematics, Miss, Outcome};
use crate::machine::{Machine, Preference};
use crate::vector::Vec3;
use candidate::Rules;
use std::ops::Range;

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
    /// There is none.
    Missed(Miss),
    /// Every candidate is beyond the travel; this is the one that is least so.
    OutOfTravel(usize),
}

/// Chooses along a path.
#[derive(Debug)]
pub struct Chooser<'m> {
    machine: &'m Machine,
    rules: Rules<'m>,
    /// The preferences at the first point of a program, and at every further one.
    start: Vec<Preference>,
    then: Vec<Preference>,
    /// The joints of the last point that could be reached; zeros before the first.
    previous: Vec<f64>,
    has_position: bool,
    candidates: Vec<Candidate>,
    /// Whether the travel makes no difference to any of them.
    is_unlimited: bool,
}

impl<'m> Chooser<'m> {
    /// A chooser at the start of a program.
    pub fn new(machine: &'m Machine, kinematics: &dyn Kinematics) -> Self {
        let axes = machine.axes.len();
        Self {
            machine,
            rules: Rules::of(&machine.axes),
            start: preference::complete(&machine.branch.start),
            then: preference::complete(&machine.branch.then),
            previous: vec![0.0; axes],
            has_position: false,
            candidates: vec![Candidate::new(axes); kinematics.branch_count()],
            is_unlimited: false,
        }
    }

    /// The candidates of the last point, in the order of the plan's branches; about the closest that the machine can do
    /// where the point was out of reach.
    pub fn candidates(&self) -> &[Candidate] {
        &self.candidates
    }

    /// Whether a position has been reached yet.
    pub fn has_position(&self) -> bool {
        self.has_position
    }

    /// Where an axis is, in millimetres or degrees: at the start as near to zero as it can.
    pub fn at_rest(&self, axis: usize) -> f64 {
        let travel = self.machine.axes[axis].travel;
        if self.has_position { self.previous[axis] } else { 0.0_f64.clamp(travel.lower, travel.upper) }
    }

    /// Chooses among the candidates of one lane, and goes there. At the pole the free axis goes where the first of the
    /// lanes `ahead` that is off the pole wants it; it stays where none is, so that an empty range keeps it still.
    pub fn choose(
        &mut self,
        solutions: &Solutions,
        lane: usize,
        ahead: Range<usize>,
        tip_mm: Vec3,
        kinematics: &mut dyn Kinematics,
    ) -> Choice {
        let outcome = match solutions.outcomes()[lane] {
            Outcome::Reached => {
                self.fill(solutions, lane);
                Ok(())
            }
            Outcome::FreeAtPole { axis } => {
                let value = self.wanted_ahead(solutions, ahead, axis).unwrap_or_else(|| self.at_rest(axis));
                self.fill(solutions, lane);
                self.free_at_pole(axis, value, tip_mm, kinematics)
            }
            Outcome::Missed(miss) => {
                self.fill(solutions, lane);
                Err(miss)
            }
        };
        let choice = outcome.map_or_else(Choice::Missed, |()| self.pick());
        if let Choice::Candidate { index, .. } = choice {
            self.previous.copy_from_slice(&self.candidates[index].joints);
            self.has_position = true;
        }
        choice
    }

    /// The lane's candidates, each with the whole turns that come nearest to the previous point within the travel.
    fn fill(&mut self, solutions: &Solutions, lane: usize) {
        self.is_unlimited = true;
        for (candidate, (joints, beyond)) in self.candidates.iter_mut().zip(solutions.branches()) {
            candidate.load(joints, lane);
            if beyond[lane] != 0 || !candidate.settle_freely(&self.rules, &self.previous) {
                self.is_unlimited = false;
                candidate.load(joints, lane);
                candidate.settle_within_travel(&self.rules, &self.previous);
            }
        }
    }

    /// Where the first lane off the pole wants the axis that is free until then.
    fn wanted_ahead(&mut self, solutions: &Solutions, mut ahead: Range<usize>, free: usize) -> Option<f64> {
        let outcomes = solutions.outcomes();
        let lane = ahead.find(|&lane| !matches!(outcomes[lane], Outcome::FreeAtPole { .. }))?;
        if outcomes[lane] != Outcome::Reached {
            return None;
        }
        self.fill(solutions, lane);
        match self.pick() {
            Choice::Candidate { index, .. } => Some(self.candidates[index].joints[free]),
            _ => None,
        }
    }

    /// Puts the axis that is free at the pole to a value; the linear axes follow.
    fn free_at_pole(
        &mut self,
        free: usize,
        value: f64,
        tip_mm: Vec3,
        kinematics: &mut dyn Kinematics,
    ) -> Result<(), Miss> {
        self.is_unlimited = false;
        let mut outcome = Ok(());
        for candidate in &mut self.candidates {
            candidate.joints[free] = value;
            outcome = outcome.and(kinematics.position(tip_mm, self.machine.tool(), &mut candidate.joints));
            candidate.settle_within_travel(&self.rules, &self.previous);
        }
        outcome
    }

    fn pick(&self) -> Choice {
        let candidates = &self.candidates;
        let order = if self.has_position { &self.then } else { &self.start };
        if self.is_unlimited {
            return Choice::Candidate { index: preference::ideal(candidates, order), forced: false };
        }
        let Some(index) = preference::best(candidates, order) else {
            return Choice::OutOfTravel(self.least_beyond());
        };
        let limited = candidates.iter().any(|candidate| candidate.obstacle.is_some() || candidate.is_turned());
        let forced = limited && (candidates[index].is_turned() || preference::ideal(candidates, order) != index);
        Choice::Candidate { index, forced }
    }

    /// The candidate that is least beyond the travel.
    fn least_beyond(&self) -> usize {
        let beyond = |index: &usize| self.candidates[*index].obstacle.map_or(0.0, |obstacle| obstacle.beyond);
        (0..self.candidates.len()).min_by(|a, b| beyond(a).total_cmp(&beyond(b))).expect("every plan has a branch")
    }
}
