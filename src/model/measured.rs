//! `error` statements: a name of ISO 230, and a value or a table of values.

use super::draft::{Draft, ErrorDraft, Measured, MeasuredRow};
use super::error_name::ErrorName;
use super::evaluate::Evaluator;
use super::field::{Field, Sign};
use super::source::{Located, Location};
use crate::diagnostic::{Code, Diagnostic, Suggestion};
use crate::syntax::spelling::nearest;
use crate::syntax::tree::{Body, ErrorRow, MachineStatement, Name};
use mach_runtime::machine::{Component, Motion};

/// A name that is no error's.
pub(crate) static UNKNOWN_ERROR: Code = Code {
    id: "E0220",
    title: "unknown error of the machine",
    explanation: "\
Errors have the names of ISO 230: `E`, then X, Y or Z for a shift or A, B or C for a turn (along or about x, y or z of the
frame), then the axis that does it. A zero in between says where the axis lies at whatever position.

    error EX0C 12 um                     // the line of C is shifted along x
    error EA0C 20 urad                   // … and turned about x
    error EC0Y -15 urad                  // Y is not square to X (EC(0X)Y)
    error EYX { at 0: 0 at 300: 4 um }   // X is not straight: it shifts along y

The axis is one that the machine has.
",
};

/// A value where a table is needed, or the reverse.
pub(crate) static WRONG_FORM: Code = Code {
    id: "E0221",
    title: "an error is told by a value where it depends on the position, or the reverse",
    explanation: "\
With a zero in its name an error is where the axis lies: one value. Without it the error depends on the position of the
axis: a table.

    error EX0C 12 um
    error EXX {
        at -300 mm: 4 um
        at    0 mm: 0
        at  300 mm: -2 um
    }

Between two positions the error is taken as linear, beyond the ends as what it is there.
",
};

/// Evaluates the statements about errors, once the axes are known.
pub(super) fn errors(evaluator: &mut Evaluator<'_>, draft: &mut Draft<'_>, statements: &[Located<MachineStatement>]) {
    for statement in statements {
        let said = match &statement.value {
            MachineStatement::Error { name, value } => Said { name, value: Err(value), at: &statement.at },
            MachineStatement::ErrorTable { name, rows } => Said { name, value: Ok(rows), at: &statement.at },
            _ => continue,
        };
        let error = said.evaluate(evaluator, draft);
        draft.errors.extend(error);
    }
}

struct Said<'s> {
    name: &'s Name,
    /// A table or a value.
    value: Result<&'s Body<ErrorRow>, &'s crate::syntax::tree::Expression>,
    at: &'s Location,
}

impl Said<'_> {
    fn evaluate(&self, evaluator: &mut Evaluator<'_>, draft: &Draft<'_>) -> Option<ErrorDraft> {
        let source = self.at.source;
        let read = ErrorName::read(&self.name.value);
        let known = read.and_then(|name| Some((name, draft.axis(name.axis)?)));
        if known.is_none() && read.is_some_and(|name| draft.may_lack_axis(name.axis)) {
            return None;
        }
        let Some((name, (axis, declared))) = known else {
            evaluator.diagnostics.push(self.unknown(evaluator, draft, read));
            return None;
        };
        let field = if name.component.is_turn() { Field::Angle } else { Field::Length };
        let measured = match (self.value, name.is_location) {
            (Err(value), true) => Measured::Location(evaluator.number(source, value, field, Sign::Any)?),
            (Ok(rows), false) => self.table(evaluator, rows, Field::travel(declared.motion), field),
            (Ok(rows), true) if !rows.broken.is_empty() => return None,
            (_, is_location) => {
                evaluator.diagnostics.push(self.wrong_form(evaluator, name, is_location));
                return None;
            }
        };
        let at = self.at.with(&self.name.span);
        Some(ErrorDraft { name: Located { value: name.canonical(), at }, axis, component: name.component, measured })
    }

    fn table(&self, evaluator: &mut Evaluator<'_>, rows: &Body<ErrorRow>, position: Field, error: Field) -> Measured {
        let source = self.at.source;
        let measured = rows.statements.iter().filter_map(|row| {
            let position = evaluator.number(source, &row.node.position, position, Sign::Any);
            let error = evaluator.number(source, &row.node.error, error, Sign::Any);
            Some(Located { value: (position?, error?), at: self.at.with(&row.span) })
        });
        let measured: Vec<MeasuredRow> = measured.collect();
        let is_whole = rows.broken.is_empty() && measured.len() == rows.statements.len();
        Measured::Table { rows: measured, is_whole }
    }

    fn unknown(&self, evaluator: &Evaluator<'_>, draft: &Draft<'_>, read: Option<ErrorName<'_>>) -> Diagnostic {
        let place = evaluator.place(self.at.source, &self.name.span);
        let (message, label) = match read {
            Some(name) => (format!("the machine has no axis `{}`", name.axis), "an error of no axis"),
            None => (format!("`{}` is no error of ISO 230", self.name.value), "unknown error"),
        };
        let diagnostic = Diagnostic::error(&UNKNOWN_ERROR, message).at(place.clone(), label);
        let names = names(draft, self.value.is_err(), read.map(|name| name.component));
        let with_e = format!("E{}", self.name.value);
        let meant = if read.is_none() && ErrorName::read(&with_e).is_some() {
            Some(with_e.as_str())
        } else {
            nearest(&self.name.value, names.iter().map(String::as_str))
        };
        match meant {
            Some(meant) => diagnostic.suggest(Suggestion {
                text: format!("did you mean `{meant}`?"),
                place,
                replacement: meant.to_owned(),
            }),
            None => diagnostic.note(format!("there may be {}", shown(&names))),
        }
    }

    fn wrong_form(&self, evaluator: &Evaluator<'_>, name: ErrorName<'_>, is_location: bool) -> Diagnostic {
        let (written, axis) = (&self.name.value, name.axis);
        let (message, note) = match is_location {
            true => (
                format!("{written} does not depend on the position of {axis}: it has one value"),
                format!("write `error {written} VALUE`"),
            ),
            false => (
                format!("{written} depends on the position of {axis}: it has a table"),
                format!("write `error {written} {{ at POSITION: VALUE … }}`"),
            ),
        };
        Diagnostic::error(&WRONG_FORM, message).at(evaluator.place(self.at.source, &self.name.span), "").note(note)
    }
}

/// The errors that the machine's axes can have, by their names; perhaps of one component only.
fn names(draft: &Draft<'_>, of_location: bool, only: Option<Component>) -> Vec<String> {
    let of_axis = |axis: &crate::model::draft::AxisDraft| {
        let name = |component| ErrorName { component, is_location: of_location, axis: &axis.name.value }.canonical();
        let has_place = axis.motion == Motion::Rotary || !of_location;
        let is_asked = move |component: &Component| only.is_none_or(|only| only == *component);
        let components = Component::ALL.into_iter().filter(is_asked);
        let components = components.filter(move |component| has_place || component.is_turn());
        components.map(name).collect::<Vec<_>>()
    };
    draft.axes.iter().flat_map(of_axis).collect()
}

/// The first names of many.
fn shown(names: &[String]) -> String {
    const MOST: usize = 6;
    let list = names.iter().take(MOST).map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    if names.len() > MOST { format!("{list} and so on") } else { list }
}
