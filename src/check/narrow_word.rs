//! A word too narrow for the travel of its axis. Looks at the finished tables: it takes the controller's pictures.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::Draft;
use crate::model::machine::Model;
use crate::model::quantity::readable;
use crate::model::source::Located;
use crate::model::tables;
use crate::syntax::tree::ControllerStatement;
use mach_runtime::coordinates::AxisOffset;
use mach_runtime::machine::{Axis, Motion, Written};
use mach_runtime::nc::dialect::Word;
use mach_runtime::unit::LengthUnit;

/// A word that cannot print every position of its axis.
pub(crate) static NARROW: Code = Code {
    id: "E0553",
    title: "a word is too narrow for the travel of its axis",
    explanation: "\
The digits before the point in a format's picture are the greatest number that its words can have. Every position of the
axis within its travel must fit (an axis without limits and written `unwound` is not checked).

    linear X along +x travel -1200 .. 1200
    format length \"###.###\"         // at most 999.999
    word X length                    // X1200. does not fit

Positions are counted from the program zero, which `zero` places in the machine frame, to the tip of the tool.
",
};

/// Every axis word that is too narrow; `statements` are the controller's, in which the words are looked up.
pub(crate) fn check(model: &Model, draft: &Draft<'_>, statements: &[Located<ControllerStatement>]) -> Vec<Diagnostic> {
    let Some(dialect) = &model.dialect else { return Vec::new() };
    let machine = tables::machine(model);
    let narrow = machine.axes.iter().zip(&dialect.axes).filter_map(|(axis, word)| {
        let greatest = greatest_written(axis, machine.tool().length_mm, word, dialect.units)?;
        word.picture.units(greatest).is_none().then_some((axis, word, greatest))
    });
    narrow.map(|(axis, word, greatest)| report(draft, statements, axis, word, greatest)).collect()
}

fn report(
    draft: &Draft<'_>,
    statements: &[Located<ControllerStatement>],
    axis: &Axis,
    word: &Word,
    greatest: f64,
) -> Diagnostic {
    let nines = |digits: u8| "9".repeat(usize::from(digits));
    let printable = format!("{}.{}", nines(word.picture.integer_digits), nines(word.picture.decimals));
    let message = format!("the word {} is too narrow: {} does not fit", axis.name, readable(greatest));
    let names_it = |statement: &&Located<ControllerStatement>| match &statement.value {
        ControllerStatement::Word { names, .. } => names.iter().any(|name| name.value == axis.name),
        _ => false,
    };
    let word_at = statements.iter().find(names_it).map(|said| (said.at.clone(), format!("prints at most {printable}")));
    let wrapped = matches!(axis.written, Written::Wrapped { .. });
    let travel = draft.axis(&axis.name).and_then(|(_, axis)| axis.travel.as_ref()).filter(|_| !wrapped);
    let travel_at = travel.map(|travel| (travel.at.clone(), format!("the travel of {}", axis.name)));
    let places = [word_at, travel_at].into_iter().flatten();
    places.fold(Diagnostic::error(&NARROW, message), |diagnostic, (at, label)| {
        diagnostic.at(draft.sources.place(&at), label)
    })
}

/// The greatest magnitude that the program may show; `None` without a limit.
fn greatest_written(axis: &Axis, tool_length_mm: f64, word: &Word, units: LengthUnit) -> Option<f64> {
    let programmed = |joint: f64| AxisOffset::of(axis).programmed(joint, tool_length_mm) / units.mm();
    let [lower, upper] = match (axis.motion, axis.written) {
        (Motion::Rotary, Written::Wrapped { from_deg }) => [from_deg, from_deg + 360.0 - word.picture.value(1)],
        (Motion::Rotary, Written::Unwound) => [axis.travel.lower, axis.travel.upper],
        (Motion::Linear, _) => [axis.travel.lower, axis.travel.upper].map(programmed),
    };
    Some(lower.abs().max(upper.abs())).filter(|greatest| greatest.is_finite())
}
