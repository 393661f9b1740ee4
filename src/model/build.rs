//! A draft in which the checks found nothing to a model.

use super::draft::{AxisDraft, Draft, ToolDraft};
use super::errors::Errors;
use super::machine::{Axis, Joint, Model, Tool};
use super::source::Located;
use crate::syntax::tree::{Link, Name, Preference as Said};
use mach_runtime::machine::{BranchPolicy, Preference, Strictness, Travel, Written};
use nalgebra::Vector3;

/// The tool axis may be off by this much where the machine says nothing.
const AXIS_TOLERANCE_DEG: f64 = 0.0001;

/// A segment may leave its arc by this much where the machine says nothing.
const CHORD_TOLERANCE_MM: f64 = 0.01;

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
        errors: Errors::default(),
        zero_mm: draft.zero_mm.unwrap_or_else(Vector3::zeros),
        axis_tolerance_rad: draft.axis_tolerance_deg.unwrap_or(AXIS_TOLERANCE_DEG).to_radians(),
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

fn build_axis(draft: &Draft<'_>, axis: &AxisDraft) -> Axis {
    let travel = axis.travel.as_ref().map(|travel| Travel { lower: travel.value[0], upper: travel.value[1] });
    let said = draft.written.iter().rfind(|written| written.axis.value.value == axis.name.value);
    let range_deg = said.and_then(|written| written.range_deg.as_ref());
    Axis {
        name: axis.name.value.clone(),
        motion: axis.motion,
        direction: axis.unit().expect(CHECKED),
        point_mm: axis.point_mm.expect(CHECKED),
        travel: travel.unwrap_or(Travel::UNLIMITED),
        rapid_per_min: axis.rapid_per_min,
        written: range_deg.map_or(Written::Unwound, |range| Written::Wrapped { from_deg: range.value[0] }),
    }
}

fn joint(draft: &Draft<'_>, link: &Link) -> Option<Joint> {
    let Link::Axis { name, primed } = link else { return None };
    Some(Joint { axis: index(draft, name), primed: *primed })
}

fn build_tool(tool: &ToolDraft) -> Tool {
    Tool {
        axis: tool.unit().expect(CHECKED),
        gauge_mm: tool.gauge_mm.expect(CHECKED),
        length_mm: tool.length_mm.expect(CHECKED),
    }
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
