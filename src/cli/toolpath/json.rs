//! An item of a toolpath as a JSON object. `docs/models.md` tells what stands in it.

use mach_runtime::place::Frame;
use mach_runtime::toolpath::{Approach, Command, Coolant, Item, Point, Spindle, What};
use serde::Serialize;

use super::super::in_force::InForce;
use super::super::unsigned_zero::unsigned_zero;

#[derive(Serialize)]
pub(super) struct Message<'a> {
    #[serde(flatten)]
    what: Kind<'a>,
    line: u64,
    state: InForce,
}

#[derive(Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
enum Kind<'a> {
    Rapid(Pose),
    Line(Pose),
    From(Pose),
    Frame { origin_mm: [f64; 3], x: [f64; 3], y: [f64; 3] },
    Operation { name: &'a str, tool_name: &'a str },
    Tool { number: u64, register: Option<u64> },
    Spindle { turns: &'static str, speed_rpm: Option<f64> },
    Coolant { coolant: &'static str },
    Stop,
    OptionalStop,
    Dwell { seconds: f64 },
    Text { text: &'a str },
}

#[derive(Serialize)]
struct Pose {
    tip_mm: [f64; 3],
    axis: [f64; 3],
}

impl<'a> Message<'a> {
    pub(super) fn new(item: &'a Item) -> Self {
        Self { what: Kind::of(&item.what), line: item.line, state: InForce::new(&item.state.into()) }
    }
}

impl<'a> Kind<'a> {
    fn of(what: &'a What) -> Self {
        match what {
            What::Point(point) => match point.approach {
                Approach::Rapid => Self::Rapid(Pose::of(point)),
                Approach::Feed(_) => Self::Line(Pose::of(point)),
            },
            What::From(point) => Self::From(Pose::of(point)),
            What::Frame(frame) => Self::frame(frame),
            What::Command(command) => Self::command(command),
        }
    }

    fn frame(frame: &Frame) -> Self {
        let [origin_mm, x, y] = [frame.origin_mm(), frame.x(), frame.y()].map(unsigned_zero);
        Self::Frame { origin_mm, x, y }
    }

    fn command(command: &'a Command) -> Self {
        let coolant = |coolant| Self::Coolant { coolant };
        let spindle = |turns, speed_rpm| Self::Spindle { turns, speed_rpm };
        match *command {
            Command::Operation { ref name, ref tool } => Self::Operation { name, tool_name: tool },
            Command::Tool { number, register } => Self::Tool { number, register },
            Command::SpindleOn(Spindle::Clockwise, speed_rpm) => spindle("clockwise", Some(speed_rpm)),
            Command::SpindleOn(Spindle::Counterclockwise, speed_rpm) => spindle("counterclockwise", Some(speed_rpm)),
            Command::SpindleOff => spindle("off", None),
            Command::CoolantOn(Coolant::Flood) => coolant("flood"),
            Command::CoolantOn(Coolant::Mist) => coolant("mist"),
            Command::CoolantOn(Coolant::Through) => coolant("through"),
            Command::CoolantOff => coolant("off"),
            Command::Stop => Self::Stop,
            Command::OptionalStop => Self::OptionalStop,
            Command::Dwell(seconds) => Self::Dwell { seconds },
            Command::Message(ref text) => Self::Text { text },
        }
    }
}

impl Pose {
    fn of(point: &Point) -> Self {
        Self { tip_mm: unsigned_zero(point.tip_mm), axis: unsigned_zero(point.axis) }
    }
}
