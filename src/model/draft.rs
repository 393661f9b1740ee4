//! A machine as it was said, evaluated but not yet checked: what the checks look at.

use super::lost::Lost;
use super::source::{Located, Location, SourceMap};
use super::subject::AXIS;
use crate::syntax::tree::{Link, Name, Preference};
use mach_runtime::machine::{Component, Motion, Rule};
use mach_runtime::strictness::Strictness;
use nalgebra::Vector3;

/// A machine in which anything may still be missing or wrong. `None` means not said, or said wrongly and reported.
pub(crate) struct Draft<'a> {
    pub(crate) sources: &'a SourceMap,
    /// The name in the file.
    pub(crate) name: Located<String>,
    pub(crate) title: Option<String>,
    /// Names and values for people.
    pub(crate) parameters: Vec<(String, String)>,
    pub(crate) chain: Option<Located<Vec<Link>>>,
    /// Whether a `dh` table says the chain.
    pub(crate) is_chain_of_a_table: bool,
    /// Whether every link of the chain was understood.
    pub(crate) is_chain_whole: bool,
    /// In the order of declaration; no name twice.
    pub(crate) axes: Vec<AxisDraft>,
    pub(crate) tool: Option<ToolDraft>,
    pub(crate) errors: Vec<ErrorDraft>,
    pub(crate) zero_mm: Option<Vector3<f64>>,
    pub(crate) axis_tolerance_deg: Option<f64>,
    pub(crate) chord_tolerance_mm: Option<f64>,
    pub(crate) plane_tolerance_mm: Option<f64>,
    pub(crate) unknown_records: Option<Strictness>,
    pub(crate) start: Vec<Located<Preference>>,
    pub(crate) then: Vec<Located<Preference>>,
    pub(crate) reposition: Option<Strictness>,
    /// What is said of axes that the pose does not decide.
    pub(crate) ruled: Vec<RuleDraft>,
    /// What the controller says of written ranges, and behind it what the machine says.
    pub(crate) written: Vec<WrittenDraft>,
    /// What was said of the machine and not understood, without the axes that are known by their names.
    pub(crate) lost: Lost,
    /// What was said of its controller and not understood.
    pub(crate) lost_of_controller: Lost,
}

/// A declared axis.
pub(crate) struct AxisDraft {
    /// The whole statement.
    pub(crate) at: Location,
    pub(crate) name: Located<String>,
    pub(crate) motion: Motion,
    /// Of any length.
    pub(crate) direction: Option<Located<Vector3<f64>>>,
    pub(crate) point_mm: Option<Vector3<f64>>,
    /// Millimetres or degrees.
    pub(crate) travel: Option<Located<[f64; 2]>>,
    pub(crate) rapid_per_min: Option<f64>,
}

/// The tool.
pub(crate) struct ToolDraft {
    /// The whole statement.
    pub(crate) at: Location,
    /// Of any length.
    pub(crate) along: Option<Located<Vector3<f64>>>,
    pub(crate) gauge_mm: Option<Vector3<f64>>,
    pub(crate) length_mm: Option<f64>,
}

/// What decides where an axis stands, other than the pose.
pub(crate) struct RuleDraft {
    pub(crate) axis: Located<Name>,
    /// `None` where the value could not be evaluated.
    pub(crate) rule: Option<Rule>,
    /// The whole statement.
    pub(crate) at: Location,
}

/// A measured error of a declared axis.
pub(crate) struct ErrorDraft {
    /// Its name as this project writes it.
    pub(crate) name: Located<String>,
    /// Index into [`Draft::axes`].
    pub(crate) axis: usize,
    pub(crate) component: Component,
    pub(crate) measured: Measured,
}

/// What was measured: millimetres or degrees.
pub(crate) enum Measured {
    /// Where the axis lies.
    Location(f64),
    /// By the position of the axis.
    Table {
        /// The rows that were understood.
        rows: Vec<MeasuredRow>,
        /// Whether these are all.
        is_whole: bool,
    },
}

/// Position (millimetres or degrees) and error (millimetres or degrees).
pub(crate) type MeasuredRow = Located<(f64, f64)>;

/// How an axis is to be written.
pub(crate) struct WrittenDraft {
    pub(crate) axis: Located<Name>,
    /// The range in degrees; `None` for `unwound`.
    pub(crate) range_deg: Option<Located<[f64; 2]>>,
    /// Whether the machine itself says so; a controller's definition may speak of axes that this machine has not.
    pub(crate) of_the_machine: bool,
}

impl Draft<'_> {
    /// The axis of this name and its index.
    pub(crate) fn axis(&self, name: &str) -> Option<(usize, &AxisDraft)> {
        self.axes.iter().enumerate().find(|(_, axis)| axis.name.value == name)
    }

    /// Whether every link of the chain is an axis that is known.
    pub(crate) fn knows_chain(&self) -> bool {
        self.chain.is_some() && self.is_chain_whole && self.links().all(|link| self.axis(&link.value).is_some())
    }

    /// Whether there may be an axis of this name beside those that are known.
    pub(crate) fn may_lack_axis(&self, name: &str) -> bool {
        self.lost.may_say(&AXIS, name)
    }

    /// Whether there may be axes beside those that are known.
    pub(crate) fn may_lack_axes(&self) -> bool {
        self.lost.may_be(&AXIS)
    }

    /// Whether it is known of every axis that the pose decides it, or does not.
    pub(crate) fn knows_solved(&self) -> bool {
        let may_be_ruled = ["lock", "prefer", "free"].iter().any(|rule| self.lost.may_say(&["branch"], rule));
        !self.may_lack_axes() && !may_be_ruled
    }

    /// The rotary axes in the order of declaration.
    pub(crate) fn rotaries(&self) -> impl Iterator<Item = &AxisDraft> {
        self.axes.iter().filter(|axis| axis.motion == Motion::Rotary)
    }

    /// What is said of an axis that the pose does not decide.
    pub(crate) fn ruled(&self, axis: &AxisDraft) -> Option<&RuleDraft> {
        self.ruled.iter().rfind(|ruled| ruled.axis.value.value == axis.name.value)
    }

    /// What holds of how an axis is written.
    pub(crate) fn written_of(&self, axis: &AxisDraft) -> Option<&WrittenDraft> {
        self.written.iter().rfind(|written| written.axis.value.value == axis.name.value)
    }

    /// The axes of this motion that the pose decides, in the order of declaration.
    pub(crate) fn solved(&self, motion: Motion) -> Vec<&AxisDraft> {
        self.axes.iter().filter(|axis| axis.motion == motion && self.ruled(axis).is_none()).collect()
    }

    /// The axes that the chain names, from the workpiece to the tool.
    pub(crate) fn links(&self) -> impl Iterator<Item = &Name> {
        let links = self.chain.iter().flat_map(|chain| &chain.value);
        links.filter_map(|link| if let Link::Axis { name, .. } = link { Some(name) } else { None })
    }
}

impl AxisDraft {
    /// The unit direction; `None` where there is none.
    pub(crate) fn unit(&self) -> Option<Vector3<f64>> {
        self.direction.as_ref().and_then(|direction| unit(&direction.value))
    }
}

impl ToolDraft {
    /// The unit direction; `None` where there is none.
    pub(crate) fn unit(&self) -> Option<Vector3<f64>> {
        self.along.as_ref().and_then(|along| unit(&along.value))
    }
}

/// Of length one; components that are zero but for rounding are zero. `None` for a vector without a direction.
pub(crate) fn unit(vector: &Vector3<f64>) -> Option<Vector3<f64>> {
    let greatest = vector.amax();
    if greatest == 0.0 || !greatest.is_finite() {
        return None;
    }
    let unit = (vector / greatest).normalize();
    Some(unit.map(|component| if component.abs() < 4.0 * f64::EPSILON { 0.0 } else { component }).normalize())
}

#[cfg(test)]
mod tests {
    use super::unit;
    use nalgebra::Vector3;

    #[test]
    fn rounding_is_not_a_direction() {
        assert_eq!(unit(&Vector3::new(6e-17, 0.0, 2.0)), Some(Vector3::z()));
        assert_eq!(unit(&Vector3::new(0.0, -1e-300, 0.0)), Some(-Vector3::y()));
        assert_eq!(unit(&Vector3::zeros()), None);
        assert_eq!(unit(&Vector3::new(f64::NAN, f64::INFINITY, 0.0)), None);
    }
}
