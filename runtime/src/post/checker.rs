//! The second half of a post: what was printed is read back, compared with the CL, and written out.

use super::job::Job;
use super::stretch::{PrintedPoint, Stretch};
use crate::certificate::{Certificate, Deviation, Way};
use crate::compensation::Compensated;
use crate::coordinates::in_machine_frame;
use crate::kinematics::{JointBlock, Kinematics, LANES, PoseBlock};
use crate::readback::ReadBack;
use crate::segment::Segments;
use crate::toolpath::{Approach, Point};
use std::io::{self, Write};

/// Checks a program as it comes.
pub(super) struct Checker<'a, K> {
    job: Job<'a>,
    kinematics: Compensated<'a, K>,
    nc: &'a mut dyn Write,
    readback: ReadBack,
    certificate: Certificate,
    segments: Segments<'a>,
    /// How many blocks each of the points has.
    blocks: [u64; LANES],
    /// What the text of a block of points says, and where that takes the tool.
    joints: JointBlock,
    poses: PoseBlock,
    /// Where the CL wants it.
    wanted: PoseBlock,
}

impl<'a, K: Kinematics> Checker<'a, K> {
    pub(super) fn new(job: Job<'a>, kinematics: K, nc: &'a mut dyn Write) -> Self {
        let axes = &job.machine.axes;
        Self {
            job,
            kinematics: Compensated::new(kinematics, job.machine),
            nc,
            readback: ReadBack::new(job.dialect, axes, job.machine.tool().length_mm),
            certificate: Certificate::new(axes),
            segments: Segments::new(&job.machine.chain, job.machine.tool()),
            blocks: [0; LANES],
            joints: vec![[0.0; LANES]; axes.len()],
            poses: PoseBlock::ZERO,
            wanted: PoseBlock::ZERO,
        }
    }

    /// Reads a stretch back, compares where it takes the tool with where the CL wants it, and writes it out.
    pub(super) fn check(&mut self, stretch: &Stretch) -> io::Result<()> {
        let joints = stretch.joints.chunks(LANES * self.joints.len());
        for (printed, joints) in stretch.printed.chunks(LANES).zip(joints) {
            self.watch(printed, joints, &stretch.points);
            self.read(printed, stretch);
            self.compare(printed, &stretch.points);
            self.look_between(printed, joints, &stretch.points);
        }
        self.nc.write_all(&stretch.text)
    }

    /// What was found, after the last stretch.
    pub(super) fn finish(self) -> io::Result<Certificate> {
        self.nc.flush()?;
        Ok(self.certificate)
    }

    /// Notes where the axes go and how far the rotaries turn.
    fn watch(&mut self, printed: &[PrintedPoint], joints: &[f64], points: &[Point]) {
        for (printed, joints) in printed.iter().zip(joints.chunks(self.joints.len())) {
            let line = points[printed.point].line;
            self.certificate.visit(line, joints);
            if let Some(step_deg) = printed.rotary_step_deg {
                self.certificate.step(line, step_deg);
            }
        }
    }

    /// Reads the text of up to [`LANES`] points.
    fn read(&mut self, printed: &[PrintedPoint], stretch: &Stretch) {
        for (lane, printed) in printed.iter().enumerate() {
            let motion = printed.text.clone();
            let read = self.readback.read(&stretch.text, motion.clone());
            let (blocks, joints) = read.unwrap_or_else(|error| {
                let line = stretch.points[printed.point].line;
                let text = String::from_utf8_lossy(&stretch.text[motion]);
                panic!("the text printed for CL line {line} must read back, but: {error}\n{text}")
            });
            self.certificate.blocks += blocks;
            self.blocks[lane] = blocks;
            for (joint, value) in self.joints.iter_mut().zip(joints) {
                joint[lane] = *value;
            }
        }
    }

    /// Compares where the text takes the tool with where the CL wants it.
    fn compare(&mut self, printed: &[PrintedPoint], points: &[Point]) {
        let Self { job: Job { machine, .. }, kinematics, certificate, joints, poses, wanted, .. } = self;
        kinematics.forward(joints, machine.tool(), poses);
        for (lane, printed) in printed.iter().enumerate() {
            let Point { tip_mm, axis, .. } = points[printed.point];
            wanted.set(lane, in_machine_frame(machine, tip_mm), axis);
        }
        let deviations = deviations(wanted, poses);
        for (printed, deviation) in printed.iter().zip(deviations) {
            certificate.compare(points[printed.point].line, deviation);
        }
    }

    /// Looks at the ways to the points from those before them, which the solver's joints know: a word within a turn does not
    /// say how the axis gets there. Several blocks are an approach, which has a way of its own.
    fn look_between(&mut self, printed: &[PrintedPoint], solved: &[f64], points: &[Point]) {
        let Self { job: Job { machine, .. }, kinematics, segments, certificate, blocks, joints, poses, wanted, .. } =
            self;
        segments.go_to(solved, &wanted.tip_mm);
        segments.half_way(joints);
        kinematics.forward(joints, machine.tool(), poses);
        for (lane, printed) in
            printed.iter().enumerate().filter(|(lane, printed)| printed.is_next && blocks[*lane] == 1)
        {
            let Point { approach, line, .. } = points[printed.point];
            let is_cut = matches!(approach, Approach::Feed(_));
            let way = Way { is_cut, line, quick_mm: segments.quick_bound_mm(lane) };
            certificate.between.meet(way, machine.chord_tolerance_mm, || segments.deviation_mm(lane, poses.tip(lane)));
        }
    }
}

/// In a loop of its own, which the processor's vector registers do.
fn deviations(wanted: &PoseBlock, found: &PoseBlock) -> [Deviation; LANES] {
    let pose = |block: &PoseBlock, lane: usize| [block.tip(lane), block.axis(lane)];
    std::array::from_fn(|lane| Deviation::new(pose(wanted, lane), pose(found, lane)))
}
