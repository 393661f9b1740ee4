//! A program against its CL: point by point and event by event, in their order.

use super::habit::Habit;
use super::mismatch::Difference;
use super::pose::{Pose, Solver};
use super::tolerance::Tolerance;
use super::wanted::{Wanted, WantedState, WantedStream, WantedWhat};
use crate::certificate::Extreme;
use crate::cl::Reader;
use crate::diagnostic::Diagnostic;
use crate::dialect::meaning::{Side, Spindle};
use crate::dialect::table::Table;
use crate::machine::Machine;
use crate::motion::{Event, Feed, Item, Law, Motion, Move, State, What};
use crate::nc::dialect::Dialect;
use std::collections::BTreeSet;
use std::fmt;
use std::io::{self, Read};

/// So many differences are told.
const MOST_DIFFERENCES: u64 = 20;

/// What a comparison has found.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Agreement {
    /// Points of the CL that the program reaches.
    pub points: u64,
    /// The largest distance of the tip from the CL's point, in millimetres, at the line of the program.
    pub tip_mm: Extreme,
    /// The largest angle of the tool axis from the CL's, in radians.
    pub axis_rad: Extreme,
    /// Blocks that the CL did not ask for: to the way out and the reference point.
    pub retracts: u64,
    /// Blocks that the CL did not ask for: on the way to the first point behind a retract or a tool change.
    pub approaches: u64,
    /// Differences.
    pub differences: u64,
}

/// Compares a program with a CL as it is read.
pub struct Comparison<'a> {
    cl: String,
    stream: WantedStream<'a>,
    habit: Habit,
    tolerance: Tolerance<'a>,
    /// Where the tool is.
    at: Option<Pose>,
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
    /// What has been told of states, until it is right again.
    told: BTreeSet<Difference>,
    agreement: Agreement,
}

impl<'a> Comparison<'a> {
    /// With a CL that the user calls `cl`.
    pub fn new(
        cl: &str,
        reader: Reader<Box<dyn Read + 'a>>,
        machine: &'a Machine,
        dialect: &Dialect,
        table: &Table,
    ) -> Self {
        Self {
            cl: cl.to_owned(),
            stream: WantedStream::new(reader, machine),
            habit: Habit::of(machine, dialect, table),
            tolerance: Tolerance::of(machine, dialect),
            at: None,
            may_approach: true,
            approach: [None; 2],
            lowered_at: None,
            way_out: vec![None; machine.axes.len()],
            has_ended: false,
            told: BTreeSet::new(),
            agreement: Agreement::default(),
        }
    }

    /// The program is over.
    ///
    /// # Errors
    /// When the CL cannot be read.
    pub fn finish(mut self, program: (&str, u64), tell: &mut dyn FnMut(Diagnostic)) -> io::Result<Agreement> {
        self.pass_points_at_rest(tell)?;
        if let Some(wanted) = self.stream.peek(tell)? {
            let message = "the program is over before the CL is".to_owned();
            self.differ(Difference::Elsewhere, message, program, Some(wanted.line), tell);
        }
        if self.habit.ends && !self.has_ended {
            let message = "nothing says that the program is over".to_owned();
            self.differ(Difference::Order, message, program, None, tell);
        }
        self.agreement.differences += u64::from(self.stream.has_errors);
        Ok(self.agreement)
    }

    /// Takes an item that leaves the tool at a pose, if that is known.
    pub(super) fn take(
        &mut self,
        item: &Item,
        motion: &Motion,
        (after, solver): (Option<Pose>, &mut Solver<'_>),
        file: &str,
        tell: &mut dyn FnMut(Diagnostic),
    ) -> io::Result<()> {
        let program = (file, item.line);
        match &item.what {
            What::Event(event) => self.event(*event, motion.state(item), program, tell),
            What::Move(it) if it.is_machine => {
                self.retract(it, motion);
                if it.law != Law::Rapid {
                    let message = "the tool goes to its way out at feed".to_owned();
                    self.differ(Difference::Kind, message, program, None, tell);
                }
                Ok(())
            }
            What::Move(it) => match after {
                Some(pose) => self.go(it, motion, motion.state(item), (pose, solver), program, tell),
                None => {
                    self.note_approach(it, item.line);
                    Ok(())
                }
            },
        }
    }

    fn retract(&mut self, it: &Move, motion: &Motion) {
        self.agreement.retracts += 1;
        self.may_approach = true;
        for (axis, joint) in motion.joints(it).iter().enumerate().filter(|(axis, _)| it.named & 1 << axis != 0) {
            self.way_out[axis] = (it.known & 1 << axis != 0).then_some(*joint);
        }
        self.at = None;
    }

    fn note_approach(&mut self, it: &Move, line: u64) {
        self.agreement.approaches += 1;
        self.approach[usize::from(it.law != Law::Rapid)].get_or_insert(line);
        if it.named & self.habit.last != 0 {
            self.lowered_at.get_or_insert(line);
        }
    }

    /// A motion that ends at a pose.
    fn go(
        &mut self,
        it: &Move,
        motion: &Motion,
        state: &State,
        (pose, solver): (Pose, &mut Solver<'_>),
        program: (&str, u64),
        tell: &mut dyn FnMut(Diagnostic),
    ) -> io::Result<()> {
        let joints = motion.joints(it);
        loop {
            let wanted = self.stream.peek(tell)?;
            match wanted.map(|wanted| (wanted, wanted.what)) {
                Some((wanted, WantedWhat::Point { pose: there, is_cut, state: its })) => {
                    if self.tolerance.agrees(pose, there, joints) {
                        self.judge_approach(it, program.0, wanted.line, tell);
                        self.judge_words(joints, there, solver, program, wanted.line, tell);
                        self.reached(pose, there, program.1);
                        self.judge(is_cut, it.law != Law::Rapid, &its, state, program, wanted.line, tell);
                        self.stream.pass(1);
                        return Ok(());
                    }
                    let is_at_rest = self.at.is_some_and(|at| self.tolerance.agrees(at, there, joints));
                    if is_at_rest || self.is_on_arc(it, motion, there) {
                        self.agreement.points += 1;
                        self.stream.pass(1);
                        continue;
                    }
                }
                Some((wanted, WantedWhat::Event(event))) => {
                    if self.at.is_some_and(|at| self.tolerance.agrees(pose, at, joints)) {
                        return Ok(());
                    }
                    let message = format!("{} is missing before this block", named(event));
                    self.differ(Difference::Order, message, program, Some(wanted.line), tell);
                    self.stream.pass(1);
                    continue;
                }
                None => {}
            }
            return self.unasked(it, joints, pose, wanted, program, tell);
        }
    }

    /// A motion to a place that the CL does not ask for next.
    fn unasked(
        &mut self,
        it: &Move,
        joints: &[f64],
        pose: Pose,
        wanted: Option<Wanted>,
        program: (&str, u64),
        tell: &mut dyn FnMut(Diagnostic),
    ) -> io::Result<()> {
        let stays = self.at.is_some_and(|at| self.tolerance.agrees(pose, at, joints));
        if stays {
            return Ok(());
        }
        if self.may_approach && wanted.is_some() {
            self.note_approach(it, program.1);
            self.at = Some(pose);
            return Ok(());
        }
        let tolerance = &self.tolerance;
        let is_there = |wanted: &Wanted| match wanted.what {
            WantedWhat::Point { pose: there, .. } => tolerance.agrees(pose, there, joints),
            WantedWhat::Event(_) => false,
        };
        let later = self.stream.ahead(tell)?.position(is_there);
        let message = match (wanted.map(|wanted| wanted.what), later) {
            (Some(_), Some(left_out)) => format!("{left_out} points of the CL are left out before this block"),
            (Some(WantedWhat::Point { pose: there, .. }), None) => {
                let (tip_mm, axis_rad) = pose.apart(there);
                let axis_deg = axis_rad.to_degrees();
                format!("the tool ends {tip_mm:.4} mm and {axis_deg:.4} deg from the CL's next point")
            }
            _ => "the program goes on where the CL is over".to_owned(),
        };
        self.differ(Difference::Elsewhere, message, program, wanted.map(|wanted| wanted.line), tell);
        self.stream.pass(later.map_or(usize::from(wanted.is_some() && later.is_none()), |later| later + 1));
        self.at = Some(pose);
        Ok(())
    }

    /// The words of a point that is reached: each is the solution's but for its last digit.
    fn judge_words(
        &mut self,
        joints: &[f64],
        there: Pose,
        solver: &mut Solver<'_>,
        program: (&str, u64),
        cl_line: u64,
        tell: &mut dyn FnMut(Diagnostic),
    ) {
        let Some(off) = solver.off(there, joints) else { return };
        if let Some((axis, by)) = self.tolerance.wrong_word(&off) {
            let message = format!("{axis} is off by {by:.4} from where the CL's point needs it");
            self.differ(Difference::Elsewhere, message, program, Some(cl_line), tell);
        }
    }

    /// The first point behind a way out, reached by this move: the axes that lower the tool move last.
    fn judge_approach(&mut self, it: &Move, file: &str, cl_line: u64, tell: &mut dyn FnMut(Diagnostic)) {
        let Some(at) = self.lowered_at.take() else { return };
        if it.named & !self.habit.last != 0 {
            let message = "the tool is lowered before the other axes are in place".to_owned();
            self.differ(Difference::WayOut, message, (file, at), Some(cl_line), tell);
        }
    }

    /// Whether a point lies on the arc that the tool is on, the axis as it is.
    fn is_on_arc(&self, it: &Move, motion: &Motion, there: Pose) -> bool {
        match it.law {
            Law::Arc(index) => self.tolerance.is_on_arc(motion.arc(index), there),
            _ => false,
        }
    }

    fn reached(&mut self, pose: Pose, there: Pose, line: u64) {
        let (tip_mm, axis_rad) = pose.apart(there);
        self.agreement.points += 1;
        self.agreement.tip_mm.meet(tip_mm, line);
        self.agreement.axis_rad.meet(axis_rad, line);
        self.at = Some(pose);
        self.may_approach = false;
        self.way_out.fill(None);
    }

    /// Points at which the tool already is need no block.
    fn pass_points_at_rest(&mut self, tell: &mut dyn FnMut(Diagnostic)) -> io::Result<()> {
        while let Some(Wanted { what: WantedWhat::Point { pose: there, .. }, .. }) = self.stream.peek(tell)?
            && self.at.is_some_and(|at| self.tolerance.is_same(at, there))
        {
            self.agreement.points += 1;
            self.stream.pass(1);
        }
        Ok(())
    }

    fn event(
        &mut self,
        event: Event,
        state: &State,
        program: (&str, u64),
        tell: &mut dyn FnMut(Diagnostic),
    ) -> io::Result<()> {
        self.pass_points_at_rest(tell)?;
        if matches!(event, Event::ToolChange(_) | Event::End) {
            self.judge_way_out(event, state, program, tell);
        }
        if event == Event::End {
            self.has_ended = true;
            return Ok(());
        }
        let wanted = self.stream.peek(tell)?;
        if wanted.is_some_and(|wanted| wanted.what == WantedWhat::Event(event)) {
            self.stream.pass(1);
            self.may_approach |= matches!(event, Event::ToolChange(_));
            return Ok(());
        }
        let later = self.stream.ahead(tell)?.position(|wanted| wanted.what == WantedWhat::Event(event));
        let message = match later {
            Some(_) => format!("{} comes before points of the CL that stand before it", named(event)),
            None => format!("the CL does not ask for {}", named(event)),
        };
        self.differ(Difference::Order, message, program, wanted.map(|wanted| wanted.line), tell);
        self.may_approach |= matches!(event, Event::ToolChange(_));
        Ok(())
    }

    /// Whether the tool has been taken out as the description does.
    fn judge_way_out(&mut self, event: Event, state: &State, program: (&str, u64), tell: &mut dyn FnMut(Diagnostic)) {
        let habit = &self.habit.way_out[usize::from(event == Event::End)];
        let is_out = habit.iter().zip(&self.way_out).all(|(habit, found)| match (habit, found) {
            (Some(wanted), Some(found)) => self.tolerance.is_same_word(*wanted, *found),
            (Some(_), None) => false,
            (None, _) => true,
        });
        if !is_out {
            let message = format!("{} comes while the tool is not at its way out", named(event));
            self.differ(Difference::WayOut, message, program, None, tell);
        }
        if self.habit.stops_spindle && state.spindle != Spindle::Off {
            let message = format!("{} comes while the spindle turns", named(event));
            self.differ(Difference::Spindle, message, program, None, tell);
        }
    }

    /// The state at a point that is reached.
    #[allow(clippy::too_many_arguments)]
    fn judge(
        &mut self,
        is_cut: bool,
        cuts: bool,
        wanted: &WantedState,
        state: &State,
        program: (&str, u64),
        line: u64,
        tell: &mut dyn FnMut(Diagnostic),
    ) {
        let [rapid, feed] = std::mem::take(&mut self.approach);
        if let Some(at) = if is_cut { rapid } else { feed }.filter(|_| is_cut == cuts) {
            let message = if is_cut { "the approach is in rapid traverse" } else { "the approach is at feed" };
            self.differ(Difference::Kind, message.to_owned(), (program.0, at), Some(line), tell);
        }
        let mut found: Vec<(Difference, String)> = Vec::new();
        if is_cut != cuts {
            let message = if cuts {
                "at feed, where the CL is in rapid traverse"
            } else {
                "in rapid traverse, where the CL cuts"
            };
            found.push((Difference::Kind, message.to_owned()));
        }
        found.extend(self.tool(is_cut, wanted, state).map(|message| (Difference::Tool, message)));
        found.extend(self.habitual(state).map(|message| (Difference::State, message)));
        if is_cut {
            found.extend(self.feed(wanted, state).map(|message| (Difference::Feed, message)));
            found.extend(spindle(wanted, state).map(|message| (Difference::Spindle, message)));
            let coolant = (wanted.coolant != state.coolant).then(|| "another coolant is on than in the CL".to_owned());
            found.extend(coolant.map(|message| (Difference::Coolant, message)));
        }
        self.told.retain(|told| *told == Difference::Kind || found.iter().any(|(difference, _)| difference == told));
        for (difference, message) in found {
            if difference == Difference::Kind || self.told.insert(difference) {
                self.differ(difference, message, program, Some(line), tell);
            }
        }
    }

    fn tool(&self, is_cut: bool, wanted: &WantedState, state: &State) -> Option<String> {
        let (tool, register) = wanted.tool?;
        if state.tool != Some(tool) {
            let found = state.tool.map_or("no tool".to_owned(), |tool| format!("tool {tool}"));
            return Some(format!("{found} is in the spindle, in the CL it is tool {tool}"));
        }
        let wanted_register =
            if self.habit.has_register_of_tool { Some(register) } else { self.habit.state.length_register };
        // The length comes with the last block of an approach, and a point may be reached before.
        if is_cut && state.length_register != wanted_register {
            let said = |register: Option<u32>| register.map_or("none".to_owned(), |register| register.to_string());
            let (found, wanted) = (said(state.length_register), said(wanted_register));
            return Some(format!("the length register is {found} instead of {wanted}"));
        }
        (state.offset != self.habit.state.offset).then(|| "another work offset is in force".to_owned())
    }

    /// What the head of a program sets by the description.
    fn habitual(&self, state: &State) -> Option<String> {
        let habit = &self.habit.state;
        if state.plane != habit.plane {
            return Some("another plane of arcs is in force".to_owned());
        }
        if state.path != habit.path {
            return Some("corners are passed in another way".to_owned());
        }
        (state.side != Side::Off).then(|| "the cutter's radius is compensated".to_owned())
    }

    fn feed(&self, wanted: &WantedState, state: &State) -> Option<String> {
        let same = match (wanted.feed, state.feed) {
            (None, _) => true,
            (Some(Feed::PerMinute(a)), Some(Feed::PerMinute(b))) => (a - b).abs() <= self.tolerance.feed_mm_per_min,
            (Some(Feed::PerRevolution(a)), Some(Feed::PerRevolution(b))) => {
                (a - b).abs() <= self.tolerance.feed_mm_per_rev
            }
            _ => false,
        };
        (!same).then(|| format!("the feed is {} instead of {}", fed(state.feed), fed(wanted.feed)))
    }

    fn differ(
        &mut self,
        difference: Difference,
        message: String,
        program: (&str, u64),
        cl_line: Option<u64>,
        tell: &mut dyn FnMut(Diagnostic),
    ) {
        self.agreement.differences += 1;
        if self.agreement.differences <= MOST_DIFFERENCES {
            tell(difference.diagnostic(message, program, cl_line.map(|line| (self.cl.as_str(), line))));
        }
    }
}

fn spindle(wanted: &WantedState, state: &State) -> Option<String> {
    if wanted.spindle != state.spindle {
        let doing = |spindle| match spindle {
            Spindle::Off => "stands",
            Spindle::Clockwise => "turns clockwise",
            Spindle::Counterclockwise => "turns counterclockwise",
        };
        return Some(format!("the spindle {}, in the CL it {}", doing(state.spindle), doing(wanted.spindle)));
    }
    let is_on = wanted.spindle != Spindle::Off;
    // Speeds are written as whole numbers.
    let differs = (wanted.speed_rpm - state.speed_rpm).abs() > 0.5;
    (is_on && differs).then(|| format!("the speed is {} instead of {}", state.speed_rpm, wanted.speed_rpm))
}

fn fed(feed: Option<Feed>) -> String {
    match feed {
        Some(Feed::PerMinute(value)) => format!("{value} mm/min"),
        Some(Feed::PerRevolution(value)) => format!("{value} mm/rev"),
        Some(Feed::Inverse(value)) => format!("{value} blocks a minute"),
        None => "nothing".to_owned(),
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

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { points, tip_mm, axis_rad, retracts, approaches, differences } = self;
        writeln!(f, "against the CL: {differences} differences")?;
        writeln!(
            f,
            "  {:<22}{points} points reached, {approaches} blocks of approaches, {retracts} to the way out",
            "toolpath"
        )?;
        writeln!(f, "  {:<22}{:.6} mm at line {}", "largest tip error", tip_mm.value, tip_mm.line)?;
        write!(f, "  {:<22}{:.6} deg at line {}", "largest axis error", axis_rad.value.to_degrees(), axis_rad.line)
    }
}
