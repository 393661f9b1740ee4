//! What the CL has said and is in force, and what the placeholders of the blocks stand for with it.

use super::job::Job;
use crate::cl::event::{Command, Coolant, Spindle};
use crate::nc::dialect::Trigger;
use crate::nc::writer::{LoadedTool, SwitchesOff, Values};
use std::mem;

#[derive(Debug, Default)]
pub(super) struct InForce {
    operation: String,
    tool_name: String,
    text: String,
    tool: Option<LoadedTool>,
    spindle: Option<Switched>,
    coolant: Option<Switched>,
    speed_rpm: f64,
    dwell_s: f64,
}

/// What the CL has switched on.
#[derive(Debug)]
struct Switched {
    /// What switches it on.
    on: Trigger,
    /// Whether a block for something else has switched it off.
    is_interrupted: bool,
}

impl Switched {
    fn on(on: Trigger) -> Self {
        Self { on, is_interrupted: false }
    }
}

impl InForce {
    /// Puts a command in force, and says what prints it: nothing for the tool that is in the spindle already.
    pub(super) fn take(&mut self, command: Command) -> Option<Trigger> {
        Some(match command {
            Command::Operation { name, tool } => {
                (self.operation, self.tool_name) = (name, tool);
                Trigger::Operation
            }
            Command::Tool { number, register } => {
                let tool = Some(LoadedTool { number, register: register.unwrap_or(number) });
                return (mem::replace(&mut self.tool, tool) != tool).then_some(Trigger::Tool);
            }
            Command::SpindleOn(direction, speed_rpm) => {
                self.speed_rpm = speed_rpm;
                self.spindle.insert(Switched::on(spindle(direction))).on
            }
            Command::SpindleOff => {
                self.spindle = None;
                Trigger::SpindleOff
            }
            Command::CoolantOn(kind) => self.coolant.insert(Switched::on(coolant(kind))).on,
            Command::CoolantOff => {
                self.coolant = None;
                Trigger::CoolantOff
            }
            Command::Stop => Trigger::Stop,
            Command::OptionalStop => Trigger::OptionalStop,
            Command::Dwell(dwell_s) => {
                self.dwell_s = dwell_s;
                Trigger::Dwell
            }
            Command::Message(text) => {
                self.text = text;
                Trigger::Message
            }
        })
    }

    /// Notes what a block has switched off that the CL has not.
    pub(super) fn interrupt(&mut self, off: SwitchesOff) {
        let switched =
            self.spindle.iter_mut().filter(|_| off.spindle).chain(self.coolant.iter_mut().filter(|_| off.coolant));
        switched.for_each(|switched| switched.is_interrupted = true);
    }

    /// What has to be switched on again before a cut, one after the other.
    pub(super) fn resume(&mut self) -> Option<Trigger> {
        let switched = [&mut self.spindle, &mut self.coolant].into_iter().flatten();
        let interrupted = switched.into_iter().find(|switched| switched.is_interrupted)?;
        interrupted.is_interrupted = false;
        Some(interrupted.on)
    }

    /// Whether the CL lets the spindle turn.
    pub(super) fn spindle_turns(&self) -> bool {
        self.spindle.is_some()
    }

    /// What the placeholders stand for.
    pub(super) fn values<'a>(&'a self, job: Job<'a>) -> Values<'a> {
        Values {
            program: job.program,
            machine: &job.machine.name,
            operation: &self.operation,
            tool_name: &self.tool_name,
            text: &self.text,
            tool: self.tool,
            speed_rpm: self.speed_rpm,
            dwell_s: self.dwell_s,
        }
    }
}

fn spindle(direction: Spindle) -> Trigger {
    match direction {
        Spindle::Clockwise => Trigger::SpindleClockwise,
        Spindle::Counterclockwise => Trigger::SpindleCounterclockwise,
    }
}

fn coolant(kind: Coolant) -> Trigger {
    match kind {
        Coolant::Flood => Trigger::CoolantFlood,
        Coolant::Mist => Trigger::CoolantMist,
        Coolant::Through => Trigger::CoolantThrough,
    }
}
