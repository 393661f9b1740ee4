//! Motion as text, one item a line, for people's eyes and for differences.

use super::{Arc, Event, Feed, Item, Law, Motion, Move, State, What};
use crate::dialect::meaning::{Meaning, Plane, Side, Spindle};
use crate::dialect::names::name;
use crate::number::rounded;
use std::fmt::{self, Write};

/// How motion is written: the names of the machine's axes, and the decimals of millimetres and degrees.
///
/// A line holds what happens, where every axis is then in machine coordinates, and what is in force. What is usual is left
/// out (no compensation, the plane of X and Y, a standing spindle), and so is a feed where nothing moves at feed.
#[derive(Debug, Clone, Copy)]
pub struct MotionText<'a> {
    axes: &'a [String],
    decimals: usize,
}

impl<'a> MotionText<'a> {
    /// Decimals that tell the words of any usual control from each other: a tenth of a micrometre.
    pub const DECIMALS: usize = 4;

    /// With the names of the axes in the machine's order.
    pub fn new(axes: &'a [String], decimals: usize) -> Self {
        Self { axes, decimals }
    }

    /// What stands above the columns.
    pub fn head(&self) -> String {
        let axes: String = self.axes.iter().map(|axis| format!("{axis:>width$}", width = self.width())).collect();
        format!("{:>7}  {:<14}{axes}  in force", "line", "what")
    }

    /// One item.
    pub fn line(&self, item: &Item, motion: &Motion) -> String {
        let (what, joints) = match &item.what {
            What::Move(it) => (law(it).to_owned(), self.joints(it, motion)),
            What::Event(event) => (self.event(*event), " ".repeat(self.width() * self.axes.len())),
        };
        let mut line = format!("{:>7}  {what:<14}{joints} ", item.line);
        let is_at_feed = matches!(&item.what, What::Move(it) if it.law != Law::Rapid);
        self.state(motion.state(item), is_at_feed, &mut line).expect("text can be written");
        if let What::Move(Move { law: Law::Arc(index), .. }) = &item.what {
            line += &self.arc(motion.arc(*index));
        }
        line.truncate(line.trim_end().len());
        line
    }

    fn width(&self) -> usize {
        self.decimals + 7
    }

    fn joints(&self, it: &Move, motion: &Motion) -> String {
        let value = |(axis, joint): (usize, &f64)| match it.known & 1 << axis {
            0 => format!("{:>width$}", "?", width = self.width()),
            _ => format!("{:>width$}", self.fixed(*joint), width = self.width()),
        };
        motion.joints(it).iter().enumerate().map(value).collect()
    }

    fn event(&self, event: Event) -> String {
        match event {
            Event::ToolChange(tool) => format!("tool {tool}"),
            Event::Dwell(seconds) => format!("dwell {} s", self.short(seconds)),
            Event::Stop => "stop".to_owned(),
            Event::OptionalStop => "optional stop".to_owned(),
            Event::End => "end".to_owned(),
        }
    }

    fn state(&self, state: &State, is_at_feed: bool, line: &mut String) -> fmt::Result {
        let mut number = |letter: char, number: Option<u32>| number.map_or(Ok(()), |it| write!(line, " {letter}{it}"));
        number('T', state.tool)?;
        number('H', state.length_register)?;
        number('O', state.offset)?;
        match state.spindle {
            Spindle::Off => {}
            Spindle::Clockwise => write!(line, " S{} cw", self.short(state.speed_rpm))?,
            Spindle::Counterclockwise => write!(line, " S{} ccw", self.short(state.speed_rpm))?,
        }
        match state.feed.filter(|_| is_at_feed) {
            None => {}
            Some(Feed::PerMinute(feed)) => write!(line, " F{}", self.short(feed))?,
            Some(Feed::PerRevolution(feed)) => write!(line, " F{}/rev", self.short(feed))?,
            Some(Feed::Inverse(blocks)) => write!(line, " F{} blocks/min", self.short(blocks))?,
        }
        switches(state).try_for_each(|word| write!(line, " {word}"))
    }

    fn arc(&self, arc: &Arc) -> String {
        let Arc { centre_mm: [x, y, z], radius_mm, normal: [i, j, k], sweep_rad } = *arc;
        let [x, y, z] = [x, y, z].map(|it| self.fixed(it));
        let [i, j, k] = [i, j, k].map(|it| self.short(it));
        let [radius, turn] = [radius_mm, sweep_rad.to_degrees()].map(|it| self.fixed(it));
        format!(" about {x} {y} {z} along {i} {j} {k} radius {radius} by {turn}")
    }

    fn fixed(&self, value: f64) -> String {
        format!("{:.decimals$}", rounded(value, self.decimals), decimals = self.decimals)
    }

    /// Without zeros at the end.
    fn short(&self, value: f64) -> String {
        format!("{}", rounded(value, self.decimals))
    }
}

fn law(it: &Move) -> &'static str {
    match (it.law, it.is_machine) {
        (Law::Rapid, false) => "rapid",
        (Law::Rapid, true) => "rapid, machine",
        (Law::Line, false) => "line",
        (Law::Line, true) => "line, machine",
        (Law::Arc(_), false) => "arc",
        (Law::Arc(_), true) => "arc, machine",
    }
}

/// What is not as usual.
fn switches(state: &State) -> impl Iterator<Item = &'static str> {
    let plane = (state.plane != Plane::Xy).then_some(Meaning::Plane(state.plane));
    let side = (state.side != Side::Off).then_some(Meaning::Side(state.side));
    let said = state.coolant.iter().map(Meaning::Coolant).chain(plane).chain(side).chain(state.path.map(Meaning::Path));
    said.filter_map(name).chain(state.tip.then_some("tip"))
}
