//! What is in force at a point that is reached, against what the CL wants there.

use super::habit::Habit;
use super::mismatch::{Difference, Found};
use super::tolerance::Tolerance;
use crate::dialect::meaning::{Side, Spindle};
use crate::motion::{Feed, State};
use std::collections::BTreeSet;

/// Judges state after state. What differs is told once, until it has been right again.
#[derive(Debug)]
pub(super) struct Judgement {
    told: BTreeSet<Difference>,
    /// What was judged last and was right.
    right: Option<Reached>,
}

/// The states at a point that is reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Reached {
    /// Whether the CL is at feed there.
    pub(super) is_cut: bool,
    /// Whether the program is.
    pub(super) cuts: bool,
    pub(super) wanted: State,
    pub(super) state: State,
}

impl Judgement {
    pub(super) fn new() -> Self {
        Self { told: BTreeSet::new(), right: None }
    }

    /// Judges the states at a point.
    pub(super) fn judge(
        &mut self,
        reached: &Reached,
        habit: &Habit,
        tolerance: &Tolerance<'_>,
        mut differ: impl FnMut(Found),
    ) {
        if self.right.as_ref() == Some(reached) {
            return;
        }
        let found = differences(reached, habit, tolerance);
        let is_seen = |told: &Difference| reached.is_cut || told.is_of_every_motion();
        self.told.retain(|told| !is_seen(told) || found.iter().any(|(difference, _)| difference == told));
        self.right = (found.is_empty() && self.told.is_empty()).then_some(*reached);
        for (difference, message) in found {
            // Each block of the wrong kind is a danger of its own.
            if difference == Difference::Kind || self.told.insert(difference) {
                differ((difference, message));
            }
        }
    }
}

fn differences(reached: &Reached, habit: &Habit, tolerance: &Tolerance<'_>) -> Vec<Found> {
    let Reached { is_cut, cuts, wanted, state } = reached;
    let mut found = Vec::new();
    if is_cut != cuts {
        let message = match cuts {
            true => "at feed, where the CL is in rapid traverse",
            false => "in rapid traverse, where the CL cuts",
        };
        found.push((Difference::Kind, message.to_owned()));
    }
    found.extend(tool(*is_cut, wanted, state, habit).map(|message| (Difference::Tool, message)));
    found.extend(habitual(state, &habit.state).map(|message| (Difference::State, message)));
    if *is_cut {
        found.extend(feed(wanted, state, tolerance).map(|message| (Difference::Feed, message)));
        found.extend(spindle(wanted, state).map(|message| (Difference::Spindle, message)));
        let coolant = (wanted.coolant != state.coolant).then(|| "another coolant is on than in the CL".to_owned());
        found.extend(coolant.map(|message| (Difference::Coolant, message)));
    }
    found
}

fn tool(is_cut: bool, wanted: &State, state: &State, habit: &Habit) -> Option<String> {
    let tool = wanted.tool?;
    if state.tool != Some(tool) {
        let found = state.tool.map_or("no tool".to_owned(), |tool| format!("tool {tool}"));
        return Some(format!("{found} is in the spindle, in the CL it is tool {tool}"));
    }
    let wanted_register = if habit.has_register_of_tool { wanted.length_register } else { habit.state.length_register };
    // The length comes with the last block of an approach, and a point may be reached before.
    if is_cut && state.length_register != wanted_register {
        let said = |register: Option<u32>| register.map_or("none".to_owned(), |register| register.to_string());
        let (found, wanted) = (said(state.length_register), said(wanted_register));
        return Some(format!("the length register is {found} instead of {wanted}"));
    }
    (state.offset != habit.state.offset).then(|| "another work offset is in force".to_owned())
}

/// What the head of a program sets by the description.
fn habitual(state: &State, habit: &State) -> Option<String> {
    if state.plane != habit.plane {
        return Some("another plane of arcs is in force".to_owned());
    }
    if state.path != habit.path {
        return Some("corners are passed in another way".to_owned());
    }
    if state.wrap != habit.wrap {
        return Some("rotary axes turn another way round".to_owned());
    }
    (state.side != Side::Off).then(|| "the cutter's radius is compensated".to_owned())
}

fn feed(wanted: &State, state: &State, tolerance: &Tolerance<'_>) -> Option<String> {
    let same = match (wanted.feed, state.feed) {
        (None, _) => true,
        (Some(Feed::PerMinute(a)), Some(Feed::PerMinute(b))) => (a - b).abs() <= tolerance.feed_mm_per_min,
        (Some(Feed::PerRevolution(a)), Some(Feed::PerRevolution(b))) => (a - b).abs() <= tolerance.feed_mm_per_rev,
        _ => false,
    };
    (!same).then(|| format!("the feed is {} instead of {}", fed(state.feed), fed(wanted.feed)))
}

fn spindle(wanted: &State, state: &State) -> Option<String> {
    if wanted.spindle != state.spindle {
        let doing = |spindle| match spindle {
            Spindle::Off => "stands",
            Spindle::Clockwise => "turns clockwise",
            Spindle::Counterclockwise => "turns counterclockwise",
        };
        return Some(format!("the spindle {}, in the CL it {}", doing(state.spindle), doing(wanted.spindle)));
    }
    let is_on = wanted.spindle != Spindle::Off;
    // Speeds are written as whole numbers.
    let differs = (wanted.speed_rpm - state.speed_rpm).abs() > 0.5;
    (is_on && differs).then(|| format!("the speed is {} instead of {}", state.speed_rpm, wanted.speed_rpm))
}

fn fed(feed: Option<Feed>) -> String {
    match feed {
        Some(Feed::PerMinute(value)) => format!("{value} mm/min"),
        Some(Feed::PerRevolution(value)) => format!("{value} mm/rev"),
        Some(Feed::Inverse(value)) => format!("{value} blocks a minute"),
        None => "nothing".to_owned(),
    }
}
