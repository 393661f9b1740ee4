//! Numbers by their picture: rounded to whole units of the last decimal, and printed digit by digit.
//!
//! The rounded whole number is the value in every comparison ("has the printed word changed?", "is it a full turn?"),
//! so that what is compared is what is printed.

use super::digits::Digits;
use super::rounding::Rounding;

/// How a number is printed, from a picture such as `####.###`, `###0[.###]`, `+##0.000`.
///
/// Before the point every `#` or `0` is a digit that may be printed; from the first `0` on, digits are always printed.
/// After the point `0` is always printed and `#` only when it or a later digit is not zero. A point outside brackets is
/// always printed; `[.###]` drops the point along with the digits. A leading `+` prints the sign of positive numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// Print `+` before positive numbers.
    pub plus: bool,
    /// The greatest number of digits before the point.
    pub integer_digits: u8,
    /// The digits before the point that are always printed.
    pub integer_least: u8,
    /// The greatest number of digits after the point: the resolution.
    pub decimals: u8,
    /// The digits after the point that are always printed.
    pub decimals_least: u8,
    /// When the point is printed.
    pub point: DecimalPoint,
    /// What is printed for a number that rounds to zero, where it differs from the picture (`0.0`).
    pub zero: Option<String>,
}

/// When a decimal point is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DecimalPoint {
    /// Always (`25.`).
    Always,
    /// Only before digits (`25`, `25.5`).
    Needed,
    /// Never: the picture has no point.
    Never,
}

impl Picture {
    /// The greatest number of digits before and after the point together: what a double holds exactly.
    pub const MOST_DIGITS: u8 = 15;

    /// A picture of whole numbers without sign or point, printed with at least one digit.
    pub const WHOLE: Self = Self {
        plus: false,
        integer_digits: 9,
        integer_least: 1,
        decimals: 0,
        decimals_least: 0,
        point: DecimalPoint::Never,
        zero: None,
    };

    /// How many units of the last decimal make one: `10^decimals`.
    pub fn units_per_one(&self) -> i64 {
        10_i64.pow(u32::from(self.decimals))
    }

    /// The least number of units that has too many digits for the picture.
    pub fn too_many_units(&self) -> i64 {
        10_i64.pow(u32::from(self.integer_digits + self.decimals))
    }

    /// The value in whole units of the last decimal, halves away from zero; nothing when it is not finite or has too
    /// many digits.
    pub fn units(&self, value: f64) -> Option<i64> {
        self.rounding().units(value)
    }

    /// The value of so many units.
    pub fn value(&self, units: i64) -> f64 {
        units as f64 / self.units_per_one() as f64
    }

    /// Rounds what has digits enough in the picture.
    pub(crate) fn rounding(&self) -> Rounding {
        Rounding::new(self.units_per_one(), self.too_many_units())
    }

    /// Rounds what has digits enough in any picture: for a value that is reduced to a turn later on.
    pub(crate) fn unbounded_rounding(&self) -> Rounding {
        Rounding::new(self.units_per_one(), 10_i64.pow(u32::from(Self::MOST_DIGITS)))
    }

    /// Prints a number of units that fits.
    pub fn print(&self, units: i64, out: &mut Vec<u8>) {
        if units == 0
            && let Some(zero) = &self.zero
        {
            out.extend_from_slice(zero.as_bytes());
            return;
        }
        if units < 0 {
            out.push(b'-');
        } else if self.plus && units > 0 {
            out.push(b'+');
        }
        let digits = Digits::of(units.unsigned_abs());
        let point = Digits::COUNT - usize::from(self.decimals);
        let end = digits.behind_last.max(point + usize::from(self.decimals_least));
        let mut start = digits.first.min(point - usize::from(self.integer_least));
        if start == point && end == point {
            start -= 1; // some digit must stand there
        }
        digits.print(start, point, out);
        if self.point == DecimalPoint::Always || (self.point == DecimalPoint::Needed && end > point) {
            out.push(b'.');
        }
        digits.print(point, end, out);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `####.###`, zero `0.0`.
    fn length() -> Picture {
        Picture {
            plus: false,
            integer_digits: 4,
            integer_least: 0,
            decimals: 3,
            decimals_least: 0,
            point: DecimalPoint::Always,
            zero: Some("0.0".into()),
        }
    }

    fn printed(picture: &Picture, value: f64) -> String {
        let mut out = Vec::new();
        picture.print(picture.units(value).expect("the value fits"), &mut out);
        String::from_utf8(out).expect("digits are ASCII")
    }

    #[test]
    fn shapes_of_a_word_with_a_point() {
        let cases = [
            (70.711, "70.711"),
            (0.483, ".483"),
            (-0.483, "-.483"),
            (0.002, ".002"),
            (25.0, "25."),
            (315.0, "315."),
            (0.0, "0.0"),
            (-0.0, "0.0"),
            (-0.0004, "0.0"),
            (0.0005, ".001"),
            (-0.0005, "-.001"),
            (9999.9994, "9999.999"),
            (100.25, "100.25"),
        ];
        for (value, text) in cases {
            assert_eq!(printed(&length(), value), text);
        }
    }

    #[test]
    fn shapes_of_other_pictures() {
        let needed = Picture { point: DecimalPoint::Needed, zero: None, ..length() };
        assert_eq!(printed(&needed, 10.0), "10");
        assert_eq!(printed(&needed, 10.5), "10.5");
        assert_eq!(printed(&needed, 0.0), "0");
        let bare = Picture { zero: None, ..length() };
        assert_eq!(printed(&bare, 0.0), "0.");
        let full = Picture { plus: true, integer_least: 2, decimals_least: 3, zero: None, ..length() };
        assert_eq!(printed(&full, 1.5), "+01.500");
        assert_eq!(printed(&full, -1.5), "-01.500");
        assert_eq!(printed(&full, 0.0), "00.000");
        let two = Picture { integer_digits: 2, integer_least: 2, ..Picture::WHOLE };
        assert_eq!(printed(&two, 3.0), "03");
        assert_eq!(printed(&Picture::WHOLE, 0.0), "0");
        assert_eq!(printed(&Picture::WHOLE, 123_456_789.0), "123456789");
    }

    #[test]
    fn a_number_with_too_many_digits_is_refused() {
        for value in [9999.9995, 10_000.0, -10_000.0, 1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            assert_eq!(length().units(value), None, "{value}");
        }
    }

    /// A small generator of numbers of all magnitudes.
    fn values() -> impl Iterator<Item = f64> {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        (0..200_000).map(move |n| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            let fraction = (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5;
            fraction * 2.0 * 10_u32.pow(n % 5) as f64
        })
    }

    #[test]
    fn what_is_printed_is_the_value_to_half_a_unit() {
        for decimals in 0..=6 {
            for point in [DecimalPoint::Always, DecimalPoint::Needed] {
                let picture = Picture { decimals, point, ..length() };
                let half = 0.5 * picture.value(1);
                for value in values() {
                    if picture.units(value).is_none() {
                        continue;
                    }
                    let text = printed(&picture, value);
                    let read: f64 = text.parse().expect("a number");
                    assert!((read - value).abs() <= half * (1.0 + 1e-9), "{value} printed as {text}");
                    assert!(!(read == 0.0 && text.contains('-')), "{value} printed as {text}");
                }
            }
        }
    }
}
