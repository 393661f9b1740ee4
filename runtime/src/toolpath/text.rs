//! A toolpath as text, one item a line, for people's eyes and for differences.

use super::command::{Command, Coolant, Spindle};
use super::item::{Item, What};
use super::point::{Approach, Point};
use crate::motion::InForce;
use crate::number::{fixed, short};
use crate::place::Frame;
use crate::vector::Vec3;

/// How a toolpath is written: the decimals of millimetres. A tool axis has three more of them.
///
/// A line holds what happens, where the tip and the tool axis are then in the frame of the program zero, and what is in force.
#[derive(Debug, Clone, Copy)]
pub struct ToolpathText {
    decimals: usize,
}

impl ToolpathText {
    /// Decimals that tell the numbers of usual CL files from each other.
    pub const DECIMALS: usize = 4;

    /// With so many decimals.
    pub fn new(decimals: usize) -> Self {
        Self { decimals }
    }

    /// What stands above the columns.
    pub fn head(&self) -> String {
        let column = |name: &&str| format!("{name:>width$}", width = self.width());
        let columns: String = ["X", "Y", "Z", "I", "J", "K"].iter().map(column).collect();
        format!("{:>7}  {:<6}{columns}  in force", "line", "what")
    }

    /// One item.
    pub fn line(&self, item: &Item) -> String {
        let what = match &item.what {
            What::Point(point) => self.point(point, item),
            What::From(Point { tip_mm, axis, .. }) => format!("{:<6}{}", "from", self.pose(*tip_mm, *axis)),
            What::Frame(frame) => self.frame(frame),
            What::Command(command) => self.command(command),
        };
        format!("{:>7}  {what}", item.line)
    }

    fn width(&self) -> usize {
        self.decimals + 7
    }

    fn point(&self, point: &Point, item: &Item) -> String {
        let (name, is_at_feed) = match point.approach {
            Approach::Rapid => ("rapid", false),
            Approach::Feed(_) => ("line", true),
        };
        let state = item.state.into();
        let in_force = InForce { state: &state, is_at_feed, decimals: self.decimals };
        format!("{name:<6}{} {in_force}", self.pose(point.tip_mm, point.axis)).trim_end().to_owned()
    }

    fn pose(&self, tip_mm: Vec3, axis: Vec3) -> String {
        let width = self.width();
        let tip: String = tip_mm.iter().map(|mm| format!("{:>width$}", fixed(*mm, self.decimals))).collect();
        let axis = axis.iter().map(|part| format!("{:>width$}", fixed(*part, self.decimals + 3)));
        tip + &axis.collect::<String>()
    }

    fn frame(&self, frame: &Frame) -> String {
        let part = |vector: Vec3, decimals| vector.map(|part| short(part, decimals)).join(" ");
        let [x, y] = [frame.x(), frame.y()].map(|direction| part(direction, self.decimals + 3));
        format!("frame at {} with X along {x} and Y along {y}", part(frame.origin_mm(), self.decimals))
    }

    fn command(&self, command: &Command) -> String {
        let number = |value: f64| short(value, self.decimals);
        match command {
            Command::Operation { name, tool } if tool.is_empty() => format!("operation {name}"),
            Command::Operation { name, tool } => format!("operation {name} with {tool}"),
            Command::Tool { number, register: None } => format!("tool {number}"),
            Command::Tool { number, register: Some(register) } => format!("tool {number} with register {register}"),
            Command::SpindleOn(Spindle::Clockwise, speed_rpm) => format!("spindle {} cw", number(*speed_rpm)),
            Command::SpindleOn(Spindle::Counterclockwise, speed_rpm) => format!("spindle {} ccw", number(*speed_rpm)),
            Command::SpindleOff => "spindle off".to_owned(),
            Command::CoolantOn(Coolant::Flood) => "coolant flood".to_owned(),
            Command::CoolantOn(Coolant::Mist) => "coolant mist".to_owned(),
            Command::CoolantOn(Coolant::Through) => "coolant through".to_owned(),
            Command::CoolantOff => "coolant off".to_owned(),
            Command::Stop => "stop".to_owned(),
            Command::OptionalStop => "optional stop".to_owned(),
            Command::Dwell(seconds) => format!("dwell {} s", number(*seconds)),
            Command::Message(text) => format!("text {text}"),
        }
    }
}
