//! What one of the feed word is in a program in inches.

use super::lowering::Lowering;
use super::word::{FEED, Said};
use crate::model::quantity::{Dimension, measure};
use crate::syntax::tree::{ControllerStatement, Expression, ExpressionKind};
use mach_runtime::diagnostic::Code;

/// A unit that is none of a feed.
pub(super) static BAD_UNIT: Code = Code {
    id: "E0537",
    title: "what one of the feed word is in inches is a speed",
    explanation: "\
Some controls count the feed of a program in inches in tenths of an inch a minute. The word of the feed says so by a number with its
unit, a whole number of micrometres a minute; where nothing is said, it is an inch a minute:

    word F feed inch 0.1 in/min
    word X length inch 0.1 in/min     // only the feed
",
};

/// An inch a minute, where nothing is said.
const INCH_UM: u32 = 25_400;

/// Reports what is none of a feed.
pub(super) fn check(lowering: &mut Lowering<'_>) {
    for (index, statement) in lowering.statements() {
        let ControllerStatement::Word { names, inch: Some(inch), .. } = statement else { continue };
        if um(inch).is_none() || names.iter().any(|name| name.value != FEED) {
            let label = "a number with a unit such as `in/min` is expected, of the word `F`";
            lowering.report(&BAD_UNIT, "this is not what one of the feed word is", index, &inch.span, label);
        }
    }
}

/// What one is in a program in inches, in micrometres a minute.
pub(super) fn inch_um(lowering: &Lowering<'_>) -> u32 {
    Said::last(lowering, FEED).and_then(|said| um(said.inch?)).unwrap_or(INCH_UM)
}

/// Whole micrometres a minute.
fn um(expression: &Expression) -> Option<u32> {
    let ExpressionKind::Number { digits, unit: Some(unit) } = &*expression.value else { return None };
    let (dimension, size) = measure(unit.value);
    let value_um = 1000.0 * digits.parse::<f64>().ok()? * size;
    let is_whole = (value_um - value_um.round()).abs() < 1e-6 && (1.0..=1e9).contains(&value_um);
    (dimension == Dimension::SPEED && is_whole).then_some(value_um.round() as u32)
}
