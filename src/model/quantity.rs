//! Dimensions, units and values of expressions. Base units: millimetre, degree, minute.

use crate::syntax::tree::Unit;
use mach_runtime::unit::LengthUnit;
use nalgebra::Vector3;

/// Exponents of length, angle and time. All zero: a plain number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Dimension {
    length: i8,
    angle: i8,
    time: i8,
}

impl Dimension {
    pub(crate) const NUMBER: Self = Self { length: 0, angle: 0, time: 0 };
    pub(crate) const LENGTH: Self = Self { length: 1, angle: 0, time: 0 };
    pub(crate) const ANGLE: Self = Self { length: 0, angle: 1, time: 0 };
    pub(crate) const SPEED: Self = Self { length: 1, angle: 0, time: -1 };
    pub(crate) const TURNING: Self = Self { length: 0, angle: 1, time: -1 };

    /// Of the product; `None` where an exponent leaves all reason.
    pub(crate) fn times(self, other: Self) -> Option<Self> {
        self.zip(other, i8::checked_add)
    }

    /// Of the quotient.
    pub(crate) fn over(self, other: Self) -> Option<Self> {
        self.zip(other, i8::checked_sub)
    }

    /// Of a power with a whole exponent.
    pub(crate) fn power(self, exponent: i8) -> Option<Self> {
        self.zip(Self { length: exponent, angle: exponent, time: exponent }, i8::checked_mul)
    }

    /// Of the square root; `None` for an odd exponent.
    pub(crate) fn root(self) -> Option<Self> {
        let halve = |exponent: i8, _| (exponent % 2 == 0).then_some(exponent / 2);
        self.zip(self, halve)
    }

    fn zip(self, other: Self, f: impl Fn(i8, i8) -> Option<i8>) -> Option<Self> {
        Some(Self {
            length: f(self.length, other.length)?,
            angle: f(self.angle, other.angle)?,
            time: f(self.time, other.time)?,
        })
    }

    /// What people call it: "a length".
    pub(crate) fn noun(self) -> String {
        match self {
            Self::NUMBER => "a plain number".to_owned(),
            Self::LENGTH => "a length".to_owned(),
            Self::ANGLE => "an angle".to_owned(),
            Self::SPEED => "a speed".to_owned(),
            Self::TURNING => "a turning speed".to_owned(),
            _ => format!("a quantity in {}", self.unit()),
        }
    }

    /// Its base unit (`mm`, `deg/min`, `mm^2`); empty for a plain number.
    pub(crate) fn unit(self) -> String {
        let factors = [("mm", self.length), ("deg", self.angle), ("min", self.time)];
        let product = |sign: i8| -> Vec<String> {
            let named = factors.iter().filter(|(_, exponent)| exponent.signum() == sign);
            named.map(|(name, exponent)| power_of(name, exponent.unsigned_abs())).collect()
        };
        let (above, below) = (product(1).join("*"), product(-1).join("/"));
        match (above.is_empty(), below.is_empty()) {
            (_, true) => above,
            (true, false) => format!("1/{below}"),
            (false, false) => format!("{above}/{below}"),
        }
    }

    /// The units of the language that measure it, as they are written; the base unit first.
    pub(crate) fn units(self) -> Vec<&'static str> {
        UNITS.iter().filter(|row| row.dimension == self).map(|row| row.unit.symbol()).collect()
    }
}

fn power_of(name: &str, exponent: u8) -> String {
    if exponent == 1 { name.to_owned() } else { format!("{name}^{exponent}") }
}

/// A unit of the language.
struct UnitRow {
    unit: Unit,
    dimension: Dimension,
    /// One of it in base units.
    size: f64,
}

const fn row(unit: Unit, dimension: Dimension, size: f64) -> UnitRow {
    UnitRow { unit, dimension, size }
}

const DEG_PER_RAD: f64 = 180.0 / std::f64::consts::PI;

static UNITS: [UnitRow; 16] = [
    row(Unit::Millimetre, Dimension::LENGTH, 1.0),
    row(Unit::Micrometre, Dimension::LENGTH, 1e-3),
    row(Unit::Metre, Dimension::LENGTH, 1e3),
    row(Unit::Inch, Dimension::LENGTH, LengthUnit::Inch.mm()),
    row(Unit::Degree, Dimension::ANGLE, 1.0),
    row(Unit::Radian, Dimension::ANGLE, DEG_PER_RAD),
    row(Unit::Milliradian, Dimension::ANGLE, DEG_PER_RAD * 1e-3),
    row(Unit::Microradian, Dimension::ANGLE, DEG_PER_RAD * 1e-6),
    row(Unit::Arcsecond, Dimension::ANGLE, 1.0 / 3600.0),
    row(Unit::MillimetrePerMinute, Dimension::SPEED, 1.0),
    row(Unit::MetrePerMinute, Dimension::SPEED, 1e3),
    row(Unit::MillimetrePerSecond, Dimension::SPEED, 60.0),
    row(Unit::InchPerMinute, Dimension::SPEED, LengthUnit::Inch.mm()),
    row(Unit::DegreePerMinute, Dimension::TURNING, 1.0),
    row(Unit::DegreePerSecond, Dimension::TURNING, 60.0),
    row(Unit::RevolutionPerMinute, Dimension::TURNING, 360.0),
];

/// What a unit measures, and one of it in base units.
pub(crate) fn measure(unit: Unit) -> (Dimension, f64) {
    let row = UNITS.iter().find(|row| row.unit == unit).expect("every unit has its row");
    (row.dimension, row.size)
}

/// The value of an expression, in base units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Value {
    /// One number.
    Scalar(f64, Dimension),
    /// Three of the same dimension.
    Vector(Vector3<f64>, Dimension),
}

impl Value {
    pub(crate) fn dimension(self) -> Dimension {
        match self {
            Self::Scalar(_, dimension) | Self::Vector(_, dimension) => dimension,
        }
    }

    /// As a person would write it: `-20 mm`, `(0, 0, 1)`.
    pub(crate) fn display(self) -> String {
        let number = match self {
            Self::Scalar(value, _) => readable(value),
            Self::Vector(v, _) => format!("({}, {}, {})", readable(v.x), readable(v.y), readable(v.z)),
        };
        let unit = self.dimension().unit();
        if unit.is_empty() { number } else { format!("{number} {unit}") }
    }
}

/// A number with at most twelve significant digits: what arithmetic added at the end is not shown.
pub(crate) fn readable(value: f64) -> String {
    let rounded: f64 = format!("{value:.11e}").parse().expect("a printed number can be read");
    format!("{}", rounded + 0.0)
}

#[cfg(test)]
mod tests {
    use super::{Dimension, UNITS, Value, readable};

    #[test]
    fn values_are_shown_as_people_write_them() {
        assert_eq!(Value::Scalar(-20.0, Dimension::LENGTH).display(), "-20 mm");
        assert_eq!(Value::Scalar(0.1 + 0.2, Dimension::NUMBER).display(), "0.3");
        assert_eq!(readable(-0.0), "0");
        assert_eq!(Value::Scalar(2.0, Dimension::SPEED.power(2).unwrap()).display(), "2 mm^2/min^2");
    }

    #[test]
    fn every_unit_measures_something() {
        assert!(UNITS.iter().all(|row| row.size > 0.0 && row.dimension != Dimension::NUMBER));
    }

    #[test]
    fn only_squares_have_roots() {
        assert_eq!(Dimension::LENGTH.power(2).unwrap().root(), Some(Dimension::LENGTH));
        assert_eq!(Dimension::LENGTH.root(), None);
        assert_eq!(Dimension::LENGTH.power(100).unwrap().power(2), None);
    }
}
