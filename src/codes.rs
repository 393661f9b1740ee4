//! The list of every code that machc knows.

use crate::check;
use crate::emit::c;
use crate::model::evaluate::{arithmetic, function};
use crate::model::{describe, dh, evaluate, family, field, library, load, measured, parameter};
use crate::prove;
use mach_runtime::diagnostic::Code;

/// The codes of the model and of the checks; those of the syntax are listed there.
static CODES: [&Code; 50] = [
    &load::CANNOT_READ,
    &load::USE_CYCLE,
    &library::DEFINED_TWICE,
    &check::unknown_axis::UNKNOWN_AXIS,
    &check::axis_not_in_chain::NOT_IN_CHAIN,
    &check::axis_twice_in_chain::TWICE,
    &check::chain_ends::ENDS,
    &family::SAID_TWICE,
    &check::missing::MISSING,
    &library::ONE_MACHINE,
    &library::UNKNOWN_DEFINITION,
    &family::LIKE_CYCLE,
    &check::preference::NO_ROTARY,
    &describe::DOES_NOT_TURN,
    &measured::UNKNOWN_ERROR,
    &measured::WRONG_FORM,
    &dh::SAID_BY_BOTH,
    &dh::NO_LINE,
    &check::direction::NO_DIRECTION,
    &check::parallel_rotaries::PARALLEL,
    &check::rotary_along_tool::ALONG_TOOL,
    &check::linear_span::NO_SPACE,
    &check::travel::UPSIDE_DOWN,
    &check::supported::NOT_SUPPORTED,
    &check::supported::SURPLUS,
    &check::surplus::NOT_SURPLUS,
    &check::surplus::OUT_OF_TRAVEL,
    &check::idle_error::IDLE,
    &check::error_rows::ROWS,
    &check::error_size::TOO_LARGE,
    &evaluate::UNKNOWN_NAME,
    &function::UNKNOWN_FUNCTION,
    &field::WRONG_UNIT,
    &arithmetic::UNITS_DO_NOT_FIT,
    &function::ANGLE_NEEDS_UNIT,
    &evaluate::SHAPE,
    &evaluate::NOT_FINITE,
    &parameter::CYCLE,
    &field::OUT_OF_RANGE,
    &parameter::RESERVED,
    &check::written_range::NOT_ONE_TURN,
    &check::written_range::NOT_ROTARY,
    &check::narrow_word::NARROW,
    &check::no_way_out::NO_WAY_OUT,
    &check::coarse_word::COARSE,
    &check::towards_the_part::TOWARDS_THE_PART,
    &check::towards_the_part::LOWEST,
    &check::limited_wrapped::BEYOND_THE_TURN,
    &prove::NOT_PROVED,
    &c::NO_WORLD_COORDINATE,
];

/// Every code that machc knows, in the order of their ids.
pub fn all() -> Vec<&'static Code> {
    let lists: [&[&Code]; 8] = [
        &crate::syntax::parse::CODES,
        &CODES,
        &crate::model::controller::CODES,
        mach_runtime::cl::CODES,
        &mach_runtime::post::CODES,
        &mach_runtime::nc::write_error::CODES,
        &mach_runtime::verify::SUSPICIONS,
        &mach_runtime::verify::DIFFERENCES,
    ];
    let mut codes = lists.concat();
    codes.sort_by_key(|code| code.id);
    codes
}

#[cfg(test)]
mod tests {
    use super::all;

    #[test]
    fn no_two_codes_have_the_same_id() {
        for pair in all().windows(2) {
            assert!(pair[0].id < pair[1].id, "{} stands for two things", pair[0].id);
        }
    }

    #[test]
    fn every_code_explains_itself_on_one_screen() {
        for code in all() {
            assert!(!code.title.is_empty() && !code.title.ends_with('.'), "{}", code.id);
            assert!(code.explanation.len() > 40, "{}", code.id);
            assert!(code.explanation.lines().count() <= 24, "{} does not fit a screen", code.id);
        }
    }
}
