//! Numbers by their picture: rounded to whole units of the last decimal, and printed digit by digit.
//!
//! The rounded whole number is the value in every comparison ("has the printed word changed?", "is it a full turn?"),
//! so that what is compared is what is printed.

use super::dialect::{Picture, Point};
use super::digits::eight_digits;
use super::rounding::Rounding;

/// `10^n`, exact.
const POWERS: [u64; Picture::MOST_DIGITS as usize + 1] = {
    let mut powers = [1; Picture::MOST_DIGITS as usize + 1];
    let mut n = 1;
    while n < powers.len() {
        powers[n] = powers[n - 1] * 10;
        n += 1;
    }
    powers
};

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
        point: Point::Never,
        zero: None,
    };

    /// How many units of the last decimal make one: `10^decimals`.
    pub fn units_per_one(&self) -> i64 {
        POWERS[usize::from(self.decimals)] as i64
    }

    /// The least number of units that has too many digits for the picture.
    pub fn too_many_units(&self) -> i64 {
        POWERS[usize::from(self.integer_digits + self.decimals)] as i64
    }

    /// The value in whole units of the last decimal, halves away from zero; nothing when it is not finite or has too
    /// many digits.
    pub fn units(&self, value: f64) -> Option<i64> {
        Rounding::new(self).units(value)
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
        if self.point == Point::Always || (self.point == Point::Needed && end > point) {
            out.push(b'.');
        }
        digits.print(point, end, out);
    }
}

/// Prints a whole number in decimal.
pub fn print_whole(number: u64, out: &mut Vec<u8>) {
    let digits = Digits::of(number % Digits::LIMIT);
    if number >= Digits::LIMIT {
        print_whole(number / Digits::LIMIT, out);
        digits.print(0, Digits::COUNT, out);
    } else {
        digits.print(digits.first.min(Digits::COUNT - 1), Digits::COUNT, out);
    }
}

/// The sixteen digits of a number, zeros in front.
struct Digits {
    /// The digits, and room for a copy that begins at the last of them.
    text: [u8; 2 * Self::COUNT],
    /// Where the first digit other than zero stands; the end for zero.
    first: usize,
    /// Behind the last digit other than zero; the start for zero.
    behind_last: usize,
}

impl Digits {
    const COUNT: usize = 16;
    /// The first number with more digits.
    const LIMIT: u64 = 10_000_000_000_000_000;

    #[inline]
    fn of(number: u64) -> Self {
        let (high, low) = match number {
            0..100_000_000 => (0, eight_digits(number as u32)),
            _ => (eight_digits((number / 100_000_000) as u32), eight_digits((number % 100_000_000) as u32)),
        };
        let digits = u128::from(low) << 64 | u128::from(high);
        let mut text = [b'0'; 2 * Self::COUNT];
        text[..Self::COUNT].copy_from_slice(&(digits | u128::from_le_bytes([b'0'; 16])).to_le_bytes());
        let first = digits.trailing_zeros() as usize / 8;
        let behind_last = Self::COUNT - digits.leading_zeros() as usize / 8;
        Self { text, first, behind_last }
    }

    /// Prints the digits from one place to another. All of them are copied and the rest taken back: a copy of fixed
    /// length takes a fraction of the time of one of few bytes.
    #[inline]
    fn print(&self, from: usize, to: usize, out: &mut Vec<u8>) {
        let end = out.len() + to - from;
        let window = self.text[from..].first_chunk::<{ Self::COUNT }>();
        out.extend_from_slice(window.expect("a place among the digits has as many bytes behind it"));
        out.truncate(end);
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
            point: Point::Always,
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
        let needed = Picture { point: Point::Needed, zero: None, ..length() };
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

    #[test]
    fn whole_numbers() {
        let some = [99_999_999, 100_000_000, 9_999_999_999_999_999, 10_000_000_000_000_000, u64::MAX];
        let many = (0..10_000).flat_map(|four| [four, four * 10_000, four * 1_000_000_007]);
        for number in many.chain(some) {
            let mut out = Vec::new();
            print_whole(number, &mut out);
            assert_eq!(out, number.to_string().as_bytes());
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
            fraction * 2.0 * POWERS[n % 5] as f64
        })
    }

    #[test]
    fn what_is_printed_is_the_value_to_half_a_unit() {
        for decimals in 0..=6 {
            for point in [Point::Always, Point::Needed] {
                let picture = Picture { decimals, point, ..length() };
                let half = 0.5 / POWERS[usize::from(decimals)] as f64;
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
