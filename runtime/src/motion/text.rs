//! Motion as text, one item a line, for people's eyes and for differences.

use super::{Arc, Event, InForce, Item, Law, Motion, Move, What};
use crate::number::{fixed, short};

/// How motion is written: the names of the machine's axes, and the decimals of millimetres and degrees.
///
/// A line holds what happens, where every axis is then in machine coordinates, and what is in force.
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
        let is_at_feed = matches!(&item.what, What::Move(it) if it.law != Law::Rapid);
        let in_force = InForce { state: motion.state(item), is_at_feed, decimals: self.decimals };
        let mut line = format!("{:>7}  {what:<14}{joints} {in_force}", item.line);
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
            _ => format!("{:>width$}", fixed(*joint, self.decimals), width = self.width()),
        };
        motion.joints(it).iter().enumerate().map(value).collect()
    }

    fn event(&self, event: Event) -> String {
        match event {
            Event::ToolChange(tool) => format!("tool {tool}"),
            Event::Dwell(seconds) => format!("dwell {} s", short(seconds, self.decimals)),
            Event::Stop => "stop".to_owned(),
            Event::OptionalStop => "optional stop".to_owned(),
            Event::End => "end".to_owned(),
        }
    }

    fn arc(&self, arc: &Arc) -> String {
        let Arc { centre_mm: [x, y, z], radius_mm, normal: [i, j, k], sweep_rad } = *arc;
        let [x, y, z] = [x, y, z].map(|it| fixed(it, self.decimals));
        let [i, j, k] = [i, j, k].map(|it| short(it, self.decimals));
        let [radius, turn] = [radius_mm, sweep_rad.to_degrees()].map(|it| fixed(it, self.decimals));
        format!(" about {x} {y} {z} along {i} {j} {k} radius {radius} by {turn}")
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
