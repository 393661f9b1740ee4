//! The resolved machine as JSON, for tools: what the machine file says after `use`, `like`, parameters and defaults.
//!
//! Units stand in the keys: `_mm`, `_deg`, `_rad`, `_mm_per_min`. A limit that is not there is `null`. Points and directions
//! are `[x, y, z]` in the machine's frame with every axis at zero. Axes are referred to by their names. Of the controller,
//! its words and codes are there, not the texts of its blocks.

use crate::model::class;
use crate::model::errors::LocationError;
use crate::model::machine::{Model, ModelAxis, ModelJoint};
use mach_runtime::machine::{Component, ErrorTable, Motion, Preference, Rule, Travel, Written};
use mach_runtime::nc::dialect::{Dialect, Word};
use mach_runtime::strictness::Strictness;
use mach_runtime::unit::LengthUnit;
use nalgebra::Vector3;
use serde::Serialize;
use serde_json::{Map, Value, json};

/// The version of this form: it grows when a key changes its meaning or goes.
const FORM: u32 = 1;

/// The machine as one JSON object, indented, with a line end.
pub fn machine(model: &Model) -> String {
    let file = File {
        form: FORM,
        name: &model.name,
        title: model.title.as_deref(),
        family: class::class(model),
        parameters: model.parameters.iter().map(|(name, value)| (name.clone(), json!(value))).collect(),
        chain: chain(model),
        axes: model.axes.iter().map(axis).collect(),
        tool: Tool {
            axis: vector(&model.tool.axis),
            gauge_point_mm: vector(&model.tool.gauge_mm),
            length_mm: model.tool.length_mm + 0.0,
        },
        program_zero_mm: vector(&model.zero_mm),
        axis_tolerance_rad: model.axis_tolerance_rad,
        chord_tolerance_mm: model.chord_tolerance_mm,
        plane_tolerance_mm: model.plane_tolerance_mm,
        unknown_records: strictness(model.unknown_records),
        branch: Branch {
            start: model.branch.start.iter().map(|preference| self::preference(model, *preference)).collect(),
            then: model.branch.then.iter().map(|preference| self::preference(model, *preference)).collect(),
            reposition: strictness(model.branch.reposition),
        },
        location_errors: model.errors.locations.iter().map(|error| location_error(model, error)).collect(),
        error_tables: model.errors.tables.iter().map(|table| error_table(model, table)).collect(),
        controller: model.dialect.as_ref().map(controller),
    };
    serde_json::to_string_pretty(&file).expect("a machine is plain data") + "\n"
}

#[derive(Serialize)]
struct File<'a> {
    form: u32,
    name: &'a str,
    title: Option<&'a str>,
    family: String,
    /// As a person would write them.
    parameters: Map<String, Value>,
    chain: Vec<Link<'a>>,
    axes: Vec<AxisEntry<'a>>,
    tool: Tool,
    program_zero_mm: [f64; 3],
    axis_tolerance_rad: f64,
    chord_tolerance_mm: f64,
    plane_tolerance_mm: f64,
    unknown_records: &'static str,
    branch: Branch,
    location_errors: Vec<Value>,
    error_tables: Vec<Value>,
    controller: Option<Value>,
}

/// A joint, from the workpiece to the tool.
#[derive(Serialize)]
struct Link<'a> {
    axis: &'a str,
    /// Whether its positive sense is the workpiece's motion (ISO 841).
    primed: bool,
    carries: &'static str,
}

#[derive(Serialize)]
struct AxisEntry<'a> {
    name: &'a str,
    motion: &'static str,
    direction: [f64; 3],
    #[serde(skip_serializing_if = "Option::is_none")]
    point_mm: Option<[f64; 3]>,
    #[serde(flatten)]
    travel: Limits,
    /// The least value written, where values are written within one turn.
    #[serde(skip_serializing_if = "Option::is_none")]
    written_from_deg: Option<f64>,
    /// Nothing where the pose decides.
    #[serde(flatten)]
    rule: Map<String, Value>,
}

/// Lower and upper end of the travel, and rapid traverse.
#[derive(Serialize)]
#[serde(untagged)]
enum Limits {
    Linear { travel_mm: [Option<f64>; 2], rapid_mm_per_min: Option<f64> },
    Rotary { travel_deg: [Option<f64>; 2], rapid_deg_per_min: Option<f64> },
}

#[derive(Serialize)]
struct Tool {
    /// From the tip to the spindle.
    axis: [f64; 3],
    gauge_point_mm: [f64; 3],
    length_mm: f64,
}

#[derive(Serialize)]
struct Branch {
    start: Vec<Value>,
    then: Vec<Value>,
    reposition: &'static str,
}

fn chain(model: &Model) -> Vec<Link<'_>> {
    let link = |(place, joint): (usize, &ModelJoint)| Link {
        axis: &model.axes[joint.axis].name,
        primed: joint.primed,
        carries: if place < model.bed { "workpiece" } else { "tool" },
    };
    model.chain.iter().enumerate().map(link).collect()
}

fn axis(axis: &ModelAxis) -> AxisEntry<'_> {
    let Travel { lower, upper } = axis.travel;
    let travel = [lower, upper].map(|end| end.is_finite().then_some(end + 0.0));
    AxisEntry {
        name: &axis.name,
        motion: match axis.motion {
            Motion::Linear => "linear",
            Motion::Rotary => "rotary",
        },
        direction: vector(&axis.direction),
        point_mm: (axis.motion == Motion::Rotary).then(|| vector(&axis.point_mm)),
        travel: match axis.motion {
            Motion::Linear => Limits::Linear { travel_mm: travel, rapid_mm_per_min: axis.rapid_per_min },
            Motion::Rotary => Limits::Rotary { travel_deg: travel, rapid_deg_per_min: axis.rapid_per_min },
        },
        written_from_deg: match axis.written {
            Written::Unwound => None,
            Written::Wrapped { from_deg } => Some(from_deg + 0.0),
        },
        rule: rule(axis),
    }
}

/// As the language has it, with the unit of the value.
fn rule(axis: &ModelAxis) -> Map<String, Value> {
    let at = |rule: &str, value: f64| Some((format!("{rule}_{}", axis.motion.unit()), json!(value + 0.0)));
    let said = match axis.rule {
        Rule::Pose => None,
        Rule::Locked(value) => at("lock", value),
        Rule::Preferred(value) => at("prefer", value),
        Rule::Free => Some(("free".to_owned(), json!(true))),
    };
    said.into_iter().collect()
}

/// As the language has it: `nearest`, or a kind with its axis.
fn preference(model: &Model, preference: Preference) -> Value {
    let of = |kind: &str, axis: usize| json!({ kind: model.axes[axis].name });
    match preference {
        Preference::Least(axis) => of("least", axis),
        Preference::Positive(axis) => of("positive", axis),
        Preference::Negative(axis) => of("negative", axis),
        Preference::Nearest => json!("nearest"),
    }
}

fn strictness(strictness: Strictness) -> &'static str {
    match strictness {
        Strictness::Error => "error",
        Strictness::Warn => "warn",
    }
}

fn location_error(model: &Model, error: &LocationError) -> Value {
    let LocationError { axis, component, value } = *error;
    json!({ "axis": model.axes[axis].name, "component": component.letter().to_string(), unit(component): value })
}

fn error_table(model: &Model, table: &ErrorTable) -> Value {
    let axis = &model.axes[table.axis];
    json!({
        "axis": axis.name,
        "component": table.component.letter().to_string(),
        "columns": [format!("position_{}", axis.motion.unit()), unit(table.component)],
        "rows": table.rows,
    })
}

/// The key of an error's value.
fn unit(component: Component) -> &'static str {
    if component.is_turn() { "error_rad" } else { "error_mm" }
}

fn controller(dialect: &Dialect) -> Value {
    let word = |word: &Word| json!({ "name": word.name, "address": word.address, "decimals": word.picture.decimals });
    let triggers: Vec<&str> = dialect.blocks.iter().map(|block| block.trigger.name()).collect();
    json!({
        "name": dialect.name,
        "units": match dialect.units {
            LengthUnit::Millimetre => "mm",
            LengthUnit::Inch => "inch",
        },
        "extension": dialect.extension,
        "axis_words": dialect.axes.iter().map(word).collect::<Vec<_>>(),
        "feed_word": word(&dialect.feed),
        "feed_per_revolution_word": word(&dialect.feed_per_revolution),
        "work_offset": dialect.offset,
        "modal_groups": dialect.modal_groups,
        "blocks": triggers,
    })
}

fn vector(vector: &Vector3<f64>) -> [f64; 3] {
    [vector.x + 0.0, vector.y + 0.0, vector.z + 0.0]
}
