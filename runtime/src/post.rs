//! The post: CL in, NC text out, read back as it is written.

mod refusal;

use crate::branch::{Candidate, Choice};
use crate::certificate::Certificate;
use crate::cl::event::{Approach, Command, Coolant, Point, Spindle};
use crate::cl::{Next, Reader};
use crate::diagnostic::{Code, Diagnostic, Place, Severity};
use crate::kinematics::{JointBlock, Kinematics, LANES, PoseBlock};
use crate::machine::{Machine, Strictness};
use crate::nc::dialect::{Dialect, Trigger};
use crate::nc::write_error::WriteError;
use crate::nc::writer::{Values, Writer};
use crate::path::{PathSolver, Solved};
use crate::readback::ReadBack;
use crate::vector::{norm, sub};
use std::io::{self, Read, Write};
use std::ops::Range;

pub use refusal::{
    INSIDE_DEAD_RADIUS, NO_FEED_RATE, NOT_COMPENSATED, OFF_PLANE, OUT_OF_REACH, OUT_OF_TRAVEL, REPOSITION,
    REPOSITION_WARNING, SINGULAR, TOO_MANY_ERRORS,
};

/// So many errors are told; then the post gives up.
const MOST_ERRORS: u32 = 20;

/// What is posted, and for whom.
#[derive(Debug, Clone, Copy)]
pub struct Job<'a> {
    /// The CL file as the user named it.
    pub file: &'a str,
    /// The program's name.
    pub program: &'a str,
    /// The machine.
    pub machine: &'a Machine,
    /// Its controller.
    pub dialect: &'a Dialect,
}

/// Posts a CL file to `nc`. Diagnostics go to `tell` as they come. The certificate is there when the input had no errors;
/// without it what was written is worth nothing.
///
/// # Errors
/// When the CL cannot be read or the NC text cannot be written.
///
/// # Panics
/// When the printed text cannot be read back: a defect of this program.
pub fn post<R: Read>(
    job: Job<'_>,
    kinematics: &mut dyn Kinematics,
    mut reader: Reader<R>,
    nc: &mut dyn Write,
    tell: &mut dyn FnMut(Diagnostic),
) -> io::Result<Option<Certificate>> {
    let mut post = Post::new(job, kinematics, tell);
    let mut points = Vec::with_capacity(LANES);
    post.command(Trigger::Start, None);
    loop {
        points.clear();
        let next = reader.next_into(&mut points, LANES)?;
        post.points(&points);
        match next {
            Next::Full => {}
            Next::From(point) => post.stand_at(&point),
            Next::Command(command, place) => post.carry_out(command, place),
            Next::Diagnostic(diagnostic) => post.tell(diagnostic),
            Next::End => break,
        }
        if post.errors >= MOST_ERRORS {
            (post.tell)(Diagnostic::error(
                &TOO_MANY_ERRORS,
                format!("{} has more errors than are worth telling", job.file),
            ));
            return Ok(None);
        }
        post.flush(nc)?;
    }
    post.command(Trigger::End, None);
    post.flush(nc)?;
    nc.flush()?;
    Ok((post.errors == 0).then_some(post.certificate))
}

/// A post under way.
struct Post<'a> {
    job: Job<'a>,
    path: PathSolver<'a>,
    writer: Writer,
    readback: ReadBack,
    certificate: Certificate,
    tell: &'a mut dyn FnMut(Diagnostic),
    errors: u32,
    without_feed: bool,
    state: State,
    /// What has been printed and not yet handed on.
    text: Vec<u8>,
    printed: Printed,
}

/// What the placeholders of the blocks stand for, as far as the CL has said.
#[derive(Debug, Default)]
struct State {
    operation: String,
    tool_name: String,
    text: String,
    tool: u64,
    register: u64,
    speed_rpm: f64,
    dwell_s: f64,
}

/// The points of a block as they were printed: ranges of the text, and the joints they were printed from.
struct Printed {
    lanes: Vec<(usize, u64, Range<usize>)>,
    joints: JointBlock,
    poses: PoseBlock,
    /// The joints of one point.
    joint_values: Vec<f64>,
}

impl<'a> Post<'a> {
    fn new(job: Job<'a>, kinematics: &'a mut dyn Kinematics, tell: &'a mut dyn FnMut(Diagnostic)) -> Self {
        let axes = &job.machine.axes;
        Self {
            job,
            path: PathSolver::new(job.machine, kinematics),
            writer: Writer::new(job.dialect.clone(), axes),
            readback: ReadBack::new(job.dialect, axes),
            certificate: Certificate::new(axes),
            tell,
            errors: 0,
            without_feed: false,
            state: State::default(),
            text: Vec::new(),
            printed: Printed {
                lanes: Vec::with_capacity(LANES),
                joints: vec![[0.0; LANES]; axes.len()],
                poses: PoseBlock::ZERO,
                joint_values: vec![0.0; axes.len()],
            },
        }
    }

    /// A block may have more mistakes than are told.
    fn tell(&mut self, diagnostic: Diagnostic) {
        if self.errors < MOST_ERRORS {
            self.errors += u32::from(diagnostic.severity == Severity::Error);
            (self.tell)(diagnostic);
        }
    }

    /// Hands on what has been printed.
    fn flush(&mut self, nc: &mut dyn Write) -> io::Result<()> {
        nc.write_all(&self.text)?;
        self.text.clear();
        Ok(())
    }

    /// `FROM`: the choice starts from there, nothing is printed.
    fn stand_at(&mut self, point: &Point) {
        let mut diagnostic = None;
        let job = self.job;
        self.path.solve(std::slice::from_ref(point), &mut |solved| {
            diagnostic = refusal::of(job, solved);
        });
        diagnostic.into_iter().for_each(|diagnostic| self.tell(diagnostic));
    }

    /// Solves, prints and reads back a block of points.
    fn points(&mut self, points: &[Point]) {
        self.printed.lanes.clear();
        let mut diagnostics = Vec::new();
        let Self { job, path, writer, text, printed, certificate, .. } = self;
        path.solve(points, &mut |solved| match solved.chosen() {
            Some(chosen) => {
                if is_reposition(solved) {
                    diagnostics.push(refusal::of_step(*job, solved, chosen));
                }
                watch(certificate, solved, chosen);
                let start = text.len();
                match writer.motion(solved.point.approach, &chosen.joints, job.machine.tool_length_mm, text) {
                    Ok(()) => printed.lanes.push((solved.lane, solved.point.line, start..text.len())),
                    Err(error) => diagnostics.push(at_line(&error, job.file, solved.point.line)),
                }
            }
            None => diagnostics.extend(refusal::of(*job, solved)),
        });
        self.warn_without_feed(points);
        diagnostics.into_iter().for_each(|diagnostic| self.tell(diagnostic));
        self.compare();
    }

    /// Reads the block's text back, and compares where it takes the tool with where the CL wants it.
    fn compare(&mut self) {
        let Self { job, path, readback, text, printed, certificate, .. } = self;
        let length = job.machine.tool_length_mm;
        for (lane, line, range) in &printed.lanes {
            let block = &text[range.clone()];
            if let Err(error) = readback.read(block, length, &mut printed.joint_values) {
                panic!(
                    "the text printed for CL line {line} must read back, but: {error}\n{}",
                    String::from_utf8_lossy(block)
                );
            }
            certificate.blocks += memchr::memchr_iter(b'\n', block).count() as u64;
            for (joint, value) in printed.joints.iter_mut().zip(&printed.joint_values) {
                joint[*lane] = *value;
            }
        }
        path.kinematics.forward(&printed.joints, length, &mut printed.poses);
        for (lane, line, _) in &printed.lanes {
            let (tip, axis) = (printed.poses.tip(*lane), printed.poses.axis(*lane));
            certificate.compare(*line, norm(sub(tip, path.poses.tip(*lane))), [axis, path.poses.axis(*lane)]);
        }
    }

    /// A motion at feed before any feed rate is legal CL, and stops a control.
    fn warn_without_feed(&mut self, points: &[Point]) {
        let without = points.iter().find(|point| point.approach == Approach::Feed(None));
        if let (Some(point), false) = (without, self.without_feed) {
            self.without_feed = true;
            let message = "a motion at feed stands before any feed rate; its block has no feed word";
            let place = Place::line(self.job.file, point.line);
            self.tell(Diagnostic::warning(&NO_FEED_RATE, message).at(place, "no FEDRAT before it"));
        }
    }

    fn carry_out(&mut self, command: Command, place: Place) {
        let trigger = match command {
            Command::Operation { name, tool } => {
                (self.state.operation, self.state.tool_name) = (name, tool);
                Trigger::Operation
            }
            Command::Tool { number, register } => {
                (self.state.tool, self.state.register) = (number, register.unwrap_or(number));
                Trigger::Tool
            }
            Command::SpindleOn(direction, speed_rpm) => {
                self.state.speed_rpm = speed_rpm;
                match direction {
                    Spindle::Clockwise => Trigger::SpindleClockwise,
                    Spindle::Counterclockwise => Trigger::SpindleCounterclockwise,
                }
            }
            Command::SpindleOff => Trigger::SpindleOff,
            Command::CoolantOn(Coolant::Flood) => Trigger::CoolantFlood,
            Command::CoolantOn(Coolant::Mist) => Trigger::CoolantMist,
            Command::CoolantOn(Coolant::Through) => Trigger::CoolantThrough,
            Command::CoolantOff => Trigger::CoolantOff,
            Command::Stop => Trigger::Stop,
            Command::OptionalStop => Trigger::OptionalStop,
            Command::Dwell(dwell_s) => {
                self.state.dwell_s = dwell_s;
                Trigger::Dwell
            }
            Command::Message(text) => {
                self.state.text = text;
                Trigger::Message
            }
        };
        self.command(trigger, Some(place));
    }

    fn command(&mut self, trigger: Trigger, place: Option<Place>) {
        let values = Values {
            program: self.job.program,
            machine: &self.job.machine.name,
            operation: &self.state.operation,
            tool_name: &self.state.tool_name,
            text: &self.state.text,
            tool: self.state.tool,
            register: self.state.register,
            speed_rpm: self.state.speed_rpm,
            dwell_s: self.state.dwell_s,
        };
        if let Err(error) = self.writer.command(trigger, &values, &mut self.text) {
            let diagnostic = error.diagnostic();
            self.tell(match place {
                Some(place) => diagnostic.at(place, ""),
                None => diagnostic,
            });
        }
    }
}

/// Notes where the axes go and how far the rotaries turn.
fn watch(certificate: &mut Certificate, solved: &Solved<'_>, chosen: &Candidate) {
    certificate.visit(solved.point.line, &chosen.joints);
    if !solved.is_first && matches!(solved.point.approach, Approach::Feed(_)) {
        certificate.step(solved.point.line, chosen.rotary_travel_deg);
    }
}

fn at_line(error: &WriteError, file: &str, line: u64) -> Diagnostic {
    error.diagnostic().at(Place::line(file, line), "")
}

/// The codes that a post may raise by itself.
pub static CODES: [&Code; 10] = [
    &OUT_OF_REACH,
    &OUT_OF_TRAVEL,
    &REPOSITION,
    &SINGULAR,
    &NOT_COMPENSATED,
    &TOO_MANY_ERRORS,
    &INSIDE_DEAD_RADIUS,
    &OFF_PLANE,
    &REPOSITION_WARNING,
    &NO_FEED_RATE,
];

/// Whether a choice was forced by the travel, or a surplus axis jumps, in the middle of a cut.
fn is_reposition(solved: &Solved<'_>) -> bool {
    let forced = matches!(solved.choice, Choice::Candidate { forced: true, .. }) || solved.jump.is_some();
    forced && !solved.is_first && matches!(solved.point.approach, Approach::Feed(_))
}

/// As an error or a warning.
fn severity(strictness: Strictness) -> Severity {
    match strictness {
        Strictness::Error => Severity::Error,
        Strictness::Warn => Severity::Warning,
    }
}
