//! A program against its CL: point by point and event by event, in their order.

use super::agreement::Agreement;
use super::habit::Habit;
use super::judgement::{Judgement, Reached};
use super::mismatch::{Difference, Found};
use super::pose::{Pose, Solver};
use super::tolerance::Tolerance;
use super::wanted::{Wanted, WantedStream, WantedWhat};
use super::words::{self, PointReached};
use crate::cl::Reader;
use crate::diagnostic::Diagnostic;
use crate::dialect::meaning::{Side, Spindle};
use crate::kinematics::Kinematics;
use crate::machine::Machine;
use crate::motion::{Event, Item, Law, Motion, Move, State, What};
use crate::nc::dialect::Dialect;
use std::io::{self, Read};

/// So many differences are told.
const MOST_DIFFERENCES: u64 = 20;

/// Compares a program with a CL as it is read.
pub struct Comparison<'a> {
    cl: String,
    stream: WantedStream<'a>,
    habit: Habit,
    tolerance: Tolerance<'a>,
    judgement: Judgement,
    /// Where the tool is, and the line that took it there.
    at: Option<Pose>,
    last_line: u64,
    /// Whether blocks may lead to the next point that the CL does not know.
    may_approach: bool,
    /// Whether blocks of the approach so far are rapid, or at feed.
    approach: [Option<u64>; 2],
    /// Where, on the way to the first point, the axes have moved that should move last.
    lowered_at: Option<u64>,
    /// Where the axes have gone in machine coordinates since the last point of the CL.
    way_out: Vec<Option<f64>>,
    /// Whether the program has said that it is over.
    has_ended: bool,
    /// The points that the last items reached, and the differences found in them.
    reached: Vec<PointReached>,
    found: Vec<FoundAt>,
    agreement: Agreement,
}

/// A difference, at a line of the program and perhaps one of the CL.
pub(crate) struct FoundAt {
    pub(crate) found: Found,
    pub(crate) line: u64,
    pub(crate) cl_line: Option<u64>,
}

/// A move and where it leads.
#[derive(Clone, Copy)]
struct Gone<'m> {
    it: &'m Move,
    line: u64,
    pose: Pose,
    motion: &'m Motion,
    state: &'m State,
}

impl Gone<'_> {
    fn joints(&self) -> &[f64] {
        self.motion.joints(self.it)
    }

    fn cuts(&self) -> bool {
        self.it.law != Law::Rapid
    }
}

impl<'a> Comparison<'a> {
    /// With a CL that the user calls `cl`.
    pub fn new(cl: &str, reader: Reader<Box<dyn Read + 'a>>, machine: &'a Machine, dialect: &Dialect) -> Self {
        Self::with(cl, WantedStream::new(reader, machine), machine, dialect)
    }

    fn with(cl: &str, stream: WantedStream<'a>, machine: &'a Machine, dialect: &Dialect) -> Self {
        Self {
            cl: cl.to_owned(),
            stream,
            last_line: 0,
            habit: Habit::of(machine, dialect),
            tolerance: Tolerance::of(machine, dialect),
            judgement: Judgement::new(),
            at: None,
            may_approach: true,
            approach: [None; 2],
            lowered_at: None,
            way_out: vec![None; machine.axes.len()],
            has_ended: false,
            reached: Vec::new(),
            found: Vec::new(),
            agreement: Agreement::default(),
        }
    }

    /// With a CL that is at hand piece by piece: see [`Self::want`].
    pub(crate) fn of_post(cl: &str, machine: &'a Machine, dialect: &Dialect) -> Self {
        Self::with(cl, WantedStream::in_pieces(machine), machine, dialect)
    }

    /// What the CL wants next.
    pub(crate) fn want(&mut self) -> &mut WantedStream<'a> {
        &mut self.stream
    }

    /// Takes items that leave the tool at these poses, as far as they are known.
    pub(crate) fn compare(&mut self, motion: &Motion, poses: &[Option<Pose>]) -> io::Result<()> {
        self.reached.clear();
        motion.items().iter().zip(poses).try_for_each(|(item, pose)| self.item(item, motion, *pose))
    }

    /// Judges the words of the points that were reached by the last items.
    pub(super) fn judge_words<K: Kinematics>(&mut self, motion: &Motion, solver: &mut Solver<'_, K>) {
        let Self { reached, tolerance, found, .. } = self;
        words::judge(reached, motion, solver, tolerance, &mut |it, point| {
            found.push(FoundAt { found: it, line: point.line, cl_line: Some(point.cl_line) });
        });
    }

    /// The program is over, with this line.
    pub(crate) fn finish(&mut self, line: u64) -> io::Result<()> {
        self.pass_points_at_rest()?;
        if let Some(wanted) = self.stream.peek()? {
            self.differ(Difference::Elsewhere, "the program is over before the CL is", line, Some(wanted.line));
        }
        if self.habit.ends && !self.has_ended {
            self.differ(Difference::Order, "nothing says that the program is over", line, None);
        }
        Ok(())
    }

    /// What has been found so far.
    pub(crate) fn agreement(&self) -> Agreement {
        let differences = self.agreement.differences + u64::from(self.stream.has_errors);
        Agreement { differences, ..self.agreement }
    }

    fn item(&mut self, item: &Item, motion: &Motion, pose: Option<Pose>) -> io::Result<()> {
        let state = motion.state(item);
        match (&item.what, pose) {
            (What::Event(event), _) => self.event(*event, state, item.line),
            (What::Move(it), _) if it.is_machine => {
                self.retract(it, motion, item.line);
                Ok(())
            }
            (What::Move(it), Some(pose)) => self.go(Gone { it, line: item.line, pose, motion, state }),
            (What::Move(it), None) => {
                self.note_approach(it, state, item.line);
                Ok(())
            }
        }
    }

    fn retract(&mut self, it: &Move, motion: &Motion, line: u64) {
        self.agreement.retracts += 1;
        self.may_approach = true;
        for (axis, joint) in motion.joints(it).iter().enumerate().filter(|(axis, _)| it.named & 1 << axis != 0) {
            self.way_out[axis] = (it.known & 1 << axis != 0).then_some(*joint);
        }
        self.at = None;
        if it.law != Law::Rapid {
            self.differ(Difference::Kind, "the tool goes to its way out at feed", line, None);
        }
    }

    fn note_approach(&mut self, it: &Move, state: &State, line: u64) {
        self.agreement.approaches += 1;
        if state.side != Side::Off {
            self.differ(Difference::State, "the cutter's radius is compensated on the approach", line, None);
        }
        self.approach[usize::from(it.law != Law::Rapid)].get_or_insert(line);
        if it.named & self.habit.last != 0 {
            self.lowered_at.get_or_insert(line);
        }
    }

    /// A motion that ends at a pose.
    fn go(&mut self, gone: Gone<'_>) -> io::Result<()> {
        let Gone { line, pose, .. } = gone;
        loop {
            let wanted = self.stream.peek()?;
            match wanted.map(|wanted| (wanted.line, wanted.what)) {
                Some((cl_line, WantedWhat::Point { pose: there, is_cut, state })) => {
                    let is_at_rest = || self.at.is_some_and(|at| self.tolerance.agrees(at, there, gone.joints()));
                    if (is_cut == gone.cuts() || !is_at_rest()) && self.tolerance.agrees(pose, there, gone.joints()) {
                        let wanted = self.stream.state(state);
                        self.stream.pass(1);
                        self.reach(&gone, there, cl_line);
                        self.judge(&Reached { is_cut, cuts: gone.cuts(), wanted, state: *gone.state }, line, cl_line);
                        return Ok(());
                    }
                    if !is_at_rest() && !self.is_on_arc(&gone, there) {
                        return self.unasked(&gone);
                    }
                    self.pass_at_rest(there, cl_line);
                }
                Some((cl_line, WantedWhat::Event(event))) => {
                    if self.at.is_some_and(|at| self.tolerance.agrees(pose, at, gone.joints())) {
                        return Ok(());
                    }
                    let message = format!("{} is missing before this block", named(event));
                    self.differ(Difference::Order, message, line, Some(cl_line));
                    self.stream.pass(1);
                }
                None => return self.unasked(&gone),
            }
        }
    }

    /// A motion to a place that the CL does not ask for next.
    fn unasked(&mut self, gone: &Gone<'_>) -> io::Result<()> {
        let Gone { it, line, pose, .. } = *gone;
        let wanted = self.stream.peek()?;
        let stays = self.at.is_some_and(|at| self.tolerance.agrees(pose, at, gone.joints()));
        if stays {
            return Ok(());
        }
        if self.may_approach && wanted.is_some() {
            self.note_approach(it, gone.state, line);
            self.at = Some(pose);
            return Ok(());
        }
        let tolerance = &self.tolerance;
        let is_there = |wanted: &Wanted| match wanted.what {
            WantedWhat::Point { pose: there, .. } => tolerance.agrees(pose, there, gone.joints()),
            WantedWhat::Event(_) => false,
        };
        let later = self.stream.ahead()?.position(is_there);
        let message = match (wanted.map(|wanted| wanted.what), later) {
            (Some(_), Some(left_out)) => format!("{left_out} points of the CL are left out before this block"),
            (Some(WantedWhat::Point { pose: there, .. }), None) => {
                let (tip_mm, axis_rad) = pose.apart(there);
                let axis_deg = axis_rad.to_degrees();
                format!("the tool ends {tip_mm:.4} mm and {axis_deg:.4} deg from the CL's next point")
            }
            _ => "the program goes on where the CL is over".to_owned(),
        };
        self.differ(Difference::Elsewhere, message, line, wanted.map(|wanted| wanted.line));
        self.stream.pass(later.map_or(usize::from(wanted.is_some() && later.is_none()), |later| later + 1));
        self.at = Some(pose);
        Ok(())
    }

    /// A point of the CL is reached.
    fn reach(&mut self, gone: &Gone<'_>, there: Pose, cl_line: u64) {
        let Gone { it, line, pose, .. } = *gone;
        if let Some(at) = self.lowered_at.take()
            && it.named & !self.habit.last != 0
        {
            let message = "the tool is lowered before the other axes are in place";
            self.differ(Difference::WayOut, message, at, Some(cl_line));
        }
        // The words of a post are those of joints that have just been solved for.
        if !self.stream.is_in_pieces() {
            self.reached.push(PointReached { joints: it.joints, wanted: there, line, cl_line });
        }
        self.agreement.reach(pose, there, self.line_of(line, cl_line));
        self.at = Some(pose);
        self.last_line = line;
        if self.may_approach {
            self.may_approach = false;
            self.way_out.fill(None);
        }
    }

    /// What is in force at a point that is reached, and on the way to the first one.
    fn judge(&mut self, reached: &Reached, line: u64, cl_line: u64) {
        let [rapid, feed] = std::mem::take(&mut self.approach);
        let (at, message) = match reached.is_cut {
            true => (rapid, "the approach is in rapid traverse"),
            false => (feed, "the approach is at feed"),
        };
        if let Some(at) = at.filter(|_| reached.is_cut == reached.cuts) {
            self.differ(Difference::Kind, message, at, Some(cl_line));
        }
        let Self { judgement, habit, tolerance, found, .. } = self;
        judgement.judge(reached, habit, tolerance, |it| {
            found.push(FoundAt { found: it, line, cl_line: Some(cl_line) });
        });
    }

    /// Whether a point lies on the arc that the tool is on, the axis as it is.
    fn is_on_arc(&self, gone: &Gone<'_>, there: Pose) -> bool {
        match gone.it.law {
            Law::Arc(index) => self.tolerance.is_on_arc(gone.motion.arc(index), there),
            _ => false,
        }
    }

    /// Points at which the tool already is need no block.
    fn pass_points_at_rest(&mut self) -> io::Result<()> {
        while let Some(Wanted { what: WantedWhat::Point { pose: there, .. }, line }) = self.stream.peek()?
            && self.at.is_some_and(|at| self.tolerance.is_same(at, there))
        {
            self.pass_at_rest(there, line);
        }
        Ok(())
    }

    fn pass_at_rest(&mut self, there: Pose, cl_line: u64) {
        match self.at {
            Some(at) => self.agreement.reach(at, there, self.line_of(self.last_line, cl_line)),
            None => self.agreement.points += 1,
        }
        self.stream.pass(1);
    }

    /// The line that the largest errors are at: a program that has just been made of the CL is not what is of interest.
    fn line_of(&self, line: u64, cl_line: u64) -> u64 {
        if self.stream.is_in_pieces() { cl_line } else { line }
    }

    fn event(&mut self, event: Event, state: &State, line: u64) -> io::Result<()> {
        self.pass_points_at_rest()?;
        if matches!(event, Event::ToolChange(_) | Event::End) {
            self.judge_way_out(event, state, line);
        }
        if event == Event::End {
            self.has_ended = true;
            return Ok(());
        }
        let wanted = self.stream.peek()?;
        self.may_approach |= matches!(event, Event::ToolChange(_));
        if wanted.is_some_and(|wanted| wanted.what == WantedWhat::Event(event)) {
            self.stream.pass(1);
            return Ok(());
        }
        let later = self.stream.ahead()?.any(|wanted| wanted.what == WantedWhat::Event(event));
        let message = match later {
            true => format!("{} comes before points of the CL that stand before it", named(event)),
            false => format!("the CL does not ask for {}", named(event)),
        };
        self.differ(Difference::Order, message, line, wanted.map(|wanted| wanted.line));
        Ok(())
    }

    /// Whether the tool has been taken out as the description does.
    fn judge_way_out(&mut self, event: Event, state: &State, line: u64) {
        let habit = &self.habit.way_out[usize::from(event == Event::End)];
        let is_out = habit.iter().zip(&self.way_out).all(|(habit, found)| match (habit, found) {
            (Some(wanted), Some(found)) => self.tolerance.is_same_word(*wanted, *found),
            (Some(_), None) => false,
            (None, _) => true,
        });
        if !is_out {
            let message = format!("{} comes while the tool is not at its way out", named(event));
            self.differ(Difference::WayOut, message, line, None);
        }
        if self.habit.stops_spindle && state.spindle != Spindle::Off {
            let message = format!("{} comes while the spindle turns", named(event));
            self.differ(Difference::Spindle, message, line, None);
        }
    }

    fn differ(&mut self, difference: Difference, message: impl Into<String>, line: u64, cl_line: Option<u64>) {
        self.found.push(FoundAt { found: (difference, message.into()), line, cl_line });
    }

    /// Tells what was found in the program that the user calls `file`, in its order.
    pub(super) fn tell(&mut self, file: &str, tell: &mut dyn FnMut(Diagnostic)) {
        self.stream.diagnostics.drain(..).for_each(&mut *tell);
        for FoundAt { found: (difference, message), line, cl_line } in self.found() {
            tell(difference.diagnostic(message, (file, line), cl_line.map(|line| (self.cl.as_str(), line))));
        }
    }

    /// What was found in the last items, in the order of the program, as far as it is worth telling.
    pub(crate) fn found(&mut self) -> Vec<FoundAt> {
        let worth = MOST_DIFFERENCES.saturating_sub(self.agreement.differences);
        self.agreement.differences += self.found.len() as u64;
        self.found.sort_by_key(|found| found.line);
        std::mem::take(&mut self.found).into_iter().take(worth as usize).collect()
    }
}

fn named(event: Event) -> String {
    match event {
        Event::ToolChange(tool) => format!("the change to tool {tool}"),
        Event::Dwell(seconds) => format!("a dwell of {seconds} s"),
        Event::Stop => "a stop".to_owned(),
        Event::OptionalStop => "an optional stop".to_owned(),
        Event::End => "the end of the program".to_owned(),
    }
}
