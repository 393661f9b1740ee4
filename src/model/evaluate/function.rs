//! The functions of expressions: what they take and what they give.

use super::Evaluator;
use super::arithmetic::UNITS_DO_NOT_FIT;
use crate::diagnostic::{Code, Diagnostic, Suggestion};
use crate::model::quantity::Dimension;
use crate::model::source::{Location, SourceId};
use crate::syntax::spelling::nearest;
use crate::syntax::tree::{Expression, Spanned};

/// A function that does not exist, or with other arguments.
pub(crate) static UNKNOWN_FUNCTION: Code = Code {
    id: "E0402",
    title: "unknown function, or a wrong number of arguments",
    explanation: "\
The functions are:

| function | takes | gives |
| --- | --- | --- |
| `sin(a)` `cos(a)` `tan(a)` | an angle | a plain number |
| `asin(n)` `acos(n)` `atan(n)` | a plain number | an angle |
| `atan2(y, x)` | two of the same kind | an angle |
| `sqrt(a)` | a plain number or a square | its root |
| `abs(a)` | anything | the same kind |
| `min(a, b)` `max(a, b)` | two of the same kind | the same kind |
",
};

/// An angle without a unit.
pub(crate) static ANGLE_NEEDS_UNIT: Code = Code {
    id: "E0405",
    title: "the angle needs a unit",
    explanation: "\
`sin`, `cos` and `tan` take an angle, and a bare number could be degrees or radians.

    let a = cos(60)            // degrees or radians?
    let b = cos(60 deg)        // 0.5
    let c = cos(pi/3 * 1 rad)  // 0.5
",
};

/// A function.
pub(crate) struct Function {
    name: &'static str,
    arguments: usize,
    /// What `scalar` evaluates.
    pub(crate) formula: &'static str,
    kind: Kind,
}

/// How the result's dimension follows from the arguments'.
#[derive(Clone, Copy)]
enum Kind {
    /// Of an angle, a number.
    Circular,
    /// Of numbers, an angle.
    Inverse,
    /// Of two of the same kind, an angle.
    Quotient,
    /// The root.
    Root,
    /// Of one or several of the same kind, that kind.
    Same,
}

const fn row(name: &'static str, arguments: usize, formula: &'static str, kind: Kind) -> Function {
    Function { name, arguments, formula, kind }
}

static FUNCTIONS: [Function; 11] = [
    row("sin", 1, "sin(a)", Kind::Circular),
    row("cos", 1, "cos(a)", Kind::Circular),
    row("tan", 1, "tan(a)", Kind::Circular),
    row("asin", 1, "asin(a)", Kind::Inverse),
    row("acos", 1, "acos(a)", Kind::Inverse),
    row("atan", 1, "atan(a)", Kind::Inverse),
    row("atan2", 2, "atan2(a, b)", Kind::Quotient),
    row("sqrt", 1, "sqrt(a)", Kind::Root),
    row("abs", 1, "abs(a)", Kind::Same),
    row("min", 2, "min(a, b)", Kind::Same),
    row("max", 2, "max(a, b)", Kind::Same),
];

/// The function of this name, which takes that many arguments.
pub(crate) fn find(
    evaluator: &mut Evaluator<'_>,
    source: SourceId,
    name: &Spanned<String>,
    arguments: &[Expression],
) -> Option<&'static Function> {
    let sources = evaluator.sources;
    let place = || sources.place(&Location { source, span: name.span.clone() });
    let Some(function) = FUNCTIONS.iter().find(|function| function.name == name.value) else {
        let message = format!("there is no function `{}`", name.value);
        let mut diagnostic = Diagnostic::error(&UNKNOWN_FUNCTION, message).at(place(), "unknown function");
        if let Some(meant) = nearest(&name.value, FUNCTIONS.iter().map(|function| function.name)) {
            let text = format!("did you mean `{meant}`?");
            diagnostic = diagnostic.suggest(Suggestion { text, place: place(), replacement: meant.to_owned() });
        }
        evaluator.diagnostics.push(diagnostic);
        return None;
    };
    if arguments.len() != function.arguments {
        let message =
            format!("`{}` takes {}, and here are {}", name.value, counted(function.arguments), arguments.len());
        evaluator.diagnostics.push(Diagnostic::error(&UNKNOWN_FUNCTION, message).at(place(), ""));
        return None;
    }
    Some(function)
}

fn counted(arguments: usize) -> &'static str {
    if arguments == 1 { "one argument" } else { "two arguments" }
}

/// The dimension of the result.
pub(crate) fn dimension(
    evaluator: &mut Evaluator<'_>,
    source: SourceId,
    function: &Function,
    arguments: &[Expression],
    values: &[(f64, Dimension)],
) -> Option<Dimension> {
    let (first, last) = (values[0].1, values[values.len() - 1].1);
    if first != last {
        let sides = [&arguments[0], &arguments[values.len() - 1]];
        evaluator.do_not_fit(source, &format!("do not fit into `{}`", function.name), sides, [first, last]);
        return None;
    }
    let result = match function.kind {
        Kind::Circular => (first == Dimension::ANGLE).then_some(Dimension::NUMBER),
        Kind::Inverse => (first == Dimension::NUMBER).then_some(Dimension::ANGLE),
        Kind::Quotient => Some(Dimension::ANGLE),
        Kind::Root => first.root(),
        Kind::Same => Some(first),
    };
    if result.is_none() {
        wrong_argument(evaluator, source, function, &arguments[0], first);
    }
    result
}

fn wrong_argument(
    evaluator: &mut Evaluator<'_>,
    source: SourceId,
    function: &Function,
    argument: &Expression,
    found: Dimension,
) {
    let wanted = match function.kind {
        Kind::Circular => "an angle",
        Kind::Root => "a plain number or a square",
        Kind::Inverse | Kind::Quotient | Kind::Same => "a plain number",
    };
    let message = format!("`{}` takes {wanted}, and this is {}", function.name, found.noun());
    let bare_angle = matches!(function.kind, Kind::Circular) && found == Dimension::NUMBER;
    let code = if bare_angle { &ANGLE_NEEDS_UNIT } else { &UNITS_DO_NOT_FIT };
    let place = evaluator.sources.place(&Location { source, span: argument.span.clone() });
    let mut diagnostic = Diagnostic::error(code, message).at(place, found.noun());
    if bare_angle {
        diagnostic.suggestion = evaluator.suggest_unit(source, argument, Dimension::ANGLE).map(Box::new);
    }
    evaluator.diagnostics.push(diagnostic);
}
