//! Where a program goes, how long it is and how long it takes, tool by tool, and what in it is suspicious.

use super::pose::Pose;
use super::suspicion::{Met, Suspicion};
use crate::certificate::Range;
use crate::control::Modal;
use crate::diagnostic::Diagnostic;
use crate::dialect::meaning::{Meaning, Spindle};
use crate::dialect::table::Table;
use crate::machine::{Machine, Motion as AxisMotion};
use crate::motion::{Event, Feed, Item, Law, Motion, Move, What};
use crate::vector::{dot, norm, sub};
use std::collections::BTreeMap;
use std::fmt;

/// A step of a rotary axis longer than this has a shorter way round.
const HALF_TURN_DEG: f64 = 180.0 + 1e-9;

/// Rounding of a word is no motion below the cut.
const DEEPER_MM: f64 = 0.01;

/// Rounding of a word at a limit is not beyond it: half of the last digit of a word in millimetres or degrees.
const BEYOND: f64 = 0.000_501;

/// What a program does.
#[derive(Debug, Clone)]
pub struct Survey {
    /// Blocks that move.
    pub blocks: u64,
    /// Of each axis: machine coordinates.
    pub ranges: Vec<Range>,
    /// Tool by tool, in their order.
    pub tools: Vec<ToolUse>,
    /// Where the axes were before each block, and which of them were known.
    before: (Vec<f64>, u64),
    /// How deep along the tool the last cut was, in millimetres.
    cut_at_mm: Option<f64>,
    met: BTreeMap<Suspicion, Met>,
    /// What the table can say of the control's state.
    says: [(bool, &'static str); 3],
}

/// What a tool does, until the next one.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ToolUse {
    /// Its number; `None` before the first tool change.
    pub tool: Option<u32>,
    /// Blocks that move.
    pub blocks: u64,
    /// The way of its tip in rapid traverse, in millimetres.
    pub rapid_mm: f64,
    /// The way of its tip at feed, in millimetres.
    pub feed_mm: f64,
    /// How long its cuts take at the programmed feed, and its dwells, in seconds.
    pub feed_s: f64,
}

impl Survey {
    pub(super) fn new(machine: &Machine, table: &Table) -> Self {
        let can_say = |pick: fn(&Meaning) -> bool| table.patterns.iter().flat_map(|it| &it.meanings).any(pick);
        Self {
            blocks: 0,
            ranges: machine.axes.iter().map(Range::new).collect(),
            tools: Vec::new(),
            before: (vec![0.0; machine.axes.len()], 0),
            cut_at_mm: None,
            met: BTreeMap::new(),
            says: [
                (can_say(|it| matches!(it, Meaning::Distance(_))), "whether words are absolute"),
                (can_say(|it| matches!(it, Meaning::Units(_))), "the unit of length"),
                (can_say(|it| matches!(it, Meaning::FeedMode(_))), "what the feed counts"),
            ],
        }
    }

    /// Takes items that leave the tool at these poses, as far as they are known, and begin at `before`.
    pub(super) fn take(&mut self, motion: &Motion, poses: &[Option<Pose>], mut before: Option<Pose>) {
        for (item, pose) in motion.items().iter().zip(poses) {
            match &item.what {
                What::Event(Event::ToolChange(tool)) => {
                    self.tools.push(ToolUse { tool: Some(*tool), ..ToolUse::default() })
                }
                What::Event(Event::Dwell(seconds)) => self.tool().feed_s += seconds,
                What::Event(_) => {}
                What::Move(it) => self.go(item, it, motion, [before, *pose]),
            }
            before = *pose;
        }
    }

    fn go(&mut self, item: &Item, it: &Move, motion: &Motion, poses: [Option<Pose>; 2]) {
        self.blocks += 1;
        let joints = motion.joints(it);
        let state = motion.state(item);
        let is_cut = it.law != Law::Rapid;
        self.visit(item.line, it, joints);
        self.suspect_turns(item.line, it, joints);
        if is_cut && state.spindle == Spindle::Off {
            self.meet(Suspicion::StandingSpindle, item.line);
        }
        if is_cut && state.feed.is_none() {
            self.meet(Suspicion::NoFeed, item.line);
        }
        if let [Some(from), Some(to)] = poses {
            let length_mm = match it.law {
                Law::Arc(index) => arc_mm(motion, index, from, to),
                _ => norm(sub(to.tip_mm, from.tip_mm)),
            };
            self.depth(item.line, is_cut, to);
            self.way(is_cut, length_mm, state.feed, state.speed_rpm);
        }
        self.tool().blocks += 1;
        self.before.0.copy_from_slice(joints);
        self.before.1 = it.known;
    }

    /// The way of the tip, and its time.
    fn way(&mut self, is_cut: bool, length_mm: f64, feed: Option<Feed>, speed_rpm: f64) {
        let tool = self.tool();
        if !is_cut {
            tool.rapid_mm += length_mm;
            return;
        }
        tool.feed_mm += length_mm;
        let minutes = match feed {
            Some(Feed::PerMinute(mm_per_min)) => length_mm / mm_per_min,
            Some(Feed::PerRevolution(mm_per_rev)) => length_mm / (mm_per_rev * speed_rpm),
            Some(Feed::Inverse(per_min)) => 1.0 / per_min,
            None => 0.0,
        };
        tool.feed_s += if minutes.is_finite() { 60.0 * minutes } else { 0.0 };
    }

    /// A rapid motion that ends deeper than the last cut.
    fn depth(&mut self, line: u64, is_cut: bool, to: Pose) {
        let height_mm = dot(to.tip_mm, to.axis);
        match self.cut_at_mm {
            _ if is_cut => self.cut_at_mm = Some(height_mm),
            Some(cut_at_mm) if height_mm < cut_at_mm - DEEPER_MM => {
                self.meet(Suspicion::BelowTheCut, line);
                self.cut_at_mm = None;
            }
            _ => self.cut_at_mm = None,
        }
    }

    fn visit(&mut self, line: u64, it: &Move, joints: &[f64]) {
        for (index, joint) in joints.iter().enumerate().filter(|(index, _)| it.known & 1 << index != 0) {
            let range = &mut self.ranges[index];
            range.visit(line, *joint);
            let travel = range.axis.travel;
            if *joint < travel.lower - BEYOND || travel.upper + BEYOND < *joint {
                self.meet(Suspicion::OutOfTravel(index), line);
            }
        }
    }

    /// A block moves with this in force.
    pub(super) fn suspect_state(&mut self, line: u64, modal: &Modal) {
        let said = [modal.distance.is_some(), modal.units.is_some(), modal.feed_mode.is_some()];
        for ((can_say, what), said) in self.says.into_iter().zip(said) {
            if can_say && !said {
                self.meet(Suspicion::PowerOn(what), line);
            }
        }
    }

    fn suspect_turns(&mut self, line: u64, it: &Move, joints: &[f64]) {
        let known = if it.is_machine { 0 } else { it.known & self.before.1 };
        for (index, to) in joints.iter().enumerate().filter(|(index, _)| known & 1 << index != 0) {
            let is_rotary = self.ranges[index].axis.motion == AxisMotion::Rotary;
            if is_rotary && (to - self.before.0[index]).abs() > HALF_TURN_DEG {
                self.meet(Suspicion::LongWay(index), line);
            }
        }
    }

    /// A line with text behind the end of the program.
    pub(super) fn behind_the_end(&mut self, line: u64) {
        self.meet(Suspicion::BehindTheEnd, line);
    }

    fn meet(&mut self, suspicion: Suspicion, line: u64) {
        self.met.entry(suspicion).or_insert(Met { line, blocks: 0 }).blocks += 1;
    }

    fn tool(&mut self) -> &mut ToolUse {
        if self.tools.is_empty() {
            self.tools.push(ToolUse::default());
        }
        self.tools.last_mut().expect("there is one")
    }

    /// What is suspicious, in the order of the program.
    pub(super) fn suspicions(&self, file: &str) -> Vec<Diagnostic> {
        let names: Vec<String> = self.ranges.iter().map(|range| range.axis.name.clone()).collect();
        let mut met: Vec<(&Suspicion, &Met)> = self.met.iter().collect();
        met.sort_by_key(|(_, met)| met.line);
        met.into_iter().map(|(suspicion, met)| suspicion.diagnostic(*met, file, &names)).collect()
    }
}

/// The length of an arc, in millimetres.
fn arc_mm(motion: &Motion, index: u32, from: Pose, to: Pose) -> f64 {
    let arc = motion.arc(index);
    let rise_mm = dot(sub(to.tip_mm, from.tip_mm), arc.normal);
    libm::hypot(arc.radius_mm * arc.sweep_rad, rise_mm)
}

impl fmt::Display for Survey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "program: {} blocks that move", self.blocks)?;
        for tool in &self.tools {
            writeln!(f, "  {tool}")?;
        }
        self.ranges.iter().filter(|range| range.is_visited()).try_for_each(|range| writeln!(f, "  {range}"))
    }
}

impl fmt::Display for ToolUse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.tool.map_or("before any tool".to_owned(), |tool| format!("tool {tool}"));
        let Self { blocks, rapid_mm, feed_mm, feed_s, .. } = self;
        write!(f, "{name:<22}{blocks} blocks, {rapid_mm:.0} mm in rapid, {feed_mm:.0} mm at feed in {feed_s:.1} s")
    }
}
