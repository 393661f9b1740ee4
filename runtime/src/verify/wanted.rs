//! What the CL wants, one after the other, everything resolved.

use super::pose::Pose;
use crate::cl::Reader;
use crate::coordinates::in_machine_frame;
use crate::diagnostic::{Diagnostic, Severity};
use crate::machine::Machine;
use crate::motion::{Event, State};
use crate::road::{Traveller, stage};
use crate::toolpath::{self, Approach, Command, Point};
use std::collections::VecDeque;
use std::io::{self, Read};

/// How far ahead the CL is read to find out where a program that differs goes on.
pub(super) const AHEAD: usize = 256;

/// A point or an event of the CL, and its line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Wanted {
    pub(super) line: u64,
    pub(super) what: WantedWhat,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum WantedWhat {
    /// With the index of the state that is to be in force there.
    Point {
        pose: Pose,
        is_cut: bool,
        state: u32,
    },
    Event(Event),
}

/// The CL as it is read.
pub(crate) struct WantedStream<'a> {
    /// `None` for a CL that is handed over piece by piece.
    reader: Option<Reader<Box<dyn Read + 'a>>>,
    machine: &'a Machine,
    points: Vec<Point>,
    queue: VecDeque<Wanted>,
    state: toolpath::State,
    /// The states at the points of the queue, as they are and as a control has them; the last one is that of the last point.
    states: Vec<(toolpath::State, State)>,
    has_ended: bool,
    pub(super) has_errors: bool,
    /// What is to be told of it.
    pub(super) diagnostics: Vec<Diagnostic>,
}

impl<'a> WantedStream<'a> {
    pub(super) fn new(reader: Reader<Box<dyn Read + 'a>>, machine: &'a Machine) -> Self {
        Self { reader: Some(reader), ..Self::in_pieces(machine) }
    }

    /// A CL that is handed over piece by piece.
    pub(super) fn in_pieces(machine: &'a Machine) -> Self {
        Self {
            reader: None,
            machine,
            points: Vec::new(),
            queue: VecDeque::new(),
            state: toolpath::State::default(),
            states: Vec::new(),
            has_ended: false,
            has_errors: false,
            diagnostics: Vec::new(),
        }
    }

    /// Whether it is handed over piece by piece.
    pub(super) fn is_in_pieces(&self) -> bool {
        self.reader.is_none()
    }

    /// What comes next.
    pub(super) fn peek(&mut self) -> io::Result<Option<Wanted>> {
        self.fill(1)?;
        Ok(self.queue.front().copied())
    }

    /// What comes next, as far ahead as it is looked at.
    pub(super) fn ahead(&mut self) -> io::Result<impl Iterator<Item = &Wanted>> {
        self.fill(AHEAD)?;
        Ok(self.queue.iter().take(AHEAD))
    }

    /// The state with this index.
    pub(super) fn state(&self, index: u32) -> State {
        self.states[index as usize].1
    }

    /// Goes on by so many.
    pub(super) fn pass(&mut self, count: usize) {
        self.queue.drain(..count);
    }

    fn fill(&mut self, count: usize) -> io::Result<()> {
        while self.queue.len() < count
            && !self.has_ended
            && let Some(mut reader) = self.reader.take()
        {
            let mut points = std::mem::take(&mut self.points);
            let goes_on = stage(&mut reader, &mut points, self);
            (self.reader, self.points) = (Some(reader), points);
            self.has_ended = !goes_on?;
        }
        Ok(())
    }

    fn point(&mut self, point: &Point) -> Wanted {
        self.state.go(point);
        if self.states.last().is_none_or(|(state, _)| *state != self.state) {
            self.states.push((self.state, self.state.into()));
        }
        let pose = Pose { tip_mm: in_machine_frame(self.machine, point.tip_mm), axis: point.axis };
        let is_cut = matches!(point.approach, Approach::Feed(_));
        let state = self.states.len() as u32 - 1;
        Wanted { line: point.line, what: WantedWhat::Point { pose, is_cut, state } }
    }

    fn event(&mut self, command: &Command) -> Option<Event> {
        // The tool that is in the spindle is not changed for itself.
        let is_new = self.state.take(command);
        match command {
            Command::Tool { number, .. } => is_new.then_some(Event::ToolChange(*number as u32)),
            Command::Stop => Some(Event::Stop),
            Command::OptionalStop => Some(Event::OptionalStop),
            Command::Dwell(seconds) => Some(Event::Dwell(*seconds)),
            Command::SpindleOn(..) | Command::SpindleOff | Command::CoolantOn(_) | Command::CoolantOff => None,
            Command::Operation { .. } | Command::Message(_) => None,
        }
    }
}

/// What it meets is wanted from here on.
impl Traveller for WantedStream<'_> {
    fn go(&mut self, points: &[Point]) {
        if self.queue.is_empty() {
            self.states.clear();
        }
        for point in points {
            let wanted = self.point(point);
            self.queue.push_back(wanted);
        }
    }

    /// No motion leads there.
    fn stand_at(&mut self, _point: &Point) {}

    fn carry_out(&mut self, command: &Command, line: u64) {
        let event = self.event(command);
        self.queue.extend(event.map(|event| Wanted { line, what: WantedWhat::Event(event) }));
    }

    fn hear(&mut self, diagnostic: Diagnostic) {
        self.has_errors |= diagnostic.severity == Severity::Error;
        self.diagnostics.push(diagnostic);
    }
}
