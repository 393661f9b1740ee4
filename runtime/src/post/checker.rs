//! The second half of a post: what was printed is run on the control's model, compared with the CL, and written out.

use super::between::LookBetween;
use super::job::Job;
use super::otherwise;
use super::stretch::Stretch;
use crate::certificate::Certificate;
use crate::cl::Next;
use crate::control::Control;
use crate::diagnostic::Diagnostic;
use crate::kinematics::Kinematics;
use crate::motion::Motion;
use crate::road::Traveller;
use crate::verify::comparison::Comparison;
use crate::verify::pose::{Pose, Solver};
use std::io::{self, Write};

/// Checks a program as it comes.
pub(super) struct Checker<'a, K> {
    job: Job<'a>,
    nc: &'a mut dyn Write,
    control: Control<'a>,
    /// What the text of a stretch does, and where the tool is behind each item and before the first one.
    motion: Motion,
    poses: Vec<Option<Pose>>,
    before: Option<Pose>,
    solver: Solver<'a, K>,
    comparison: Comparison<'a>,
    /// Lines of the program so far.
    lines: u64,
    agrees: bool,
    certificate: Certificate,
    between: LookBetween<'a>,
}

impl<'a, K: Kinematics> Checker<'a, K> {
    pub(super) fn new(job: Job<'a>, kinematics: K, nc: &'a mut dyn Write) -> Self {
        let Job { machine, dialect, .. } = job;
        Self {
            job,
            nc,
            control: Control::new(&dialect.table, &machine.axes, machine.tool()),
            motion: Motion::new(machine.axes.len()),
            poses: Vec::new(),
            before: None,
            solver: Solver::new(machine, kinematics),
            comparison: Comparison::of_post(job.file, machine, dialect),
            lines: 0,
            agrees: true,
            certificate: Certificate::new(&machine.axes),
            between: LookBetween::new(machine),
        }
    }

    /// Runs the text of a stretch, compares what it does with what the CL wants, and writes it out. Nothing is compared once
    /// something of the CL could not be printed: that program is worth nothing.
    pub(super) fn check(&mut self, stretch: &Stretch, tell: &mut dyn FnMut(Diagnostic)) -> io::Result<()> {
        if stretch.is_refused {
            return Ok(());
        }
        self.want(stretch);
        self.run(stretch);
        self.solver.poses(&self.motion, self.before, &mut self.poses);
        self.before = self.poses.last().copied().unwrap_or(self.before);
        self.comparison.compare(&self.motion, &self.poses)?;
        self.tell(tell);
        self.watch(stretch);
        self.between.look(stretch, &mut self.solver, &mut self.certificate.between);
        self.nc.write_all(&stretch.text)
    }

    /// What was found, after the last stretch; `None` where the program does something else than the CL wants.
    pub(super) fn finish(mut self, tell: &mut dyn FnMut(Diagnostic)) -> io::Result<Option<Certificate>> {
        self.nc.flush()?;
        self.comparison.finish(self.lines)?;
        self.tell(tell);
        let agreement = self.comparison.agreement();
        self.certificate.points = agreement.points;
        self.certificate.worst = agreement.worst;
        Ok(self.agrees.then_some(self.certificate))
    }

    fn want(&mut self, stretch: &Stretch) {
        let wanted = self.comparison.want();
        for (points, next) in &stretch.blocks {
            wanted.go(&stretch.points[points.clone()]);
            if let Next::Command(command, place) = next {
                wanted.carry_out(command, place.line);
            }
        }
    }

    fn run(&mut self, stretch: &Stretch) {
        self.motion.clear();
        let text = std::str::from_utf8(&stretch.text).expect("a writer prints characters");
        let mut start = 0;
        for end in memchr::memchr_iter(b'\n', text.as_bytes()) {
            let line = &text[start..end];
            start = end + 1;
            self.lines += 1;
            if let Err((mistake, _)) = self.control.run(line, self.lines, &mut self.motion) {
                panic!("a control must understand what is printed, but in line {}: {mistake}\n{line}", self.lines);
            }
        }
    }

    fn tell(&mut self, tell: &mut dyn FnMut(Diagnostic)) {
        for found in self.comparison.found() {
            self.agrees = false;
            tell(otherwise::error(self.job, found));
        }
    }

    /// Notes where the axes go and how far the rotaries turn.
    fn watch(&mut self, stretch: &Stretch) {
        let axes = self.job.machine.axes.len();
        for (printed, joints) in stretch.printed.iter().zip(stretch.joints.chunks(axes)) {
            let line = stretch.points[printed.point].line;
            self.certificate.blocks += printed.blocks;
            self.certificate.visit(line, joints);
            if let Some(step_deg) = printed.rotary_step_deg {
                self.certificate.step(line, step_deg);
            }
        }
    }
}
