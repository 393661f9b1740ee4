//! The second half of a post: what was printed is read back, compared with the CL, and written out.

use super::Job;
use super::printed::{Printed, PrintedPoint};
use crate::certificate::Certificate;
use crate::kinematics::{JointBlock, Kinematics, LANES, PoseBlock};
use crate::readback::ReadBack;
use crate::vector::{add, norm, sub};
use std::io::{self, Write};

/// Checks a program as it comes.
pub(super) struct Checker<'a, K> {
    job: Job<'a>,
    kinematics: K,
    nc: &'a mut (dyn Write + Send),
    readback: ReadBack,
    certificate: Certificate,
    /// What the text of a block of points says, and where that takes the tool.
    joints: JointBlock,
    poses: PoseBlock,
    /// The joints of one point.
    joint_values: Vec<f64>,
}

impl<'a, K: Kinematics> Checker<'a, K> {
    pub(super) fn new(job: Job<'a>, kinematics: K, nc: &'a mut (dyn Write + Send)) -> Self {
        let axes = &job.machine.axes;
        Self {
            job,
            kinematics,
            nc,
            readback: ReadBack::new(job.dialect, axes),
            certificate: Certificate::new(axes),
            joints: vec![[0.0; LANES]; axes.len()],
            poses: PoseBlock::ZERO,
            joint_values: vec![0.0; axes.len()],
        }
    }

    /// Reads a stretch back, compares where it takes the tool with where the CL wants it, writes it out, and empties it.
    pub(super) fn check(&mut self, printed: &mut Printed) -> io::Result<()> {
        let joints = printed.joints.chunks(LANES * self.joint_values.len());
        for (points, joints) in printed.points.chunks(LANES).zip(joints) {
            self.watch(points, joints);
            self.read(points, &printed.text);
            self.compare(points);
        }
        self.nc.write_all(&printed.text)?;
        printed.clear();
        Ok(())
    }

    /// What was found, after the last stretch.
    pub(super) fn finish(self) -> io::Result<Certificate> {
        self.nc.flush()?;
        Ok(self.certificate)
    }

    /// Notes where the axes go and how far the rotaries turn.
    fn watch(&mut self, points: &[PrintedPoint], joints: &[f64]) {
        for (PrintedPoint { point, rotary_step_deg, .. }, joints) in
            points.iter().zip(joints.chunks(self.joint_values.len()))
        {
            self.certificate.visit(point.line, joints);
            if let Some(step_deg) = rotary_step_deg {
                self.certificate.step(point.line, *step_deg);
            }
        }
    }

    /// Reads the text of up to [`LANES`] points.
    fn read(&mut self, points: &[PrintedPoint], text: &[u8]) {
        for (lane, PrintedPoint { point, text: range, .. }) in points.iter().enumerate() {
            let blocks = &text[range.clone()];
            if let Err(error) = self.readback.read(blocks, self.job.machine.tool_length_mm, &mut self.joint_values) {
                panic!(
                    "the text printed for CL line {} must read back, but: {error}\n{}",
                    point.line,
                    String::from_utf8_lossy(blocks)
                );
            }
            self.certificate.blocks += memchr::memchr_iter(b'\n', blocks).count() as u64;
            for (joint, value) in self.joints.iter_mut().zip(&self.joint_values) {
                joint[lane] = *value;
            }
        }
    }

    /// Compares where the text takes the tool with where the CL wants it.
    fn compare(&mut self, points: &[PrintedPoint]) {
        let Self { job: Job { machine, .. }, kinematics, certificate, joints, poses, .. } = self;
        kinematics.forward(joints, machine.tool_length_mm, poses);
        for (lane, PrintedPoint { point, .. }) in points.iter().enumerate() {
            let tip_mm = norm(sub(poses.tip(lane), add(point.tip_mm, machine.zero_mm)));
            certificate.compare(point.line, tip_mm, [poses.axis(lane), point.axis]);
        }
    }
}
