//! What is in force, as JSON, for motion and toolpath.

use mach_runtime::dialect::meaning::Meaning;
use mach_runtime::dialect::names::name;
use mach_runtime::motion::{Feed, State};
use serde::Serialize;

/// What both models have.
#[derive(Serialize)]
pub(super) struct InForce {
    tool: Option<u32>,
    length_register: Option<u32>,
    spindle: Option<&'static str>,
    speed_rpm: f64,
    feed: Option<FeedMessage>,
    coolant: Vec<&'static str>,
}

/// The unit is the key.
#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum FeedMessage {
    MmPerMin(f64),
    MmPerRev(f64),
    BlocksPerMin(f64),
}

impl InForce {
    pub(super) fn new(state: &State) -> Self {
        Self {
            tool: state.tool,
            length_register: state.length_register,
            spindle: name(Meaning::Spindle(state.spindle)),
            speed_rpm: state.speed_rpm,
            feed: state.feed.map(|feed| match feed {
                Feed::PerMinute(mm) => FeedMessage::MmPerMin(mm),
                Feed::PerRevolution(mm) => FeedMessage::MmPerRev(mm),
                Feed::Inverse(blocks) => FeedMessage::BlocksPerMin(blocks),
            }),
            coolant: state.coolant.iter().filter_map(|coolant| name(Meaning::Coolant(coolant))).collect(),
        }
    }
}
