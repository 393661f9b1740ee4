//! The operators of expressions, on numbers and vectors with dimensions.

use super::{Evaluator, SHAPE, scalar};
use crate::diagnostic::{Code, Diagnostic};
use crate::model::quantity::{Dimension, Value};
use crate::model::source::SourceId;
use crate::syntax::tree::{Expression, Operator};

/// Two quantities that cannot be combined.
pub(crate) static UNITS_DO_NOT_FIT: Code = Code {
    id: "E0404",
    title: "these units do not fit together",
    explanation: "\
Only quantities of the same kind can be added, subtracted or compared, and a bare number is not a length or an angle
inside an expression.

    let a = 20 mm + 5          // 5 what?
    let b = 20 mm + 5 mm       // 25 mm
    let c = 2 * 20 mm          // 40 mm: a factor needs no unit

A bare number takes the unit of its field only where it stands alone: `travel -30 .. 120`. An exponent is a plain
number, and a whole one where the base has a unit; a square root needs a square.
",
};

impl Evaluator<'_> {
    /// The value of an operation.
    pub(super) fn binary(&mut self, source: SourceId, operator: Operator, sides: [&Expression; 2]) -> Option<Value> {
        let (left, right) = (self.evaluate(source, sides[0]), self.evaluate(source, sides[1]));
        let (left, right) = (left?, right?);
        match operator {
            Operator::Add => self.sum(source, ("a + b", "added"), sides, [left, right]),
            Operator::Subtract => self.sum(source, ("a - b", "subtracted"), sides, [left, right]),
            Operator::Multiply => self.product(source, sides, left, right),
            Operator::Divide => self.quotient(source, sides, left, right),
            Operator::Power => self.power(source, sides, left, right),
        }
    }

    fn sum(
        &mut self,
        source: SourceId,
        (formula, done): (&str, &str),
        sides: [&Expression; 2],
        values: [Value; 2],
    ) -> Option<Value> {
        let (left, right) = (values[0].dimension(), values[1].dimension());
        if left != right {
            self.do_not_fit(source, &format!("cannot be {done}"), sides, [left, right]);
            return None;
        }
        match values {
            [Value::Scalar(a, _), Value::Scalar(b, _)] => Some(Value::Scalar(scalar::evaluate(formula, &[a, b]), left)),
            [Value::Vector(a, _), Value::Vector(b, _)] => {
                Some(Value::Vector(a.zip_map(&b, |a, b| scalar::evaluate(formula, &[a, b])), left))
            }
            [Value::Scalar(..), Value::Vector(..)] | [Value::Vector(..), Value::Scalar(..)] => {
                let span = sides[0].span.start..sides[1].span.end;
                let message = format!("a number and a vector cannot be {done}");
                self.report(&SHAPE, source, &span, message, "");
                None
            }
        }
    }

    fn product(&mut self, source: SourceId, sides: [&Expression; 2], left: Value, right: Value) -> Option<Value> {
        let Some(dimension) = left.dimension().times(right.dimension()) else {
            return self.beyond_reason(source, sides);
        };
        let times = |a: f64, b: f64| scalar::evaluate("a * b", &[a, b]);
        match (left, right) {
            (Value::Scalar(a, _), Value::Scalar(b, _)) => Some(Value::Scalar(times(a, b), dimension)),
            (Value::Scalar(a, _), Value::Vector(v, _)) | (Value::Vector(v, _), Value::Scalar(a, _)) => {
                Some(Value::Vector(v.map(|component| times(component, a)), dimension))
            }
            (Value::Vector(..), Value::Vector(..)) => {
                let message = "vectors cannot be multiplied with each other".to_owned();
                self.report(&SHAPE, source, &sides[1].span, message, "a vector");
                None
            }
        }
    }

    fn quotient(&mut self, source: SourceId, sides: [&Expression; 2], left: Value, right: Value) -> Option<Value> {
        let Some(dimension) = left.dimension().over(right.dimension()) else {
            return self.beyond_reason(source, sides);
        };
        let over = |a: f64, b: f64| scalar::evaluate("a / b", &[a, b]);
        match (left, right) {
            (Value::Scalar(a, _), Value::Scalar(b, _)) => Some(Value::Scalar(over(a, b), dimension)),
            (Value::Vector(v, _), Value::Scalar(b, _)) => {
                Some(Value::Vector(v.map(|component| over(component, b)), dimension))
            }
            (_, Value::Vector(..)) => {
                let message = "nothing can be divided by a vector".to_owned();
                self.report(&SHAPE, source, &sides[1].span, message, "a vector");
                None
            }
        }
    }

    fn power(&mut self, source: SourceId, sides: [&Expression; 2], left: Value, right: Value) -> Option<Value> {
        let (Value::Scalar(base, dimension), Value::Scalar(exponent, exponent_dimension)) = (left, right) else {
            let span = sides[0].span.start..sides[1].span.end;
            self.report(&SHAPE, source, &span, "a power is made of two numbers, not of a vector".to_owned(), "");
            return None;
        };
        if exponent_dimension != Dimension::NUMBER {
            let message = "an exponent is a plain number".to_owned();
            self.report(&UNITS_DO_NOT_FIT, source, &sides[1].span, message, &exponent_dimension.noun());
            return None;
        }
        let whole = exponent.fract() == 0.0 && exponent.abs() <= 8.0;
        let dimension = match dimension {
            Dimension::NUMBER => Some(Dimension::NUMBER),
            _ if whole => dimension.power(exponent as i8),
            _ => None,
        };
        let Some(dimension) = dimension else { return self.beyond_reason(source, sides) };
        Some(Value::Scalar(scalar::evaluate("pow(a, b)", &[base, exponent]), dimension))
    }

    /// Says that two quantities differ in kind, and offers a unit where one of them is a bare number.
    pub(crate) fn do_not_fit(
        &mut self,
        source: SourceId,
        cannot: &str,
        sides: [&Expression; 2],
        dimensions: [Dimension; 2],
    ) {
        let [left, right] = dimensions;
        let message = format!("{} and {} {cannot}", left.noun(), right.noun());
        let mut diagnostic = Diagnostic::error(&UNITS_DO_NOT_FIT, message)
            .at(self.place(source, &sides[1].span), right.noun())
            .at(self.place(source, &sides[0].span), left.noun());
        let bare = if right == Dimension::NUMBER { (sides[1], left) } else { (sides[0], right) };
        if dimensions.contains(&Dimension::NUMBER) {
            diagnostic.suggestion = self.suggest_unit(source, bare.0, bare.1).map(Box::new);
        }
        self.diagnostics.push(diagnostic);
    }

    fn beyond_reason(&mut self, source: SourceId, sides: [&Expression; 2]) -> Option<Value> {
        let span = sides[0].span.start..sides[1].span.end;
        let message = "no quantity has such a unit".to_owned();
        self.report(&UNITS_DO_NOT_FIT, source, &span, message, "its unit has no whole, small exponents");
        None
    }
}
