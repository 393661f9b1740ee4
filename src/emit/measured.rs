//! The measured errors of a machine, as lines of its data sheet.

use crate::model::errors::LocationError;
use crate::model::machine::Model;
use crate::model::number::{number, vector};
use mach_runtime::machine::{Component, ErrorTable, Motion};

/// Location errors with the lines they lead to, then tables.
pub(super) fn errors(model: &Model) -> Vec<String> {
    let of_axes = (0..model.axes.len()).flat_map(|axis| locations(model, axis));
    of_axes.chain(model.errors.tables.iter().map(|table| by_position(model, table))).collect()
}

/// An axis' location errors, and where it really lies.
fn locations(model: &Model, axis: usize) -> Option<String> {
    let name = &model.axes[axis].name;
    let value = |error: &LocationError| {
        format!("{} = {}", model.error_name(error.component, axis, true), size(error.component, error.value))
    };
    let errors = model.errors.locations.iter().filter(|error| error.axis == axis);
    let errors: Vec<String> = errors.map(value).collect();
    let line = model.line(axis);
    let lies = match model.axes[axis].motion {
        Motion::Linear => format!("along {}", vector(&line.direction)),
        Motion::Rotary => format!("about {} through {}", vector(&line.direction), vector(&line.point_mm)),
    };
    (!errors.is_empty()).then(|| format!("{}: {name} really {lies}", errors.join(", ")))
}

fn by_position(model: &Model, table: &ErrorTable) -> String {
    let ErrorTable { axis, component, rows } = table;
    let positions = [rows[0].0, rows[rows.len() - 1].0].map(number).join(" .. ");
    let values = rows.iter().map(|row| row.1);
    let (least, greatest) = (values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max));
    format!(
        "{} from {} to {}, measured at {} positions, {positions} {}",
        model.error_name(*component, *axis, false),
        size(*component, least),
        size(*component, greatest),
        rows.len(),
        model.axes[*axis].motion.unit(),
    )
}

/// In the units in which errors are measured.
fn size(component: Component, value: f64) -> String {
    let in_millionths = |unit: f64| crate::model::quantity::readable(value * unit);
    if component.is_turn() { format!("{} urad", in_millionths(1e6)) } else { format!("{} um", in_millionths(1e3)) }
}
