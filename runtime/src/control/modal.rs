//! What a control remembers from block to block.

use crate::dialect::meaning::{CentreMode, Distance, FeedMode, Meaning, MotionCode, Plane, Switch};
use crate::motion::State;
use crate::unit::LengthUnit;

/// What is modal. Everything is `None` that no block has said and the dialect does not say of the control when it is switched
/// on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Modal {
    /// How axis words are gone to.
    pub motion: Option<MotionCode>,
    /// The plane of arcs.
    pub plane: Option<Plane>,
    /// What axis words count from.
    pub distance: Option<Distance>,
    /// The unit of lengths.
    pub units: Option<LengthUnit>,
    /// What the feed word counts.
    pub feed_mode: Option<FeedMode>,
    /// Where centre words count from.
    pub centre: Option<CentreMode>,
    /// A turned plane.
    pub frame: Option<Switch>,
    /// Canned cycles.
    pub cycle: Option<Switch>,
    /// The centre of arcs that has been said before them, along X, Y and Z, in machine coordinates.
    pub pole: [Option<f64>; 3],
    /// The last feed word, as it is written.
    pub feed: Option<f64>,
    /// The tool that comes with the next tool change.
    pub called_tool: Option<u32>,
    /// What also matters to the motion.
    pub state: State,
}

impl Modal {
    /// Takes a modal code over; codes that are not modal change nothing.
    pub(super) fn take(&mut self, meaning: Meaning, number: Option<u32>) {
        match meaning {
            Meaning::Motion(code) => self.motion = Some(code),
            Meaning::Plane(plane) => (self.plane, self.state.plane) = (Some(plane), plane),
            Meaning::Distance(distance) => self.distance = Some(distance),
            Meaning::Units(units) => self.units = Some(units),
            Meaning::FeedMode(mode) => {
                // A feed in another unit is another feed.
                if self.feed_mode != Some(mode) {
                    self.feed = None;
                }
                self.feed_mode = Some(mode);
            }
            Meaning::Centre(centre) => self.centre = Some(centre),
            Meaning::Side(side) => self.state.side = side,
            Meaning::Offset => self.state.offset = number,
            Meaning::Length(Switch::On) => self.state.length_register = Some(number.unwrap_or(0)),
            Meaning::Length(Switch::Off) => self.state.length_register = None,
            Meaning::Tip(switch) => self.state.tip = switch == Switch::On,
            Meaning::Frame(switch) => self.frame = Some(switch),
            Meaning::Cycle(switch) => self.cycle = Some(switch),
            Meaning::Path(path) => self.state.path = Some(path),
            Meaning::Wrap(wrap) => self.state.wrap = Some(wrap),
            Meaning::Spindle(spindle) => self.state.spindle = spindle,
            Meaning::Coolant(coolant) => self.state.coolant = self.state.coolant.with(coolant),
            Meaning::Once(_) | Meaning::Plain => {}
        }
    }
}
