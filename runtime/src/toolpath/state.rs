//! What a toolpath has in force.

use super::command::{Command, Coolant, Spindle};
use super::point::{Approach, Feed, Point};
use crate::dialect::meaning;
use crate::motion::{self, Coolants};

/// The tool in the spindle, as the control knows it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LoadedTool {
    /// Its number.
    pub number: u64,
    /// Its length register.
    pub register: u64,
}

/// What is in force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// The tool in the spindle, once one is loaded.
    pub tool: Option<LoadedTool>,
    /// The spindle.
    pub spindle: meaning::Spindle,
    /// Its speed in revolutions a minute; zero while nobody has said.
    pub speed_rpm: f64,
    /// The coolants that are on.
    pub coolant: Coolants,
    /// The feed of the last point at feed, if it has one.
    pub feed: Option<Feed>,
}

impl Default for State {
    fn default() -> Self {
        Self { tool: None, spindle: meaning::Spindle::Off, speed_rpm: 0.0, coolant: Coolants::OFF, feed: None }
    }
}

impl State {
    /// Puts a command in force. Says whether there is anything to do for it: nothing for the tool that is in the spindle already.
    pub fn take(&mut self, command: &Command) -> bool {
        match *command {
            Command::Tool { number, register } => {
                let tool = LoadedTool { number, register: register.unwrap_or(number) };
                return self.tool.replace(tool) != Some(tool);
            }
            Command::SpindleOn(spindle, speed_rpm) => (self.spindle, self.speed_rpm) = (spindle.into(), speed_rpm),
            Command::SpindleOff => self.spindle = meaning::Spindle::Off,
            Command::CoolantOn(coolant) => self.coolant = self.coolant.with(coolant.into()),
            Command::CoolantOff => self.coolant = Coolants::OFF,
            Command::Operation { .. }
            | Command::Stop
            | Command::OptionalStop
            | Command::Dwell(_)
            | Command::Message(_) => {}
        }
        true
    }

    /// Puts in force what a point brings along.
    pub fn go(&mut self, point: &Point) {
        if let Approach::Feed(feed) = point.approach {
            self.feed = feed;
        }
    }
}

impl From<Spindle> for meaning::Spindle {
    fn from(spindle: Spindle) -> Self {
        match spindle {
            Spindle::Clockwise => Self::Clockwise,
            Spindle::Counterclockwise => Self::Counterclockwise,
        }
    }
}

impl From<Coolant> for meaning::Coolant {
    fn from(coolant: Coolant) -> Self {
        match coolant {
            Coolant::Flood => Self::Flood,
            Coolant::Mist => Self::Mist,
            Coolant::Through => Self::Through,
        }
    }
}

impl From<Feed> for motion::Feed {
    fn from(feed: Feed) -> Self {
        match feed {
            Feed::PerMinute(mm_per_min) => Self::PerMinute(mm_per_min),
            Feed::PerRevolution(mm_per_rev) => Self::PerRevolution(mm_per_rev),
        }
    }
}

impl From<State> for motion::State {
    /// As far as a toolpath has a say in it.
    fn from(state: State) -> Self {
        let State { tool, spindle, speed_rpm, coolant, feed } = state;
        Self {
            tool: tool.map(|tool| tool.number as u32),
            length_register: tool.map(|tool| tool.register as u32),
            spindle,
            speed_rpm,
            coolant,
            feed: feed.map(Into::into),
            ..Self::default()
        }
    }
}
