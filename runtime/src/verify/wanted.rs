//! What the CL wants, one after the other, everything resolved.

use super::pose::Pose;
use crate::cl::{Reader, Toolpath};
use crate::coordinates::in_machine_frame;
use crate::diagnostic::{Diagnostic, Severity};
use crate::machine::Machine;
use crate::motion::{Event, State};
use crate::toolpath::{self, Approach, Command, Item, LoadedTool, Point, What};
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
    Point { pose: Pose, is_cut: bool, state: State },
    Event(Event),
}

/// The CL as it is read.
pub(super) struct WantedStream<'a> {
    toolpath: Toolpath<Box<dyn Read + 'a>>,
    machine: &'a Machine,
    queue: VecDeque<Wanted>,
    tool: Option<LoadedTool>,
    has_ended: bool,
    pub(super) has_errors: bool,
    /// What is to be told of it.
    pub(super) diagnostics: Vec<Diagnostic>,
}

impl<'a> WantedStream<'a> {
    pub(super) fn new(reader: Reader<Box<dyn Read + 'a>>, machine: &'a Machine) -> Self {
        let (toolpath, queue, diagnostics) = (Toolpath::new(reader), VecDeque::new(), Vec::new());
        Self { toolpath, machine, queue, tool: None, has_ended: false, has_errors: false, diagnostics }
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
            match self.toolpath.next_item()? {
                Some(Ok(item)) => {
                    let what = self.wanted(&item);
                    self.queue.extend(what.map(|what| Wanted { line: item.line, what }));
                }
                Some(Err(diagnostic)) => {
                    self.has_errors |= diagnostic.severity == Severity::Error;
                    self.diagnostics.push(diagnostic);
                }
                None => self.has_ended = true,
            }
        }
        Ok(())
    }

    fn wanted(&mut self, item: &Item) -> Option<WantedWhat> {
        match &item.what {
            What::Point(Point { tip_mm, axis, approach, .. }) => {
                let pose = Pose { tip_mm: in_machine_frame(self.machine, *tip_mm), axis: *axis };
                let is_cut = matches!(approach, Approach::Feed(_));
                Some(WantedWhat::Point { pose, is_cut, state: item.state.into() })
            }
            What::Command(command) => self.event(command, &item.state).map(WantedWhat::Event),
            What::From(_) | What::Frame(_) => None,
        }
    }

    fn event(&mut self, command: &Command, state: &toolpath::State) -> Option<Event> {
        match command {
            Command::Tool { number, .. } => {
                // The tool that is in the spindle is not changed for itself.
                let before = std::mem::replace(&mut self.tool, state.tool);
                (before != state.tool).then_some(Event::ToolChange(*number as u32))
            }
            Command::Stop => Some(Event::Stop),
            Command::OptionalStop => Some(Event::OptionalStop),
            Command::Dwell(seconds) => Some(Event::Dwell(*seconds)),
            Command::SpindleOn(..) | Command::SpindleOff | Command::CoolantOn(_) | Command::CoolantOff => None,
            Command::Operation { .. } | Command::Message(_) => None,
        }
    }
}
