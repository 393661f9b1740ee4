//! One of two machines on its way along a toolpath.

use crate::plan::Interpreter;
use mach_runtime::branch::Candidate;
use mach_runtime::certificate::Range;
use mach_runtime::compensation::Compensated;
use mach_runtime::coordinates::{AxisOffset, from_program_zero};
use mach_runtime::kinematics::{JointBlock, Kinematics, LANES, Miss, PoseBlock};
use mach_runtime::machine::Machine;
use mach_runtime::nc::axis_word::AxisWord;
use mach_runtime::path::{NoWay, PathSolver, Solved};
use mach_runtime::rig::Rig;
use mach_runtime::toolpath::Point;
use mach_runtime::vector::Vec3;

/// Why a machine does not go to a point.
#[derive(Debug, Clone, PartialEq)]
pub enum Refusal {
    /// It has no joints for it.
    Missed(Miss),
    /// This axis would be beyond its travel.
    Travel(String),
    /// The word of this axis has too few digits.
    Word(String),
}

/// A point that a machine goes to.
#[derive(Debug)]
pub(super) struct Reached {
    /// Which of the candidates.
    pub(super) index: usize,
    /// Every way there.
    pub(super) candidates: Vec<Candidate>,
    /// The words as they are printed: millimetres and degrees from the program zero, by axis.
    pub(super) words: Vec<f64>,
}

impl Reached {
    /// Where the axes are, before rounding: millimetres and degrees in machine coordinates.
    pub(super) fn joints(&self) -> &[f64] {
        &self.candidates[self.index].joints
    }
}

/// A machine on its way.
pub(super) struct Walker<'a> {
    pub(super) machine: &'a Machine,
    path: PathSolver<'a>,
    words: Vec<AxisWord>,
    /// A second one, for where printed words take the tool.
    forward: Compensated<'a, Interpreter>,
    joints: JointBlock,
    poses: PoseBlock,
    pub(super) ranges: Vec<Range>,
}

impl<'a> Walker<'a> {
    pub(super) fn new(rig: &'a Rig<Interpreter>, inverse: &'a mut Interpreter) -> Self {
        let Rig { machine, kinematics, dialect } = rig;
        let words = dialect.axes.iter().zip(&machine.axes);
        Self {
            machine,
            path: PathSolver::new(machine, inverse),
            words: words.map(|(word, axis)| AxisWord::new(word, axis, dialect.units)).collect(),
            forward: Compensated::new(kinematics.clone(), machine),
            joints: vec![[0.0; LANES]; machine.axes.len()],
            poses: PoseBlock::ZERO,
            ranges: machine.axes.iter().map(Range::new).collect(),
        }
    }

    /// The way to each point of a block.
    pub(super) fn go(&mut self, points: &[Point]) -> Vec<Result<Reached, Refusal>> {
        let Self { machine, path, words, ranges, .. } = self;
        let mut reached = Vec::with_capacity(points.len());
        path.solve(points, &mut |solved| {
            let one = reach(machine, words, solved);
            if let Ok(one) = &one {
                for (range, joint) in ranges.iter_mut().zip(one.joints()) {
                    range.visit(solved.point.line, *joint);
                }
            }
            reached.push(one);
        });
        reached
    }

    /// The tool stands here before the first motion.
    pub(super) fn stand_at(&mut self, point: &Point) {
        self.path.stand_at(point);
    }

    /// Where words (from the program zero, by axis) take the tool in the workpiece, lane by lane: tips in millimetres
    /// from the program zero, and unit axes. A lane without words is undefined.
    pub(super) fn poses(&mut self, words: &[Option<Vec<f64>>]) -> impl Fn(usize) -> (Vec3, Vec3) + use<'_, 'a> {
        let tool = self.machine.tool();
        for (lane, words) in words.iter().enumerate().filter_map(|(lane, words)| Some((lane, words.as_ref()?))) {
            for ((joint, axis), word) in self.joints.iter_mut().zip(&self.machine.axes).zip(words) {
                joint[lane] = AxisOffset::of(axis).joint(*word, tool.length_mm);
            }
        }
        self.forward.forward(&self.joints, tool, &mut self.poses);
        |lane| (from_program_zero(self.machine, self.poses.tip(lane)), self.poses.axis(lane))
    }
}

fn reach(machine: &Machine, words: &[AxisWord], solved: &Solved<'_>) -> Result<Reached, Refusal> {
    let named = |axis: usize| machine.axes[axis].name.clone();
    let index = solved.way().map_err(|no_way| match no_way {
        NoWay::Missed(miss) => Refusal::Missed(miss),
        NoWay::OutOfTravel(obstacle) => Refusal::Travel(named(obstacle.axis)),
    })?;
    let joints = &solved.candidates[index].joints;
    let printed = words.iter().zip(joints).enumerate().map(|(axis, (word, joint))| {
        let units = word.units(*joint, machine.tool().length_mm);
        units.map(|units| word.value(units)).ok_or_else(|| Refusal::Word(named(axis)))
    });
    Ok(Reached { index, candidates: solved.candidates.to_vec(), words: printed.collect::<Result<_, _>>()? })
}
