//! `machc solve --joints`: joint values in, tips and tool axes out.

use std::io::{BufRead, BufReader, Read};

use mach_command::files::{cannot_read, open, shown};
use mach_command::outcome::{Failure, Status};
use mach_command::output::Lines;
use mach_command::progress::watched;
use mach_command::report::Report;
use mach_runtime::compensation::Compensated;
use mach_runtime::coordinates::from_program_zero;
use mach_runtime::kinematics::{Kinematics, LANES, PoseBlock};
use mach_runtime::machine::Machine;
use machc::diagnostic::{Code, Diagnostic, Place};
use machc::plan::Interpreter;
use serde::Serialize;
use serde_json::{Map, Value};

use super::machine::Prepared;
use super::unsigned_zero::unsigned_zero;

/// The longest line that is read.
const LONGEST_LINE_BYTES: u64 = 64 * 1024;
/// So many errors are told; then it is enough.
const MOST_ERRORS: usize = 20;

/// A line that does not hold the values of all axes, or holds others.
pub(super) static BAD_JOINTS: Code = Code {
    id: "E1040",
    title: "a line does not hold the machine's joint values",
    explanation: "\
`machc solve --joints` reads one JSON object a line with the value of every axis of the machine and nothing else, in
millimetres and degrees, in machine coordinates:

    {\"X\": 10.0, \"Y\": 0.0, \"Z\": -20.5, \"A\": 30.0, \"C\": 90.0}

An array in the order of the machine file will do, and so will a candidate that `machc solve` has printed
(`{\"joints\": {…}}`).
",
};

/// Where the tool is.
#[derive(Serialize)]
struct Pose {
    line: u64,
    tip_mm: [f64; 3],
    axis: [f64; 3],
}

pub(super) fn run(prepared: &Prepared, file: &str, report: &Report) -> Result<Status, Failure> {
    let (input, bytes) = open(file)?;
    let mut input = BufReader::new(watched(input, bytes, report));
    let mut kinematics = Compensated::new(Interpreter::new(&prepared.plan), &prepared.machine);
    let mut lines = Lines::stdout();
    let mut errors = Vec::new();
    let mut text = Vec::new();
    for line in 1.. {
        text.clear();
        let read = input.by_ref().take(LONGEST_LINE_BYTES).read_until(b'\n', &mut text);
        if read.map_err(|error| cannot_read(file, &error))? == 0 || errors.len() == MOST_ERRORS {
            break;
        }
        let text = String::from_utf8_lossy(&text);
        match values(&prepared.machine, text.trim()) {
            Ok(Some(values)) => lines.add(&pose(&prepared.machine, &mut kinematics, &values, line)),
            Ok(None) => {}
            Err(message) => errors.push(refused(file, line, text.trim_end(), message)),
        }
        if !lines.flush()? {
            break;
        }
    }
    Ok(report.tell(&errors))
}

/// The values in the machine's order; nothing for an empty line.
fn values(machine: &Machine, text: &str) -> Result<Option<Vec<f64>>, String> {
    if text.is_empty() {
        return Ok(None);
    }
    let parsed: Value = serde_json::from_str(text).map_err(|error| format!("this is not JSON: {error}"))?;
    match parsed.get("joints").unwrap_or(&parsed) {
        Value::Object(values) => by_name(machine, values),
        Value::Array(values) => in_order(machine, values),
        _ => Err("this is neither an object nor an array".to_owned()),
    }
    .map(Some)
}

fn by_name(machine: &Machine, values: &Map<String, Value>) -> Result<Vec<f64>, String> {
    let names: Vec<&str> = machine.axes.iter().map(|axis| axis.name.as_str()).collect();
    let unknown: Vec<&str> = values.keys().map(String::as_str).filter(|key| !names.contains(key)).collect();
    let missing: Vec<&str> = names.iter().copied().filter(|name| !values.contains_key(*name)).collect();
    let wrong: Vec<String> = [("the machine has no axis", unknown), ("there is no value for axis", missing)]
        .into_iter()
        .filter(|(_, axes)| !axes.is_empty())
        .map(|(what, axes)| format!("{what} {}", axes.join(", ")))
        .collect();
    match &wrong[..] {
        [] => names.iter().map(|name| number(name, &values[*name])).collect(),
        wrong => Err(wrong.join(", and ")),
    }
}

fn in_order(machine: &Machine, values: &[Value]) -> Result<Vec<f64>, String> {
    let names: Vec<&str> = machine.axes.iter().map(|axis| axis.name.as_str()).collect();
    if names.len() != values.len() {
        return Err(format!("{} values for {} axes: {}", values.len(), names.len(), names.join(", ")));
    }
    names.iter().zip(values).map(|(name, value)| number(name, value)).collect()
}

/// JSON has no number that is not finite.
fn number(name: &str, value: &Value) -> Result<f64, String> {
    value.as_f64().ok_or_else(|| format!("the value of axis {name} is not a number"))
}

fn pose(machine: &Machine, kinematics: &mut dyn Kinematics, values: &[f64], line: u64) -> Pose {
    let joints = values.iter().map(|value| [*value; LANES]).collect();
    let mut poses = PoseBlock::ZERO;
    kinematics.forward(&joints, machine.tool(), &mut poses);
    let tip_mm = from_program_zero(machine, poses.tip(0));
    Pose { line, tip_mm: unsigned_zero(tip_mm), axis: unsigned_zero(poses.axis(0)) }
}

fn refused(file: &str, line: u64, text: &str, message: String) -> Diagnostic {
    let place = Place { excerpt: text.to_owned(), end: text.len(), ..Place::line(shown(file), line) };
    Diagnostic::error(&BAD_JOINTS, message).at(place, "expected the values of all axes, and no others")
}
