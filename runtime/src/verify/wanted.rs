//! What the CL wants, one after the other, everything resolved.

use super::pose::Pose;
use crate::cl::event::{Approach, Command, Feed as ClFeed, Point, Spindle as Turns};
use crate::cl::{Next, Reader};
use crate::coordinates::in_machine_frame;
use crate::diagnostic::{Diagnostic, Severity};
use crate::dialect::meaning::{Coolant, Spindle};
use crate::machine::Machine;
use crate::motion::{Coolants, Event, Feed};
use std::collections::VecDeque;
use std::io::{self, Read};

/// How far ahead the CL is read to find out where a program that differs goes on.
pub(super) const AHEAD: usize = 256;

/// A point or an event of the CL, and its line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Wanted {
    pub(super) line: u64,
    pub(super) what: WantedWhat,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum WantedWhat {
    Point { pose: Pose, is_cut: bool, state: WantedState },
    Event(Event),
}

/// What is to be in force at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct WantedState {
    /// The tool and its length register, once one is loaded.
    pub(super) tool: Option<(u32, u32)>,
    pub(super) spindle: Spindle,
    pub(super) speed_rpm: f64,
    pub(super) coolant: Coolants,
    pub(super) feed: Option<Feed>,
}

/// The CL as it is read.
pub(super) struct WantedStream<'a> {
    reader: Reader<Box<dyn Read + 'a>>,
    machine: &'a Machine,
    points: Vec<Point>,
    queue: VecDeque<Wanted>,
    state: WantedState,
    has_ended: bool,
    pub(super) has_errors: bool,
    /// What is to be told of it.
    pub(super) diagnostics: Vec<Diagnostic>,
}

impl<'a> WantedStream<'a> {
    pub(super) fn new(reader: Reader<Box<dyn Read + 'a>>, machine: &'a Machine) -> Self {
        let state =
            WantedState { tool: None, spindle: Spindle::Off, speed_rpm: 0.0, coolant: Coolants::OFF, feed: None };
        let (points, queue) = (Vec::new(), VecDeque::new());
        Self { reader, machine, points, queue, state, has_ended: false, has_errors: false, diagnostics: Vec::new() }
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

    /// Goes on by so many.
    pub(super) fn pass(&mut self, count: usize) {
        self.queue.drain(..count);
    }

    fn fill(&mut self, count: usize) -> io::Result<()> {
        while self.queue.len() < count && !self.has_ended {
            self.points.clear();
            let next = self.reader.next_into(&mut self.points, AHEAD)?;
            let points = std::mem::take(&mut self.points);
            for point in &points {
                let wanted = self.point(point);
                self.queue.push_back(wanted);
            }
            self.points = points;
            match next {
                Next::Full | Next::From(_) => {}
                Next::Command(command, place) => self.command(command, place.line),
                Next::Diagnostic(diagnostic) => {
                    self.has_errors |= diagnostic.severity == Severity::Error;
                    self.diagnostics.push(diagnostic);
                }
                Next::End => self.has_ended = true,
            }
        }
        Ok(())
    }

    fn point(&mut self, point: &Point) -> Wanted {
        let is_cut = match point.approach {
            Approach::Rapid => false,
            Approach::Feed(feed) => {
                self.state.feed = feed.map(|feed| match feed {
                    ClFeed::PerMinute(mm_per_min) => Feed::PerMinute(mm_per_min),
                    ClFeed::PerRevolution(mm_per_rev) => Feed::PerRevolution(mm_per_rev),
                });
                true
            }
        };
        let pose = Pose { tip_mm: in_machine_frame(self.machine, point.tip_mm), axis: point.axis };
        Wanted { line: point.line, what: WantedWhat::Point { pose, is_cut, state: self.state } }
    }

    fn command(&mut self, command: Command, line: u64) {
        let state = &mut self.state;
        let event = match command {
            Command::Tool { number, register } => {
                let tool = (number as u32, register.unwrap_or(number) as u32);
                // The tool that is in the spindle is not changed for itself.
                (state.tool.replace(tool) != Some(tool)).then_some(Event::ToolChange(tool.0))
            }
            Command::SpindleOn(turns, speed_rpm) => {
                state.speed_rpm = speed_rpm;
                state.spindle = match turns {
                    Turns::Clockwise => Spindle::Clockwise,
                    Turns::Counterclockwise => Spindle::Counterclockwise,
                };
                None
            }
            Command::SpindleOff => {
                state.spindle = Spindle::Off;
                None
            }
            Command::CoolantOn(coolant) => {
                state.coolant = state.coolant.with(switched(coolant));
                None
            }
            Command::CoolantOff => {
                state.coolant = Coolants::OFF;
                None
            }
            Command::Stop => Some(Event::Stop),
            Command::OptionalStop => Some(Event::OptionalStop),
            Command::Dwell(seconds) => Some(Event::Dwell(seconds)),
            Command::Operation { .. } | Command::Message(_) => None,
        };
        self.queue.extend(event.map(|event| Wanted { line, what: WantedWhat::Event(event) }));
    }
}

fn switched(coolant: crate::cl::event::Coolant) -> Coolant {
    use crate::cl::event::Coolant as Cl;
    match coolant {
        Cl::Flood => Coolant::Flood,
        Cl::Mist => Coolant::Mist,
        Cl::Through => Coolant::Through,
    }
}
