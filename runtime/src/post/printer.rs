//! The first half of a post: the points of the CL are solved and printed.

use super::in_force::InForce;
use super::job::Job;
use super::refusal::{self, NO_FEED_RATE, SPINDLE_STANDS, TOO_MANY_ERRORS};
use super::stretch::{PrintedPoint, Stretch};
use crate::branch::Candidate;
use crate::cl::Next;
use crate::diagnostic::{Diagnostic, Place, Severity};
use crate::kinematics::Kinematics;
use crate::nc::dialect::Trigger;
use crate::nc::write_error::WriteError;
use crate::nc::writer::Writer;
use crate::path::{PathSolver, Solved};
use crate::toolpath::{Approach, Command, Point};
use std::mem;
use std::ops::Range;

/// So many errors are told; then the post gives up.
const MOST_ERRORS: u32 = 20;

/// Prints a program stretch by stretch.
pub(super) struct Printer<'a> {
    job: Job<'a>,
    path: PathSolver<'a>,
    writer: Writer,
    errors: u32,
    has_begun: bool,
    without_feed: bool,
    /// Whether a cut with a standing spindle is worth telling: the controller can switch it on, and it has not been told.
    expects_spindle: bool,
    in_force: InForce,
}

impl<'a> Printer<'a> {
    pub(super) fn new(job: Job<'a>, kinematics: &'a mut (dyn Kinematics + Send)) -> Self {
        Self {
            job,
            path: PathSolver::new(job.machine, kinematics),
            writer: Writer::new(job.dialect.clone(), &job.machine.axes),
            errors: 0,
            has_begun: false,
            without_feed: false,
            expects_spindle: job.dialect.block(Trigger::SpindleClockwise).is_some(),
            in_force: InForce::default(),
        }
    }

    pub(super) fn is_without_errors(&self) -> bool {
        self.errors == 0
    }

    /// Prints a stretch that has been read. After too many errors that stretch is the last one.
    pub(super) fn print(&mut self, stretch: &mut Stretch) {
        if !mem::replace(&mut self.has_begun, true) {
            self.command(Trigger::Start, None, stretch);
        }
        let blocks = mem::take(&mut stretch.blocks);
        for (points, next) in &blocks {
            self.points(points.clone(), stretch);
            match next {
                Next::Full => {}
                Next::From(point) => self.stand_at(point, stretch),
                Next::Command(command, place) => self.carry_out(command, place, stretch),
                Next::Diagnostic(diagnostic) => self.tell(diagnostic.clone(), stretch),
                Next::End => {
                    self.command(Trigger::End, None, stretch);
                    break;
                }
            }
            if self.errors >= MOST_ERRORS {
                let message = format!("{} has more errors than are worth telling", self.job.file);
                stretch.diagnostics.push(Diagnostic::error(&TOO_MANY_ERRORS, message));
                stretch.is_last = true;
                break;
            }
        }
        stretch.blocks = blocks;
        stretch.is_refused = self.errors > 0;
    }

    /// A block may have more mistakes than are told.
    fn tell(&mut self, diagnostic: Diagnostic, stretch: &mut Stretch) {
        if self.errors < MOST_ERRORS {
            self.errors += u32::from(diagnostic.severity == Severity::Error);
            stretch.diagnostics.push(diagnostic);
        }
    }

    /// `FROM`: the choice starts from there, nothing is printed.
    fn stand_at(&mut self, point: &Point, stretch: &mut Stretch) {
        let mut diagnostic = None;
        let job = self.job;
        self.path.solve(std::slice::from_ref(point), &mut |solved| {
            diagnostic = refusal::of(job, solved);
        });
        diagnostic.into_iter().for_each(|diagnostic| self.tell(diagnostic, stretch));
    }

    /// Solves and prints a block of points.
    fn points(&mut self, block: Range<usize>, stretch: &mut Stretch) {
        let mut diagnostics = Vec::new();
        let Self { job, path, writer, in_force, .. } = self;
        let Stretch { points, text, printed, joints, .. } = stretch;
        path.solve(&points[block.clone()], &mut |solved| match solved.chosen() {
            Some(chosen) => {
                if is_reposition(solved) {
                    diagnostics.push(refusal::of_step(*job, solved, chosen));
                }
                match print(*job, in_force, writer, solved.point, &chosen.joints, text) {
                    Ok((blocks, is_next)) => {
                        let rotary_step_deg = rotary_step_deg(solved, chosen);
                        printed.push(PrintedPoint {
                            point: block.start + solved.lane,
                            blocks,
                            rotary_step_deg,
                            is_next,
                        });
                        joints.extend_from_slice(&chosen.joints);
                    }
                    Err(error) => diagnostics.push(at_line(&error, job.file, solved.point.line)),
                }
            }
            None => diagnostics.extend(refusal::of(*job, solved)),
        });
        self.warn_without_feed(block.clone(), stretch);
        self.warn_without_spindle(block, stretch);
        diagnostics.into_iter().for_each(|diagnostic| self.tell(diagnostic, stretch));
    }

    /// A motion at feed before any feed rate is legal CL, and stops a control.
    fn warn_without_feed(&mut self, block: Range<usize>, stretch: &mut Stretch) {
        let without = stretch.points[block].iter().find(|point| point.approach == Approach::Feed(None));
        if let (Some(point), false) = (without, self.without_feed) {
            self.without_feed = true;
            let message = "a motion at feed stands before any feed rate; its block has no feed word";
            let place = Place::line(self.job.file, point.line);
            self.tell(Diagnostic::warning(&NO_FEED_RATE, message).at(place, "no FEDRAT before it"), stretch);
        }
    }

    /// A motion at feed while the spindle stands is legal CL, too.
    fn warn_without_spindle(&mut self, block: Range<usize>, stretch: &mut Stretch) {
        if !self.expects_spindle || self.in_force.spindle_turns() {
            return;
        }
        let cut = stretch.points[block].iter().find(|point| is_cut(point));
        if let Some(point) = cut {
            self.expects_spindle = false;
            let place = Place::line(self.job.file, point.line);
            let warning = Diagnostic::warning(&SPINDLE_STANDS, "a motion at feed while the spindle stands");
            self.tell(warning.at(place, "no SPINDL is in force"), stretch);
        }
    }

    fn carry_out(&mut self, command: &Command, place: &Place, stretch: &mut Stretch) {
        if let Some(trigger) = self.in_force.take(command) {
            self.command(trigger, Some(place), stretch);
        }
    }

    fn command(&mut self, trigger: Trigger, place: Option<&Place>, stretch: &mut Stretch) {
        let values = self.in_force.values(self.job);
        let printed = self.writer.command(trigger, &values, &mut stretch.text);
        self.in_force.interrupt(self.writer.switches_off(trigger));
        if let Err(error) = printed {
            let diagnostic = error.diagnostic();
            let diagnostic = match place {
                Some(place) => diagnostic.at(place.clone(), ""),
                None => diagnostic,
            };
            self.tell(diagnostic, stretch);
        }
    }
}

/// Prints a point; before a cut, what a block has switched off and the CL has not is switched on again. Says how many
/// blocks the motion has, and whether it goes on from the point before.
fn print(
    job: Job<'_>,
    in_force: &mut InForce,
    writer: &mut Writer,
    point: &Point,
    joints: &[f64],
    text: &mut Vec<u8>,
) -> Result<(u64, bool), WriteError> {
    while is_cut(point)
        && let Some(trigger) = in_force.resume()
    {
        writer.command(trigger, &in_force.values(job), text)?;
    }
    let is_next = writer.knows_position();
    let blocks = writer.motion(point.approach, joints, job.machine.tool().length_mm, text)?;
    Ok((blocks, is_next))
}

fn is_cut(point: &Point) -> bool {
    matches!(point.approach, Approach::Feed(_))
}

fn at_line(error: &WriteError, file: &str, line: u64) -> Diagnostic {
    error.diagnostic().at(Place::line(file, line), "")
}

/// The rotary motion of a cut; none where no position is known before it.
fn rotary_step_deg(solved: &Solved<'_>, chosen: &Candidate) -> Option<f64> {
    (!solved.is_first && is_cut(solved.point)).then_some(chosen.rotary_travel_deg)
}

/// Whether a choice was forced by the travel, or a surplus axis jumps, in the middle of a cut.
fn is_reposition(solved: &Solved<'_>) -> bool {
    let forced = solved.is_forced() || solved.jump.is_some();
    forced && !solved.is_first && is_cut(solved.point)
}
