//! The checks, one file each: what it finds, its code, its example.
//!
//! A check looks at the draft of a machine, in which anything may be missing: what is missing or could not be evaluated
//! has been reported already, and is passed over. A draft without findings is a model.

pub(crate) mod axis_not_in_chain;
pub(crate) mod axis_twice_in_chain;
pub(crate) mod chain_ends;
pub(crate) mod coarse_word;
pub(crate) mod direction;
pub(crate) mod error_rows;
pub(crate) mod error_size;
pub(crate) mod idle_error;
pub(crate) mod limited_wrapped;
pub(crate) mod linear_span;
pub(crate) mod missing;
pub(crate) mod narrow_word;
pub(crate) mod no_way_out;
pub(crate) mod parallel_rotaries;
pub(crate) mod preference;
pub(crate) mod rotary_along_tool;
mod standing;
pub(crate) mod supported;
pub(crate) mod surplus;
pub(crate) mod towards_the_part;
pub(crate) mod travel;
pub(crate) mod unknown_axis;
pub(crate) mod written_range;

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::Draft;
use crate::model::source::Location;

/// A check: everything it finds in a draft.
type Check = fn(&Draft<'_>) -> Vec<Diagnostic>;

static CHECKS: [Check; 18] = [
    missing::check,
    chain_ends::check,
    unknown_axis::check,
    axis_not_in_chain::check,
    axis_twice_in_chain::check,
    supported::check,
    surplus::check,
    direction::check,
    parallel_rotaries::check,
    rotary_along_tool::check,
    linear_span::check,
    travel::check,
    preference::check,
    written_range::check,
    limited_wrapped::check,
    idle_error::check,
    error_rows::check,
    error_size::check,
];

/// Everything that all checks find.
pub(crate) fn all(draft: &Draft<'_>) -> Vec<Diagnostic> {
    CHECKS.iter().flat_map(|check| check(draft)).collect()
}

/// Two directions with a smaller sine between them count as parallel, and three with a smaller volume as in one plane.
const PARALLEL_SINE: f64 = 1e-6;

/// An error with its cause.
fn error(draft: &Draft<'_>, code: &'static Code, message: String, at: &Location, label: &str) -> Diagnostic {
    Diagnostic::error(code, message).at(draft.sources.place(at), label)
}

fn warning(draft: &Draft<'_>, code: &'static Code, message: String, at: &Location, label: &str) -> Diagnostic {
    Diagnostic::warning(code, message).at(draft.sources.place(at), label)
}
