//! Expressions: dimensions, vectors and names. The arithmetic itself is `scalar`'s.

pub(crate) mod arithmetic;
pub(crate) mod function;
mod scalar;

use super::lost::Lost;
use super::quantity::{Dimension, Value, measure};
use super::source::{Location, SourceId, SourceMap};
use crate::diagnostic::{Code, Diagnostic, Suggestion};
use crate::syntax::spelling::nearest;
use crate::syntax::tree::{Expression, ExpressionKind, Span, Spanned, Unit};
use arithmetic::UNITS_DO_NOT_FIT;
use function::Function;
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// A name that stands for nothing.
pub(crate) static UNKNOWN_NAME: Code = Code {
    id: "E0401",
    title: "unknown name in an expression",
    explanation: "\
An expression names a parameter that no `let` of the machine (or of the machine it is like) defines.

    let centre = -20 mm
    rotary A about +x through (0, 0, center)      // `center`?

Names that are always there: `pi`, and the unit vectors `x`, `y` and `z`. Define the parameter with `let`, or mend the
name. A controller's definition stands alone: it cannot name the parameters of a machine.
",
};

/// A vector where a number is needed, or the reverse.
pub(crate) static SHAPE: Code = Code {
    id: "E0406",
    title: "a vector where a number is needed, or the reverse",
    explanation: "\
Points and directions are vectors: `(0, 0, -20 mm)`, `+x`, `y + z`. Travel, lengths and tolerances are numbers.

    rotary A about 45 deg          // a direction is needed: (0, cos(45 deg), sin(45 deg))
    linear X along +x travel x .. y

Vectors can be added, subtracted, and multiplied or divided by a number. Their components are numbers.
",
};

/// A result that is no number.
pub(crate) static NOT_FINITE: Code = Code {
    id: "E0407",
    title: "the value of an expression is not a finite number",
    explanation: "\
The marked part of the expression has no value: a division by zero, the root of a negative number, the arc sine of a
number above one, the tangent of 90 degrees, or a result that is too large.

    let slope = tan(90 deg)
    let ratio = 1 / (2 - 2)
",
};

/// Evaluates the expressions of one machine. What is wrong with them is collected in `diagnostics`, each mistake once.
pub(crate) struct Evaluator<'a> {
    pub(crate) sources: &'a SourceMap,
    /// What is known of the parameters.
    pub(crate) parameters: BTreeMap<String, Known>,
    /// What may define others.
    lost: &'a Lost,
    pub(crate) diagnostics: Vec<Diagnostic>,
}

/// A parameter.
pub(crate) struct Known {
    /// `None` for one whose own expression is wrong, which has been said.
    pub(crate) value: Option<Value>,
    /// Its expression.
    pub(crate) at: Location,
}

impl<'a> Evaluator<'a> {
    /// Knows no parameters yet.
    pub(crate) fn new(sources: &'a SourceMap, lost: &'a Lost) -> Self {
        Self { sources, parameters: BTreeMap::new(), lost, diagnostics: Vec::new() }
    }

    /// The value in base units; `None` when something was wrong, which has been said.
    pub(crate) fn evaluate(&mut self, source: SourceId, expression: &Expression) -> Option<Value> {
        let span = &expression.span;
        let value = match expression.value.as_ref() {
            ExpressionKind::Broken(_) => None,
            ExpressionKind::Number { digits, unit } => Some(number(digits, unit.as_ref())),
            ExpressionKind::Name(name) => self.name(source, span, name),
            ExpressionKind::Group(inner) => self.evaluate(source, inner),
            ExpressionKind::Sign { minus, of } => self.evaluate(source, of).map(|value| signed(*minus, value)),
            ExpressionKind::Vector(components) => self.vector(source, components),
            ExpressionKind::Binary { operator, left, right } => self.binary(source, *operator, [left, right]),
            ExpressionKind::Call { function, arguments } => self.call(source, function, arguments),
        }?;
        self.finite(source, span, value)
    }

    /// A mistake at a span.
    pub(crate) fn report(&mut self, code: &'static Code, source: SourceId, span: &Span, message: String, label: &str) {
        let place = self.place(source, span);
        self.diagnostics.push(Diagnostic::error(code, message).at(place, label));
    }

    pub(super) fn place(&self, source: SourceId, span: &Span) -> mach_runtime::diagnostic::Place {
        self.sources.place(&Location { source, span: span.clone() })
    }

    fn finite(&mut self, source: SourceId, span: &Span, value: Value) -> Option<Value> {
        let finite = match value {
            Value::Scalar(number, _) => number.is_finite(),
            Value::Vector(vector, _) => vector.iter().all(|component| component.is_finite()),
        };
        if !finite {
            let message = "this expression has no finite value".to_owned();
            self.report(&NOT_FINITE, source, span, message, "not a finite number");
        }
        finite.then_some(value)
    }

    fn name(&mut self, source: SourceId, span: &Span, name: &str) -> Option<Value> {
        if let Some(value) = constant(name) {
            return Some(value);
        }
        if let Some(known) = self.parameters.get(name) {
            return known.value;
        }
        if self.lost.may_say(&["let"], name) {
            return None;
        }
        let place = self.place(source, span);
        let mut diagnostic =
            Diagnostic::error(&UNKNOWN_NAME, format!("`{name}` is not defined")).at(place.clone(), "unknown name");
        let known = self.parameters.keys().map(String::as_str).chain(CONSTANTS);
        if let Some(meant) = nearest(name, known) {
            let text = format!("did you mean `{meant}`?");
            diagnostic = diagnostic.suggest(Suggestion { text, place, replacement: meant.to_owned() });
        }
        self.diagnostics.push(diagnostic);
        None
    }

    fn scalar(&mut self, source: SourceId, expression: &Expression) -> Option<(f64, Dimension)> {
        match self.evaluate(source, expression)? {
            Value::Scalar(value, dimension) => Some((value, dimension)),
            Value::Vector(..) => {
                let message = "a number is needed here, and this is a vector".to_owned();
                self.report(&SHAPE, source, &expression.span, message, "a vector");
                None
            }
        }
    }

    /// Components of one dimension; bare ones take the base unit of the others.
    fn vector(&mut self, source: SourceId, components: &[Expression; 3]) -> Option<Value> {
        let values = components.each_ref().map(|component| self.scalar(source, component));
        let [Some(x), Some(y), Some(z)] = values else { return None };
        let values = [x, y, z];
        let dimension = values.iter().map(|value| value.1).find(|it| *it != Dimension::NUMBER);
        let dimension = dimension.unwrap_or(Dimension::NUMBER);
        for (value, component) in values.iter().zip(components) {
            if value.1 != dimension && value.1 != Dimension::NUMBER {
                let message = format!("a vector of {} and {}", dimension.noun(), value.1.noun());
                let label = format!("{}, and not {}", value.1.noun(), dimension.noun());
                self.report(&UNITS_DO_NOT_FIT, source, &component.span, message, &label);
                return None;
            }
        }
        Some(Value::Vector(Vector3::from(values.map(|value| value.0)), dimension))
    }

    fn call(&mut self, source: SourceId, name: &Spanned<String>, arguments: &[Expression]) -> Option<Value> {
        let function = function::find(self, source, name, arguments);
        let values: Vec<_> = arguments.iter().map(|argument| self.scalar(source, argument)).collect();
        let function: &Function = function?;
        let values: Vec<(f64, Dimension)> = values.into_iter().collect::<Option<_>>()?;
        let dimension = function::dimension(self, source, function, arguments, &values)?;
        let numbers: Vec<f64> = values.iter().map(|value| value.0).collect();
        Some(Value::Scalar(scalar::evaluate(function.formula, &numbers), dimension))
    }

    /// A unit for a bare numeral.
    pub(crate) fn suggest_unit(&self, source: SourceId, bare: &Expression, wanted: Dimension) -> Option<Suggestion> {
        let ExpressionKind::Number { digits, unit: None } = bare.value.as_ref() else { return None };
        let unit = wanted.units().first().copied()?;
        let text = format!("give it a unit: {}", wanted.units().join(", "));
        Some(Suggestion { text, place: self.place(source, &bare.span), replacement: format!("{digits} {unit}") })
    }
}

/// The names that are always known.
pub(crate) const CONSTANTS: [&str; 4] = ["pi", "x", "y", "z"];

fn constant(name: &str) -> Option<Value> {
    match name {
        "pi" => Some(Value::Scalar(std::f64::consts::PI, Dimension::NUMBER)),
        "x" => Some(Value::Vector(Vector3::x(), Dimension::NUMBER)),
        "y" => Some(Value::Vector(Vector3::y(), Dimension::NUMBER)),
        "z" => Some(Value::Vector(Vector3::z(), Dimension::NUMBER)),
        _ => None,
    }
}

fn number(digits: &str, unit: Option<&Spanned<Unit>>) -> Value {
    let number: f64 = digits.parse().expect("the grammar admits only numerals");
    let (dimension, size) = unit.map_or((Dimension::NUMBER, 1.0), |unit| measure(unit.value));
    Value::Scalar(scalar::evaluate("a * b", &[number, size]), dimension)
}

fn signed(minus: bool, value: Value) -> Value {
    let sign = |a: f64| scalar::evaluate(if minus { "-a" } else { "a" }, &[a]);
    match value {
        Value::Scalar(a, dimension) => Value::Scalar(sign(a), dimension),
        Value::Vector(v, dimension) => Value::Vector(v.map(sign), dimension),
    }
}
