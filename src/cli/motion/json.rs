//! An item of motion as a JSON object. `docs/models.md` tells what stands in it.

use mach_runtime::dialect::meaning::Meaning;
use mach_runtime::dialect::names::name;
use mach_runtime::machine::Axis;
use mach_runtime::motion::{self, Event, Item, Law, Motion, Move, State, What};
use serde::Serialize;

use super::super::axis_values::AxisValues;
use super::super::in_force::InForce;
use super::super::unsigned_zero::unsigned_zero;

#[derive(Serialize)]
pub(super) struct Message<'a> {
    #[serde(rename = "type")]
    kind: &'static str,
    line: u64,
    #[serde(flatten)]
    going: Option<Going<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tool: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    seconds: Option<f64>,
    state: StateMessage,
}

/// What only a move has.
#[derive(Serialize)]
struct Going<'a> {
    joints: AxisValues<'a>,
    named: Vec<&'a str>,
    in_machine_coordinates: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    arc: Option<Arc>,
}

#[derive(Serialize)]
struct Arc {
    centre_mm: [f64; 3],
    radius_mm: f64,
    normal: [f64; 3],
    sweep_deg: f64,
}

#[derive(Serialize)]
struct StateMessage {
    #[serde(flatten)]
    in_force: InForce,
    offset: Option<u32>,
    plane: Option<&'static str>,
    side: Option<&'static str>,
    path: Option<&'static str>,
    tip: bool,
}

impl<'a> Message<'a> {
    pub(super) fn new(item: &Item, motion: &'a Motion, axes: &'a [Axis]) -> Self {
        let (kind, going) = match &item.what {
            What::Move(it) => (law(it.law), Some(Going::new(it, motion, axes))),
            What::Event(event) => (event_name(*event), None),
        };
        let (tool, seconds) = match item.what {
            What::Event(Event::ToolChange(tool)) => (Some(tool), None),
            What::Event(Event::Dwell(seconds)) => (None, Some(seconds)),
            What::Event(_) | What::Move(_) => (None, None),
        };
        Self { kind, line: item.line, going, tool, seconds, state: StateMessage::new(motion.state(item)) }
    }
}

impl<'a> Going<'a> {
    fn new(it: &Move, motion: &'a Motion, axes: &'a [Axis]) -> Self {
        let joints = AxisValues { axes, values: motion.joints(it), known: it.known };
        let is_named = |(index, _): &(usize, &Axis)| it.named & 1 << index != 0;
        let named = axes.iter().enumerate().filter(is_named).map(|(_, axis)| axis.name.as_str()).collect();
        let arc = match it.law {
            Law::Arc(index) => Some(Arc::new(motion.arc(index))),
            Law::Rapid | Law::Line => None,
        };
        Self { joints, named, in_machine_coordinates: it.is_machine, arc }
    }
}

impl Arc {
    fn new(arc: &motion::Arc) -> Self {
        Self {
            centre_mm: unsigned_zero(arc.centre_mm),
            radius_mm: arc.radius_mm,
            normal: unsigned_zero(arc.normal),
            sweep_deg: arc.sweep_rad.to_degrees(),
        }
    }
}

impl StateMessage {
    fn new(state: &State) -> Self {
        Self {
            in_force: InForce::new(state),
            offset: state.offset,
            plane: name(Meaning::Plane(state.plane)),
            side: name(Meaning::Side(state.side)),
            path: state.path.and_then(|path| name(Meaning::Path(path))),
            tip: state.tip,
        }
    }
}

fn law(law: Law) -> &'static str {
    match law {
        Law::Rapid => "rapid",
        Law::Line => "line",
        Law::Arc(_) => "arc",
    }
}

fn event_name(event: Event) -> &'static str {
    match event {
        Event::ToolChange(_) => "tool_change",
        Event::Dwell(_) => "dwell",
        Event::Stop => "stop",
        Event::OptionalStop => "optional_stop",
        Event::End => "end",
    }
}
