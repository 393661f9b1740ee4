//! What is between the points: how far the tip leaves its lines, and what is told of a program in which it does.

use super::job::Job;
use super::stretch::{PrintedPoint, Stretch};
use crate::certificate::{Between, Way};
use crate::coordinates::in_machine_frame;
use crate::diagnostic::{Code, Diagnostic, Place};
use crate::kinematics::{JointBlock, Kinematics, LANES, Lane, PoseBlock};
use crate::machine::Machine;
use crate::segment::Segments;
use crate::toolpath::{Approach, Point};
use crate::vector::Vec3;
use crate::verify::pose::Solver;

/// W1110.
pub static OFF_THE_LINE: Code = Code {
    id: "W1110",
    title: "between points the tip leaves its line",
    explanation: "\
The program gives axis values at the points of the CL, and between them the control moves every axis evenly. Where a rotary
axis turns, the tip then goes on a curve, not on the straight line from point to point; near a pole, or where the machine
changes to its other solution, far from it. The certificate states how far at most, as a bound that is proved and not
sampled; this warning counts the blocks of cuts in which it may be more than the machine's chord tolerance.

No points are put in. Ask the CAM system for shorter steps where the tool turns, or, if that much does no harm, say so:

    tolerance chord 0.05 mm",
};

/// A warning, if blocks of cuts are off their lines by more than the tolerance.
pub(super) fn warning(job: Job<'_>, between: &Between) -> Option<Diagnostic> {
    let tolerance_mm = job.machine.chord_tolerance_mm;
    let message = match between.beyond_tolerance {
        0 => return None,
        1 => format!("in one block of a cut the tip may leave its line by more than {tolerance_mm} mm"),
        blocks => format!("in {blocks} blocks of cuts the tip may leave its line by more than {tolerance_mm} mm"),
    };
    let place = Place::line(job.file, between.feed_mm.line);
    let label = format!("on the way here by at most {:.3} mm, the farthest", between.feed_mm.value);
    let warning = Diagnostic::warning(&OFF_THE_LINE, message).at(place, label);
    Some(warning.note("between points the axes move evenly, and no points are put in"))
}

/// Looks at the ways to the points from those before them, which the solver's joints know: a word within a turn does not say
/// how the axis gets there. Several blocks are an approach, which has a way of its own.
pub(super) struct LookBetween<'a> {
    machine: &'a Machine,
    segments: Segments<'a>,
    /// Half-way, lane by lane: the joints, and where they take the tool.
    joints: JointBlock,
    poses: PoseBlock,
    /// Where the ways end.
    tips_mm: [Lane; 3],
}

impl<'a> LookBetween<'a> {
    pub(super) fn new(machine: &'a Machine) -> Self {
        Self {
            machine,
            segments: Segments::new(&machine.chain, machine.tool()),
            joints: vec![[0.0; LANES]; machine.axes.len()],
            poses: PoseBlock::ZERO,
            tips_mm: [[0.0; LANES]; 3],
        }
    }

    /// Looks at the ways of a stretch.
    pub(super) fn look<K: Kinematics>(&mut self, stretch: &Stretch, solver: &mut Solver<'_, K>, found: &mut Between) {
        let joints = stretch.joints.chunks(LANES * self.joints.len());
        for (printed, joints) in stretch.printed.chunks(LANES).zip(joints) {
            self.set_tips(printed, &stretch.points);
            self.segments.go_to(joints, &self.tips_mm);
            self.segments.half_way(&mut self.joints);
            solver.forward(&self.joints, &mut self.poses);
            self.measure(printed, &stretch.points, found);
        }
    }

    fn set_tips(&mut self, printed: &[PrintedPoint], points: &[Point]) {
        for (lane, printed) in printed.iter().enumerate() {
            let tip_mm: Vec3 = in_machine_frame(self.machine, points[printed.point].tip_mm);
            self.tips_mm.iter_mut().zip(tip_mm).for_each(|(lanes, mm)| lanes[lane] = mm);
        }
    }

    fn measure(&mut self, printed: &[PrintedPoint], points: &[Point], found: &mut Between) {
        let Self { machine, segments, poses, .. } = self;
        let is_one_block = |(_, printed): &(usize, &PrintedPoint)| printed.is_next && printed.blocks == 1;
        for (lane, printed) in printed.iter().enumerate().filter(is_one_block) {
            let Point { approach, line, .. } = points[printed.point];
            let is_cut = matches!(approach, Approach::Feed(_));
            let way = Way { is_cut, line, quick_mm: segments.quick_bound_mm(lane) };
            found.meet(way, machine.chord_tolerance_mm, || segments.deviation_mm(lane, poses.tip(lane)));
        }
    }
}
