//! A draft in which the checks found nothing to a model.

use super::draft::{AxisDraft, Draft, ErrorDraft, Measured, ToolDraft};
use super::errors::{Errors, LocationError};
use super::machine::{Model, ModelAxis, ModelJoint, Tool};
use super::source::Located;
use crate::syntax::tree::{Link, Name, Preference as Said};
use mach_runtime::machine::{BranchPolicy, ErrorTable, Preference, Rule, Travel, Written};
use mach_runtime::strictness::Strictness;
use nalgebra::Vector3;

/// The tool axis may be off by this much where the machine says nothing.
const AXIS_TOLERANCE_DEG: f64 = 0.0001;

/// A segment may leave its arc by this much where the machine says nothing.
const CHORD_TOLERANCE_MM: f64 = 0.01;

/// The tip may be off the plane of two linear axes by this much where the machine says nothing: the last digit of most
/// programs.
const PLANE_TOLERANCE_MM: f64 = 0.001;

const CHECKED: &str = "a draft without findings is complete";

/// The model, still without a dialect.
///
/// # Panics
///
/// When the draft has not been checked.
pub(crate) fn build(draft: &Draft<'_>) -> Model {
    let links = &draft.chain.as_ref().expect(CHECKED).value;
    let joints_before_bed = |links: &[Link]| links.iter().filter(|link| matches!(link, Link::Axis { .. })).count();
    let bed = links.iter().position(|link| matches!(link, Link::Bed(_))).expect(CHECKED);
    Model {
        name: draft.name.value.clone(),
        title: draft.title.clone(),
        parameters: draft.parameters.clone(),
        axes: draft.axes.iter().map(|axis| build_axis(draft, axis)).collect(),
        chain: links.iter().filter_map(|link| joint(draft, link)).collect(),
        bed: joints_before_bed(&links[..bed]),
        tool: build_tool(draft.tool.as_ref().expect(CHECKED)),
        errors: build_errors(draft),
        zero_mm: draft.zero_mm.unwrap_or_else(Vector3::zeros),
        axis_tolerance_rad: draft.axis_tolerance_deg.unwrap_or(AXIS_TOLERANCE_DEG).to_radians(),
        plane_tolerance_mm: draft.plane_tolerance_mm.unwrap_or(PLANE_TOLERANCE_MM),
        chord_tolerance_mm: draft.chord_tolerance_mm.unwrap_or(CHORD_TOLERANCE_MM),
        unknown_records: draft.unknown_records.unwrap_or(Strictness::Error),
        branch: BranchPolicy {
            start: preferences(draft, &draft.start),
            then: preferences(draft, &draft.then),
            reposition: draft.reposition.unwrap_or(Strictness::Error),
        },
        dialect: None,
    }
}

fn build_axis(draft: &Draft<'_>, axis: &AxisDraft) -> ModelAxis {
    let travel = axis.travel.as_ref().map(|travel| Travel { lower: travel.value[0], upper: travel.value[1] });
    let travel = travel.unwrap_or(Travel::UNLIMITED);
    ModelAxis {
        name: axis.name.value.clone(),
        motion: axis.motion,
        direction: axis.unit().expect(CHECKED),
        point_mm: axis.point_mm.expect(CHECKED),
        travel,
        rule: draft.ruled(axis).map_or(Rule::Pose, |ruled| ruled.rule.expect(CHECKED)),
        rapid_per_min: axis.rapid_per_min,
        written: written(draft, axis, travel),
    }
}

/// The travel of an axis with limits is within its range, so that nothing is ever taken off its value.
fn written(draft: &Draft<'_>, axis: &AxisDraft, travel: Travel) -> Written {
    let range_deg = draft.written_of(axis).and_then(|written| written.range_deg.as_ref());
    match range_deg {
        Some(range) if travel == Travel::UNLIMITED => Written::Wrapped { from_deg: range.value[0] },
        _ => Written::Unwound,
    }
}

fn joint(draft: &Draft<'_>, link: &Link) -> Option<ModelJoint> {
    let Link::Axis { name, primed } = link else { return None };
    Some(ModelJoint { axis: index(draft, name), primed: *primed })
}

fn build_tool(tool: &ToolDraft) -> Tool {
    Tool {
        axis: tool.unit().expect(CHECKED),
        gauge_mm: tool.gauge_mm.expect(CHECKED),
        length_mm: tool.length_mm.expect(CHECKED),
    }
}

fn build_errors(draft: &Draft<'_>) -> Errors {
    let mut errors = Errors::default();
    for ErrorDraft { axis, component, measured, .. } in &draft.errors {
        let (axis, component) = (*axis, *component);
        let value = |said: f64| if component.is_turn() { said.to_radians() } else { said };
        match measured {
            Measured::Location(said) => {
                errors.locations.push(LocationError { axis, component, value: value(*said) });
            }
            Measured::Table { rows, .. } => {
                let rows = rows.iter().map(|row| (row.value.0, value(row.value.1))).collect();
                errors.tables.push(ErrorTable { axis, component, rows });
            }
        }
    }
    errors
}

fn preferences(draft: &Draft<'_>, said: &[Located<Said>]) -> Vec<Preference> {
    let preference = |said: &Located<Said>| match &said.value {
        Said::Least(name) => Preference::Least(index(draft, name)),
        Said::Positive(name) => Preference::Positive(index(draft, name)),
        Said::Negative(name) => Preference::Negative(index(draft, name)),
        Said::Nearest => Preference::Nearest,
    };
    if said.is_empty() { vec![Preference::Nearest] } else { said.iter().map(preference).collect() }
}

fn index(draft: &Draft<'_>, name: &Name) -> usize {
    draft.axis(&name.value).expect(CHECKED).0
}
