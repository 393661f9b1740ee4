//! What a block does, run on the control's model.

use super::sample::{START, TOOL};
use mach_runtime::control::{Control, Modal};
use mach_runtime::dialect::meaning::{Coolant, Distance, FeedMode, Plane, Spindle};
use mach_runtime::machine::Axis;
use mach_runtime::motion::{Coolants, Motion, State, What};
use mach_runtime::nc::dialect::{Dialect, Trigger};
use mach_runtime::tool::ToolGeometry;

/// What running a block has done.
pub(super) struct Run {
    pub(super) before: Modal,
    pub(super) after: Modal,
    pub(super) motion: Motion,
    /// Where the last motion ends; `None` where there is none.
    pub(super) joints_at_end: Option<Vec<f64>>,
}

/// Runs the text of an event's block, in the middle of a program or at its start.
///
/// # Errors
/// What cannot be read, and where.
pub(super) fn run(
    text: &str,
    dialect: &Dialect,
    axes: &[Axis],
    (trigger, mode): (Trigger, FeedMode),
) -> Result<Run, String> {
    let mut control = Control::new(&dialect.table, axes, ToolGeometry::of_length(0.0));
    if trigger != Trigger::Start {
        control.set_modal(usual(dialect, trigger, mode));
        // An offset that cannot be read is told where a block prints it.
        let _ = control.run(&dialect.offset, 0, &mut Motion::new(axes.len()));
        control.stand_at(&vec![START; axes.len()]);
    }
    let before = *control.modal();
    let mut motion = Motion::new(axes.len());
    for (number, line) in text.lines().enumerate() {
        control
            .run(line, number as u64 + 1, &mut motion)
            .map_err(|(mistake, _)| format!("cannot be read: {mistake}, in `{}`", line.trim()))?;
    }
    let joints_at_end = motion.items().iter().rev().find_map(|item| match &item.what {
        What::Move(last) => Some(motion.joints(last).to_vec()),
        What::Event(_) => None,
    });
    Ok(Run { before, after: *control.modal(), motion, joints_at_end })
}

/// What is in force in the middle of a program, with everything on that a block could switch off, and off that it switches on.
fn usual(dialect: &Dialect, trigger: Trigger, mode: FeedMode) -> Modal {
    let coolant = if trigger == Trigger::CoolantMist { Coolant::Flood } else { Coolant::Mist };
    Modal {
        plane: Some(Plane::Xy),
        distance: Some(Distance::Absolute),
        units: Some(dialect.units),
        feed_mode: Some(mode),
        feed: Some(321.0),
        called_tool: Some(3),
        state: State {
            tool: Some(3),
            length_register: Some(TOOL as u32),
            spindle: Spindle::Clockwise,
            speed_rpm: 500.0,
            coolant: Coolants::OFF.with(coolant),
            ..State::default()
        },
        ..Modal::default()
    }
}
