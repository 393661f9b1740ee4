//! What is in force while an item of motion runs.

use crate::dialect::meaning::{Coolant, PathMode, Plane, Side, Spindle, Wrap};

/// What is in force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// The tool in the spindle; `None` while nobody has said.
    pub tool: Option<u32>,
    /// The register of the length compensation; `None` while it is off.
    pub length_register: Option<u32>,
    /// Whether the tip follows the program (TCP).
    pub tip: bool,
    /// The number of the work offset; `None` while nobody has said.
    pub offset: Option<u32>,
    /// The compensation of the cutter's radius.
    pub side: Side,
    /// The plane of arcs.
    pub plane: Plane,
    /// How corners are passed; `None` while nobody has said.
    pub path: Option<PathMode>,
    /// How words of rotary axes within a turn are taken; `None` while nobody has said.
    pub wrap: Option<Wrap>,
    /// The spindle.
    pub spindle: Spindle,
    /// Its speed in revolutions a minute; zero while nobody has said.
    pub speed_rpm: f64,
    /// The coolants that are on.
    pub coolant: Coolants,
    /// The feed of moves at feed; `None` while nobody has said.
    pub feed: Option<Feed>,
}

/// A feed rate in metric units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Feed {
    /// Millimetres a minute (degrees a minute where only rotary axes move).
    PerMinute(f64),
    /// Millimetres a revolution.
    PerRevolution(f64),
    /// Blocks a minute: one over the time of the block.
    Inverse(f64),
}

/// A set of coolants.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Coolants(u8);

impl Coolants {
    /// None of them.
    pub const OFF: Self = Self(0);

    /// With this one on; [`Coolant::Off`] switches all of them off.
    #[must_use]
    pub fn with(self, coolant: Coolant) -> Self {
        match coolant {
            Coolant::Off => Self::OFF,
            Coolant::Flood => Self(self.0 | 1),
            Coolant::Mist => Self(self.0 | 2),
            Coolant::Through => Self(self.0 | 4),
        }
    }

    /// With this one off.
    #[must_use]
    pub fn without(self, coolant: Coolant) -> Self {
        Self(self.0 & !Self::OFF.with(coolant).0)
    }

    /// Those that are on.
    pub fn iter(self) -> impl Iterator<Item = Coolant> {
        [Coolant::Flood, Coolant::Mist, Coolant::Through]
            .into_iter()
            .filter(move |one| Self::OFF.with(*one).0 & self.0 != 0)
    }
}

impl Default for State {
    /// What is in force before the first block: nobody has said anything, and everything that turns or flows is off.
    fn default() -> Self {
        Self {
            tool: None,
            length_register: None,
            tip: false,
            offset: None,
            side: Side::Off,
            plane: Plane::Xy,
            path: None,
            wrap: None,
            spindle: Spindle::Off,
            speed_rpm: 0.0,
            coolant: Coolants::OFF,
            feed: None,
        }
    }
}
