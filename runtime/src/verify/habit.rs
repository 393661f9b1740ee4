//! What a controller's own blocks do at their events: how a program of this description looks between the points of the CL.

use crate::control::Control;
use crate::dialect::meaning::Spindle;
use crate::machine::{Axis, Machine, Motion as AxisMotion};
use crate::motion::{Event, Item, Motion, State, What};
use crate::nc::dialect::{Dialect, Trigger};
use crate::nc::writer::{Values, Writer};
use crate::toolpath::{Approach, LoadedTool};

/// The number of the tool and its register in the trial.
const TOOL: u64 = 7;

/// What the description's own blocks do.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Habit {
    /// The state at the first motion behind a tool change.
    pub(super) state: State,
    /// Whether the length register is the tool's: else it is always the one in the state.
    pub(super) has_register_of_tool: bool,
    /// Where the axes go in machine coordinates before a tool changes, and before the program ends; `None` for axes that
    /// stay where they are.
    pub(super) way_out: [Vec<Option<f64>>; 2],
    /// The axes that move last on the way to the first point, after all others; none where they move together.
    pub(super) last: u64,
    /// Whether a program says that it is over.
    pub(super) ends: bool,
    /// Whether the spindle stands when a tool changes.
    pub(super) stops_spindle: bool,
}

impl Habit {
    pub(super) fn of(machine: &Machine, dialect: &Dialect) -> Self {
        let items = program(machine, dialect);
        let change = items.0.iter().position(|item| matches!(item.what, What::Event(Event::ToolChange(_))));
        let (items, motion) = items;
        let change = change.unwrap_or(0);
        let approach = items[change..].iter().filter_map(|item| match item.what {
            What::Move(it) if !it.is_machine => Some((it.named, *motion.state(item))),
            _ => None,
        });
        let approach: Vec<(u64, State)> = approach.collect();
        let (last, state) = approach.last().copied().unwrap_or_default();
        Self {
            has_register_of_tool: state.length_register == Some(TOOL as u32),
            way_out: [way_out(&items[..change], &motion), way_out(&items[change..], &motion)],
            last: if approach.len() > 1 { last } else { 0 },
            ends: items.iter().any(|item| item.what == What::Event(Event::End)),
            stops_spindle: items.get(change).is_some_and(|item| motion.state(item).spindle == Spindle::Off),
            state,
        }
    }
}

/// Where the axes go in machine coordinates.
fn way_out(items: &[Item], motion: &Motion) -> Vec<Option<f64>> {
    let mut ends = vec![None; motion.axes()];
    for item in items {
        if let What::Move(it) = &item.what
            && it.is_machine
        {
            for (axis, joint) in motion.joints(it).iter().enumerate().filter(|(axis, _)| it.named & 1 << axis != 0) {
                ends[axis] = (it.known & 1 << axis != 0).then_some(*joint);
            }
        }
    }
    ends
}

/// The motion of a program of a tool change, a point and an end.
fn program(machine: &Machine, dialect: &Dialect) -> (Vec<Item>, Motion) {
    let mut writer = Writer::new(dialect.clone(), &machine.axes);
    let loaded = LoadedTool { number: TOOL, register: TOOL };
    let values = Values { program: "P", tool: Some(loaded), speed_rpm: 100.0, dwell_s: 1.0, ..Values::default() };
    let mut text = Vec::new();
    for trigger in [Trigger::Start, Trigger::SpindleClockwise, Trigger::Tool] {
        // What the description has no block for is not in its programs.
        let _ = writer.command(trigger, &values, &mut text);
    }
    let joints: Vec<f64> = machine.axes.iter().map(middle).collect();
    let _ = writer.motion(Approach::Rapid, &joints, machine.tool().length_mm, &mut text);
    let _ = writer.command(Trigger::End, &values, &mut text);
    let mut control = Control::new(&dialect.table, &machine.axes, machine.tool());
    let mut motion = Motion::new(machine.axes.len());
    control.run_what_it_can(&String::from_utf8_lossy(&text), &mut motion);
    (motion.items().to_vec(), motion)
}

/// A place within the travel of an axis.
fn middle(axis: &Axis) -> f64 {
    let near_zero = 0.0_f64.clamp(axis.travel.lower, axis.travel.upper);
    match axis.motion {
        AxisMotion::Linear if axis.travel.lower.is_finite() && axis.travel.upper.is_finite() => {
            0.5 * (axis.travel.lower + axis.travel.upper)
        }
        _ => near_zero,
    }
}
