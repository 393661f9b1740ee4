//! Fields: what kind of quantity a statement takes, and the unit that a bare number has there.

use super::evaluate::{Evaluator, Known, SHAPE};
use super::parameter;
use super::quantity::{Dimension, Value, measure, readable};
use super::source::{Location, SourceId};
use crate::diagnostic::{Code, Diagnostic, Label, Suggestion};
use crate::syntax::tree::{Expression, ExpressionKind, Spanned, Unit};
use mach_runtime::machine::Motion;
use nalgebra::Vector3;

/// A quantity of another kind than the field takes.
pub(crate) static WRONG_UNIT: Code = Code {
    id: "E0403",
    title: "the unit does not fit the field",
    explanation: "\
Every field takes one kind of quantity, and a bare number has the field's own unit.

| field | kind | a bare number is in |
| --- | --- | --- |
| travel of a linear axis, points, `length`, `tolerance chord` | length | mm |
| travel of a rotary axis, `write`, `tolerance axis` | angle | deg |
| rapid of a linear axis | speed | mm/min |
| rapid of a rotary axis | turning speed | deg/min |
| directions | plain numbers (or lengths) | |

    linear X along +x travel -355 .. 355 deg     // a linear axis travels a length
    linear X along +x travel -355 .. 355 mm
",
};

/// A number no machine has.
pub(crate) static OUT_OF_RANGE: Code = Code {
    id: "E0409",
    title: "the number is too large, or not positive where it must be",
    explanation: "\
Lengths lie within a kilometre (1e6 mm), angles within 1e6 deg, speeds within 1e9 mm/min or deg/min. Tolerances and
rapid traverse are greater than zero; a tool's length is not negative.

    linear X along +x rapid 0 m/min       // an axis that cannot move
    tolerance chord -0.01 mm
",
};

/// What a field takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Field {
    Length,
    Angle,
    Speed,
    Turning,
}

/// Which values a field takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sign {
    Any,
    NotNegative,
    Positive,
}

impl Field {
    /// What an axis travels.
    pub(crate) fn travel(motion: Motion) -> Self {
        match motion {
            Motion::Linear => Self::Length,
            Motion::Rotary => Self::Angle,
        }
    }

    /// How fast it does.
    pub(crate) fn rapid(motion: Motion) -> Self {
        match motion {
            Motion::Linear => Self::Speed,
            Motion::Rotary => Self::Turning,
        }
    }

    fn dimension(self) -> Dimension {
        match self {
            Self::Length => Dimension::LENGTH,
            Self::Angle => Dimension::ANGLE,
            Self::Speed => Dimension::SPEED,
            Self::Turning => Dimension::TURNING,
        }
    }

    fn greatest(self) -> f64 {
        match self {
            Self::Length | Self::Angle => 1e6,
            Self::Speed | Self::Turning => 1e9,
        }
    }
}

impl Evaluator<'_> {
    /// A number in the field's base unit.
    pub(crate) fn number(
        &mut self,
        source: SourceId,
        expression: &Expression,
        field: Field,
        sign: Sign,
    ) -> Option<f64> {
        let value = self.evaluate(source, expression)?;
        let Value::Scalar(number, dimension) = value else {
            let message = format!("{} is needed here, and this is a vector", field.dimension().noun());
            self.report(&SHAPE, source, &expression.span, message, "a vector");
            return None;
        };
        self.fits(source, expression, dimension, field)?;
        self.in_range(source, expression, number, field, sign)
    }

    /// Two bounds in the field's base unit; a bare bound takes the unit of the other one.
    pub(crate) fn range(&mut self, source: SourceId, bounds: [&Expression; 2], field: Field) -> Option<[f64; 2]> {
        let values = bounds.map(|bound| self.number(source, bound, field, Sign::Any));
        let [Some(from), Some(to)] = values else { return None };
        Some([from * borrowed_size(bounds[0], bounds[1]), to * borrowed_size(bounds[1], bounds[0])])
    }

    /// A point in millimetres.
    pub(crate) fn point(&mut self, source: SourceId, expression: &Expression) -> Option<Vector3<f64>> {
        let (point, dimension) = self.three(source, expression, "a point such as `(0, 0, -20 mm)`")?;
        self.fits(source, expression, dimension, Field::Length)?;
        for component in &point {
            self.in_range(source, expression, *component, Field::Length, Sign::Any)?;
        }
        Some(point)
    }

    /// A direction of any length: plain numbers, or the way from one point to another.
    pub(crate) fn direction(&mut self, source: SourceId, expression: &Expression) -> Option<Vector3<f64>> {
        let (direction, dimension) = self.three(source, expression, "a direction such as `+x` or `(0, 1, 1)`")?;
        if dimension != Dimension::NUMBER {
            self.fits(source, expression, dimension, Field::Length)?;
        }
        Some(direction)
    }

    fn three(&mut self, source: SourceId, expression: &Expression, wanted: &str) -> Option<(Vector3<f64>, Dimension)> {
        match self.evaluate(source, expression)? {
            Value::Vector(vector, dimension) => Some((vector, dimension)),
            Value::Scalar(..) => {
                let message = format!("{wanted} is needed here, and this is a number");
                self.report(&SHAPE, source, &expression.span, message, "a number");
                None
            }
        }
    }

    fn fits(&mut self, source: SourceId, expression: &Expression, found: Dimension, field: Field) -> Option<()> {
        let wanted = field.dimension();
        if found == wanted || found == Dimension::NUMBER {
            return Some(());
        }
        let message = format!("{} is needed here, and this is {}", wanted.noun(), found.noun());
        let place = self.sources.place(&Location { source, span: expression.span.clone() });
        let mut diagnostic = Diagnostic::error(&WRONG_UNIT, message).at(place, found.noun());
        parameter::names(expression, &mut |name| {
            let Some(Known { value: Some(value), at }) = self.parameters.get(name) else { return };
            if value.dimension() != wanted && value.dimension() != Dimension::NUMBER {
                let label = format!("`{name}` is {}", value.dimension().noun());
                diagnostic.labels.push(Label { place: self.sources.place(at), text: label });
            }
        });
        let units = wanted.units();
        if let Some((_, Some(unit))) = literal(expression) {
            diagnostic = diagnostic.suggest(Suggestion {
                text: format!("a unit that fits: {}", units.join(", ")),
                place: self.sources.place(&Location { source, span: unit.span.clone() }),
                replacement: units[0].to_owned(),
            });
        }
        self.diagnostics.push(diagnostic);
        None
    }

    fn in_range(
        &mut self,
        source: SourceId,
        expression: &Expression,
        number: f64,
        field: Field,
        sign: Sign,
    ) -> Option<f64> {
        let unit = field.dimension().unit();
        let problem = match sign {
            _ if number.abs() > field.greatest() => format!("is more than {:e} {unit}", field.greatest()),
            Sign::Positive if number <= 0.0 => "must be greater than zero".to_owned(),
            Sign::NotNegative if number < 0.0 => "must not be negative".to_owned(),
            Sign::Any | Sign::Positive | Sign::NotNegative => return Some(number),
        };
        let message = format!("{} {unit} {problem}", readable(number));
        self.report(&OUT_OF_RANGE, source, &expression.span, message, "out of range");
        None
    }
}

/// A numeral, perhaps with signs and parentheses: its digits and unit.
fn literal(expression: &Expression) -> Option<(&str, Option<&Spanned<Unit>>)> {
    match expression.value.as_ref() {
        ExpressionKind::Number { digits, unit } => Some((digits, unit.as_ref())),
        ExpressionKind::Group(inner) | ExpressionKind::Sign { of: inner, .. } => literal(inner),
        _ => None,
    }
}

/// One of the unit that a bare numeral takes from its neighbour, in base units.
fn borrowed_size(bound: &Expression, neighbour: &Expression) -> f64 {
    match (literal(bound), literal(neighbour)) {
        (Some((_, None)), Some((_, Some(unit)))) => measure(unit.value).1,
        _ => 1.0,
    }
}
