//! Points to joints, block by block: the kinematics gives every candidate, the choice goes through them in order.

use crate::branch::{Candidate, Choice, Chooser, Obstacle, Solutions, surplus};
use crate::compensation::Compensated;
use crate::coordinates::in_machine_frame;
use crate::kinematics::{Kinematics, LANES, Lane, Miss, PoseBlock};
use crate::machine::Machine;
use crate::toolpath::{Approach, Point};
use std::ops::Range;

/// How far a surplus axis may be from where it was and still stand there, in millimetres or degrees: rounding is no jump.
const AT_REST: f64 = 1e-9;

/// Solves a path of any length, with the machine's errors compensated. The points of a block are solved together: where
/// the first rotary is free and the tool not in a cut, it looks ahead to the end of the block, so that it stands right
/// when the cut begins to tilt.
pub struct PathSolver<'a> {
    machine: &'a Machine,
    kinematics: Compensated<'a, &'a mut (dyn Kinematics + Send)>,
    /// The poses of the last block, in the machine frame; lanes beyond its points repeat its last point.
    poses: PoseBlock,
    solutions: Solutions,
    surplus: Surplus,
    chooser: Chooser<'a>,
}

/// The axes that the pose leaves open.
struct Surplus {
    axes: Vec<usize>,
    /// The values that the block was solved for.
    values: Vec<f64>,
    lanes: Vec<Lane>,
    /// One pose with other values, a sample a lane.
    poses: PoseBlock,
    solutions: Solutions,
}

/// One solved point.
#[derive(Debug)]
pub struct Solved<'s> {
    /// The point.
    pub point: &'s Point,
    /// Its lane in the block.
    pub lane: usize,
    /// What was chosen.
    choice: Choice,
    /// What there was to choose from.
    pub candidates: &'s [Candidate],
    /// Whether there is no position before it.
    pub is_first: bool,
    /// The first surplus axis that does not stay where it was, if one does not.
    pub jump: Option<Jump>,
}

/// A surplus axis goes somewhere else; in millimetres or degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jump {
    /// Its index.
    pub axis: usize,
    /// Where it was.
    pub from: f64,
    /// Where it is now.
    pub to: f64,
}

/// Why a machine does not go to a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NoWay {
    /// It has no joints for it.
    Missed(Miss),
    /// All joints that it has are beyond its travel; those that are least so by this.
    OutOfTravel(Obstacle),
}

impl Solved<'_> {
    /// The index of the chosen candidate.
    ///
    /// # Errors
    /// Why none could be chosen.
    pub fn way(&self) -> Result<usize, NoWay> {
        match self.choice {
            Choice::Candidate { index, .. } => Ok(index),
            Choice::Missed(miss) => Err(NoWay::Missed(miss)),
            Choice::OutOfTravel(index) => {
                let obstacle = self.candidates[index].obstacle;
                Err(NoWay::OutOfTravel(obstacle.expect("a candidate out of travel says which axis is")))
            }
        }
    }

    /// The chosen candidate, if one could be chosen.
    pub fn chosen(&self) -> Option<&Candidate> {
        self.way().ok().map(|index| &self.candidates[index])
    }

    /// Whether the travel kept the machine from a candidate that the policy prefers.
    pub fn is_forced(&self) -> bool {
        matches!(self.choice, Choice::Candidate { forced: true, .. })
    }
}

impl<'a> PathSolver<'a> {
    /// A solver at the start of a program.
    pub fn new(machine: &'a Machine, kinematics: &'a mut (dyn Kinematics + Send)) -> Self {
        assert_eq!(kinematics.axis_count(), machine.axes.len(), "tables and kinematics are of one machine");
        Self {
            machine,
            poses: PoseBlock::ZERO,
            solutions: Solutions::new(kinematics),
            surplus: Surplus::new(kinematics),
            chooser: Chooser::new(machine, kinematics),
            kinematics: Compensated::new(kinematics, machine),
        }
    }

    /// Solves up to [`LANES`] points, and hands each to `each`, in order.
    pub fn solve(&mut self, points: &[Point], each: &mut dyn FnMut(&Solved<'_>)) {
        let Some(last) = points.last() else { return };
        assert!(points.len() <= LANES, "a block holds {LANES} points");
        for lane in 0..LANES {
            let point = points.get(lane).unwrap_or(last);
            self.poses.set(lane, in_machine_frame(self.machine, point.tip_mm), point.axis);
        }
        self.surplus.set(self.wanted());
        self.invert();
        for (lane, point) in points.iter().enumerate() {
            let is_first = !self.chooser.has_position();
            let in_cut = !is_first && matches!(point.approach, Approach::Feed(_));
            let ahead = if in_cut { 0..0 } else { lane + 1..points.len() };
            let (choice, jump) = self.choose(lane, ahead);
            each(&Solved { point, lane, choice, candidates: self.chooser.candidates(), is_first, jump });
        }
    }

    /// The machine stands at a point before its next motion.
    pub fn stand_at(&mut self, point: &Point) {
        self.solve(std::slice::from_ref(point), &mut |_| {});
    }

    fn invert(&mut self) {
        let Self { machine, kinematics, poses, solutions, surplus, .. } = self;
        solutions.solve(poses, &surplus.lanes, machine, kinematics);
    }

    /// Chooses at a point, and says which of the surplus axes jumps there.
    fn choose(&mut self, lane: usize, ahead: Range<usize>) -> (Choice, Option<Jump>) {
        if self.surplus.axes.is_empty() {
            let tip_mm = self.poses.tip(lane);
            return (self.chooser.choose(&self.solutions, lane, ahead, tip_mm, &mut self.kinematics), None);
        }
        let (is_first, before) = (!self.chooser.has_position(), self.at_rest());
        let choice = self.choose_with_surplus(lane, ahead);
        (choice, if is_first { None } else { self.jump(&before) })
    }

    /// Chooses with the surplus axes where they are wanted, else with the nearest samples that have a way.
    fn choose_with_surplus(&mut self, lane: usize, ahead: Range<usize>) -> Choice {
        let wanted = self.wanted();
        if self.surplus.values != wanted {
            self.surplus.set(wanted);
            self.invert();
        }
        let tip_mm = self.poses.tip(lane);
        let choice = self.chooser.choose(&self.solutions, lane, ahead, tip_mm, &mut self.kinematics);
        if matches!(choice, Choice::Candidate { .. }) {
            return choice;
        }
        // Without a way at all, what is told is told of the wanted values.
        self.search(lane)
            .unwrap_or_else(|| self.chooser.choose(&self.solutions, lane, 0..0, tip_mm, &mut self.kinematics))
    }

    /// The first of the samples with which the machine has a way to the lane's pose.
    fn search(&mut self, lane: usize) -> Option<Choice> {
        let Self { machine, kinematics, poses, surplus, chooser, .. } = self;
        let tip_mm = poses.tip(lane);
        (0..LANES).for_each(|trial| surplus.poses.set(trial, tip_mm, poses.axis(lane)));
        let axes: Vec<_> = surplus.axes.iter().map(|&axis| &machine.axes[axis]).collect();
        let samples = surplus::samples(&axes, &surplus.values);
        for block in samples.chunks(LANES) {
            let lanes = |axis| std::array::from_fn(|trial| block[trial.min(block.len() - 1)][axis]);
            let lanes: Vec<Lane> = (0..axes.len()).map(lanes).collect();
            surplus.solutions.solve(&surplus.poses, &lanes, machine, kinematics);
            let mut choices =
                (0..block.len()).map(|trial| chooser.choose(&surplus.solutions, trial, 0..0, tip_mm, kinematics));
            if let Some(choice) = choices.find(|choice| matches!(choice, Choice::Candidate { .. })) {
                return Some(choice);
            }
        }
        None
    }

    /// Where the surplus axes are.
    fn at_rest(&self) -> Vec<f64> {
        self.surplus.axes.iter().map(|&axis| self.chooser.at_rest(axis)).collect()
    }

    /// Where they are wanted.
    fn wanted(&self) -> Vec<f64> {
        let wanted = |&axis: &usize| surplus::wanted(self.machine.axes[axis].rule, self.chooser.at_rest(axis));
        self.surplus.axes.iter().map(wanted).collect()
    }

    fn jump(&self, before: &[f64]) -> Option<Jump> {
        let jumps = self.surplus.axes.iter().zip(before);
        jumps
            .map(|(&axis, &from)| Jump { axis, from, to: self.chooser.at_rest(axis) })
            .find(|jump| (jump.to - jump.from).abs() > AT_REST)
    }
}

impl Surplus {
    fn new(kinematics: &dyn Kinematics) -> Self {
        let axes = kinematics.surplus_axes().to_vec();
        Self {
            values: vec![0.0; axes.len()],
            lanes: vec![[0.0; LANES]; axes.len()],
            axes,
            poses: PoseBlock::ZERO,
            solutions: Solutions::new(kinematics),
        }
    }

    fn set(&mut self, values: Vec<f64>) {
        self.lanes.iter_mut().zip(&values).for_each(|(lane, &value)| *lane = [value; LANES]);
        self.values = values;
    }
}
