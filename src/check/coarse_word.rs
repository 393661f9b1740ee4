//! A word whose last digit is coarser than the machine's tolerance. Looks at the finished tables: it takes the controller's
//! pictures.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::Draft;
use crate::model::machine::Model;
use crate::model::quantity::readable;
use crate::model::source::{Located, Location};
use crate::model::tables;
use crate::syntax::tree::ControllerStatement;
use mach_runtime::coordinates::word_unit;
use mach_runtime::machine::{Axis, Motion};
use mach_runtime::nc::dialect::Word;
use mach_runtime::unit::LengthUnit;

/// A word that rounds by more than the tolerance.
pub(crate) static COARSE: Code = Code {
    id: "E0556",
    title: "a word is coarser than the machine's tolerance",
    explanation: "\
The digits behind the point in a format's picture are the resolution of its words. Half of the last one is what rounding may do
to a position; it must not be more than `tolerance chord` (0.01 mm where nothing is said). For a rotary axis it is what that
turn does 100 mm from the axis.

    format length \"####.#\"          // rounds by up to 0.05 mm
    word X length

Give the format more digits, or say that the machine need not be better: `tolerance chord 0.05 mm`.
",
};

/// The distance from a rotary axis at which its rounding is looked at.
const LEVER_MM: f64 = 100.0;

/// The first axis word of each `word` statement that is too coarse; `statements` are the controller's.
pub(crate) fn check(model: &Model, draft: &Draft<'_>, statements: &[Located<ControllerStatement>]) -> Vec<Diagnostic> {
    let Some(dialect) = &model.dialect else { return Vec::new() };
    let machine = tables::machine(model);
    let of_axis = |name: &str| machine.axes.iter().zip(&dialect.axes).find(|(axis, _)| axis.name == name);
    let mut told: Vec<&Location> = Vec::new();
    let found = statements.iter().filter_map(|statement| {
        let ControllerStatement::Word { names, .. } = &statement.value else { return None };
        let words = names.iter().filter_map(|name| of_axis(&name.value));
        let mut rounded = words.map(|(axis, word)| (axis, rounded_mm(axis, word, dialect.units)));
        let (axis, by_mm) = rounded.find(|(_, by_mm)| *by_mm > machine.chord_tolerance_mm)?;
        let is_new = !told.contains(&&statement.at);
        told.push(&statement.at);
        is_new.then(|| report(draft, &statement.at, axis, by_mm, machine.chord_tolerance_mm))
    });
    found.collect()
}

/// What rounding may do to the tip.
fn rounded_mm(axis: &Axis, word: &Word, units: LengthUnit) -> f64 {
    let half_digit = 0.5 * word.picture.value(1) * word_unit(axis.motion, units);
    match axis.motion {
        Motion::Linear => half_digit,
        Motion::Rotary => half_digit.to_radians() * LEVER_MM,
    }
}

fn report(draft: &Draft<'_>, at: &Location, axis: &Axis, by_mm: f64, tolerance_mm: f64) -> Diagnostic {
    let Axis { name, motion, .. } = axis;
    let by = readable((1e4 * by_mm).round() / 1e4);
    let place = match motion {
        Motion::Linear => String::new(),
        Motion::Rotary => format!(", {LEVER_MM} mm from its axis"),
    };
    let message = format!("the word {name} is coarser than the machine's tolerance");
    let label = format!("rounds by up to {by} mm{place}; the tolerance is {} mm", readable(tolerance_mm));
    super::error(draft, &COARSE, message, at, &label)
}
