//! What the CL has said and is in force, and what the placeholders of the blocks stand for with it.

use super::job::Job;
use crate::dialect::meaning::{Coolant, Spindle};
use crate::motion::Coolants;
use crate::nc::dialect::Trigger;
use crate::nc::writer::{SwitchesOff, Values};
use crate::toolpath::{Command, State};

#[derive(Debug, Default)]
pub(super) struct InForce {
    operation: String,
    tool_name: String,
    text: String,
    dwell_s: f64,
    state: State,
    /// What blocks for something else have switched off, and the CL has not.
    interrupted: Interrupted,
}

#[derive(Debug, Default)]
struct Interrupted {
    spindle: bool,
    coolant: Coolants,
}

impl InForce {
    /// Puts a command in force, and says what prints it: nothing for the tool that is in the spindle already.
    pub(super) fn take(&mut self, command: &Command) -> Option<Trigger> {
        if !self.state.take(command) {
            return None;
        }
        Some(match *command {
            Command::Operation { ref name, ref tool } => {
                (self.operation, self.tool_name) = (name.clone(), tool.clone());
                Trigger::Operation
            }
            Command::Tool { .. } => Trigger::Tool,
            Command::SpindleOn(..) | Command::SpindleOff => {
                self.interrupted.spindle = false;
                spindle(self.state.spindle)
            }
            Command::CoolantOn(kind) => {
                self.interrupted.coolant = self.interrupted.coolant.without(kind.into());
                coolant(kind.into())
            }
            Command::CoolantOff => {
                self.interrupted.coolant = Coolants::OFF;
                Trigger::CoolantOff
            }
            Command::Stop => Trigger::Stop,
            Command::OptionalStop => Trigger::OptionalStop,
            Command::Dwell(dwell_s) => {
                self.dwell_s = dwell_s;
                Trigger::Dwell
            }
            Command::Message(ref text) => {
                self.text.clone_from(text);
                Trigger::Message
            }
        })
    }

    /// Notes what a block has switched off that the CL has not.
    pub(super) fn interrupt(&mut self, off: SwitchesOff) {
        self.interrupted.spindle |= off.spindle && self.spindle_turns();
        if off.coolant {
            self.interrupted.coolant = self.state.coolant;
        }
    }

    /// What has to be switched on again before a cut, one after the other.
    pub(super) fn resume(&mut self) -> Option<Trigger> {
        if std::mem::take(&mut self.interrupted.spindle) {
            return Some(spindle(self.state.spindle));
        }
        let next = self.interrupted.coolant.iter().next()?;
        self.interrupted.coolant = self.interrupted.coolant.without(next);
        Some(coolant(next))
    }

    /// Whether the CL lets the spindle turn.
    pub(super) fn spindle_turns(&self) -> bool {
        self.state.spindle != Spindle::Off
    }

    /// What the placeholders stand for.
    pub(super) fn values<'a>(&'a self, job: Job<'a>) -> Values<'a> {
        Values {
            program: job.program,
            machine: &job.machine.name,
            operation: &self.operation,
            tool_name: &self.tool_name,
            text: &self.text,
            tool: self.state.tool,
            speed_rpm: self.state.speed_rpm,
            dwell_s: self.dwell_s,
        }
    }
}

fn spindle(spindle: Spindle) -> Trigger {
    match spindle {
        Spindle::Off => Trigger::SpindleOff,
        Spindle::Clockwise => Trigger::SpindleClockwise,
        Spindle::Counterclockwise => Trigger::SpindleCounterclockwise,
    }
}

fn coolant(coolant: Coolant) -> Trigger {
    match coolant {
        Coolant::Off => Trigger::CoolantOff,
        Coolant::Flood => Trigger::CoolantFlood,
        Coolant::Mist => Trigger::CoolantMist,
        Coolant::Through => Trigger::CoolantThrough,
    }
}
