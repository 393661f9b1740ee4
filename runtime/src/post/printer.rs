//! The first half of a post: the CL is read, solved and printed.

use super::printed::Printed;
use super::{Job, NO_FEED_RATE, TOO_MANY_ERRORS, refusal};
use crate::branch::{Candidate, Choice};
use crate::cl::event::{Approach, Command, Coolant, Point, Spindle};
use crate::cl::{Next, Reader};
use crate::diagnostic::{Diagnostic, Place, Severity};
use crate::kinematics::{Kinematics, LANES};
use crate::nc::dialect::Trigger;
use crate::nc::write_error::WriteError;
use crate::nc::writer::{Values, Writer};
use crate::path::{PathSolver, Solved};
use std::io::{self, Read};
use std::mem;

/// So many errors are told; then the post gives up.
const MOST_ERRORS: u32 = 20;

/// Prints a program stretch by stretch.
pub(super) struct Printer<'a, R> {
    job: Job<'a>,
    reader: Reader<R>,
    path: PathSolver<'a>,
    writer: Writer,
    tell: &'a mut dyn FnMut(Diagnostic),
    errors: u32,
    without_feed: bool,
    state: State,
    /// The points of a block.
    points: Vec<Point>,
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

impl<'a, R: Read> Printer<'a, R> {
    pub(super) fn new(
        job: Job<'a>,
        kinematics: &'a mut dyn Kinematics,
        reader: Reader<R>,
        tell: &'a mut dyn FnMut(Diagnostic),
    ) -> Self {
        Self {
            job,
            reader,
            path: PathSolver::new(job.machine, kinematics),
            writer: Writer::new(job.dialect.clone(), &job.machine.axes),
            tell,
            errors: 0,
            without_feed: false,
            state: State::default(),
            points: Vec::with_capacity(LANES),
        }
    }

    /// Prints the head of the program.
    pub(super) fn begin(&mut self, printed: &mut Printed) {
        self.command(Trigger::Start, None, printed);
    }

    /// Prints until the stretch is full, and says whether the program goes on.
    pub(super) fn print(&mut self, printed: &mut Printed) -> io::Result<bool> {
        while !printed.is_full() {
            if !self.step(printed)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    pub(super) fn is_without_errors(&self) -> bool {
        self.errors == 0
    }

    /// Prints a block of points and what follows them, and says whether the program goes on.
    fn step(&mut self, printed: &mut Printed) -> io::Result<bool> {
        let mut points = mem::take(&mut self.points);
        points.clear();
        let next = self.reader.next_into(&mut points, LANES)?;
        self.points(&points, printed);
        self.points = points;
        match next {
            Next::Full => {}
            Next::From(point) => self.stand_at(&point),
            Next::Command(command, place) => self.carry_out(command, place, printed),
            Next::Diagnostic(diagnostic) => self.tell(diagnostic),
            Next::End => {
                self.command(Trigger::End, None, printed);
                return Ok(false);
            }
        }
        let gives_up = self.errors >= MOST_ERRORS;
        if gives_up {
            let message = format!("{} has more errors than are worth telling", self.job.file);
            (self.tell)(Diagnostic::error(&TOO_MANY_ERRORS, message));
        }
        Ok(!gives_up)
    }

    /// A block may have more mistakes than are told.
    fn tell(&mut self, diagnostic: Diagnostic) {
        if self.errors < MOST_ERRORS {
            self.errors += u32::from(diagnostic.severity == Severity::Error);
            (self.tell)(diagnostic);
        }
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

    /// Solves and prints a block of points.
    fn points(&mut self, points: &[Point], printed: &mut Printed) {
        let mut diagnostics = Vec::new();
        let Self { job, path, writer, .. } = self;
        path.solve(points, &mut |solved| match solved.chosen() {
            Some(chosen) => {
                if is_reposition(solved) {
                    diagnostics.push(refusal::of_step(*job, solved, chosen));
                }
                let start = printed.text.len();
                let length_mm = job.machine.tool_length_mm;
                match writer.motion(solved.point.approach, &chosen.joints, length_mm, &mut printed.text) {
                    Ok(()) => printed.add(*solved.point, start, &chosen.joints, rotary_step_deg(solved, chosen)),
                    Err(error) => diagnostics.push(at_line(&error, job.file, solved.point.line)),
                }
            }
            None => diagnostics.extend(refusal::of(*job, solved)),
        });
        self.warn_without_feed(points);
        diagnostics.into_iter().for_each(|diagnostic| self.tell(diagnostic));
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

    fn carry_out(&mut self, command: Command, place: Place, printed: &mut Printed) {
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
        self.command(trigger, Some(place), printed);
    }

    fn command(&mut self, trigger: Trigger, place: Option<Place>, printed: &mut Printed) {
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
        if let Err(error) = self.writer.command(trigger, &values, &mut printed.text) {
            let diagnostic = error.diagnostic();
            self.tell(match place {
                Some(place) => diagnostic.at(place, ""),
                None => diagnostic,
            });
        }
    }
}

fn at_line(error: &WriteError, file: &str, line: u64) -> Diagnostic {
    error.diagnostic().at(Place::line(file, line), "")
}

/// The rotary motion of a cut; none where no position is known before it.
fn rotary_step_deg(solved: &Solved<'_>, chosen: &Candidate) -> Option<f64> {
    (!solved.is_first && matches!(solved.point.approach, Approach::Feed(_))).then_some(chosen.rotary_travel_deg)
}

/// Whether a choice was forced by the travel in the middle of a cut.
fn is_reposition(solved: &Solved<'_>) -> bool {
    let forced = matches!(solved.choice, Choice::Candidate { forced: true, .. });
    forced && !solved.is_first && matches!(solved.point.approach, Approach::Feed(_))
}
