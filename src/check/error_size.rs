//! An error of a size that no machine has.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::{Draft, ErrorDraft, Measured};
use crate::model::quantity::readable;

/// What is farther off than this was not built as the file says: five millimetres over a gantry's whole travel.
const GREATEST_MM: f64 = 5.0;
/// See [`GREATEST_MM`].
const GREATEST_DEG: f64 = 1.0;

/// An error that is larger than any.
pub(crate) static TOO_LARGE: Code = Code {
    id: "E0322",
    title: "an error is larger than the error of any machine",
    explanation: "\
An error is at most 5 mm or 1 deg. What is farther off is no error but the way the machine is built: write it into the
axis' own statement.

    error EX0C 12          // a bare number is in mm: 12 mm
    error EX0C 12 um
    error EA0C 20          // … or in deg
    error EA0C 20 urad
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    draft.errors.iter().flat_map(|error| too_large(draft, error)).collect()
}

fn too_large(draft: &Draft<'_>, error: &ErrorDraft) -> Vec<Diagnostic> {
    let (greatest, unit, meant) =
        if error.component.is_turn() { (GREATEST_DEG, "deg", "urad") } else { (GREATEST_MM, "mm", "um") };
    let values = match &error.measured {
        Measured::Location(value) => vec![(*value, &error.name.at)],
        Measured::Table { rows, .. } => rows.iter().map(|row| (row.value.1, &row.at)).collect(),
    };
    let large = values.into_iter().filter(|(value, _)| value.abs() > greatest);
    let report = |(value, at)| {
        let message = format!("{} is {} {unit}, more than any machine is off", error.name.value, readable(value));
        super::error(draft, &TOO_LARGE, message, at, "too large").note(format!("were {meant} meant?"))
    };
    large.map(report).collect()
}
