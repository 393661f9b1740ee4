//! Numbers of one to seven digits by their picture: nearly all of a program.
//!
//! Seven digits and the point are the bytes of one machine word, and zeros at both ends are counted by its zero bits: no
//! loop, and no branch that depends on digits. [`Picture::print`] prints all other numbers, and these the same way.

use super::digits::eight_digits;
use super::picture::{DecimalPoint, Picture};
use std::num::NonZeroU64;

/// A picture, ready to print numbers of one to seven digits.
#[derive(Debug)]
pub(crate) struct ShortNumber {
    /// The bytes of the digits before the point, and of those behind it.
    whole: u64,
    part: u64,
    /// What is printed for no digits at all: zeros, and the point.
    zeros: u64,
    /// A bit of the first byte that is printed whatever the digits are, and of the last one.
    first: NonZeroU64,
    last: NonZeroU64,
}

impl ShortNumber {
    /// The first number with more digits.
    const LIMIT: u64 = 10_000_000;

    /// Compiles a picture; none for one that needs more than seven digits.
    pub(crate) fn new(picture: &Picture) -> Option<Self> {
        let Picture { integer_least, decimals, decimals_least, .. } = *picture;
        let has_point = picture.point != DecimalPoint::Never;
        if decimals > 0 && !has_point {
            return None;
        }
        let point = 8_u8.checked_sub(decimals + u8::from(has_point))?;
        let first = point.checked_sub(integer_least)?.min(7);
        let last = match picture.point {
            DecimalPoint::Needed | DecimalPoint::Never if decimals_least == 0 => point.checked_sub(1)?,
            _ => point + decimals_least,
        };
        let mut zeros = [b'0'; 8];
        if has_point {
            zeros[usize::from(point)] = b'.';
        }
        let (whole, part) = if has_point { (bytes_before(point), !bytes_before(point + 1)) } else { (0, !0) };
        Some(Self { whole, part, zeros: u64::from_le_bytes(zeros), first: bit_of(first)?, last: bit_of(last)? })
    }

    /// Whether the number has one to seven digits.
    #[inline]
    pub(crate) fn takes(&self, units: i64) -> bool {
        units.unsigned_abs().wrapping_sub(1) < Self::LIMIT - 1
    }

    /// The number without its sign as the bytes of a word, the first in the lowest, and how many of them count.
    #[inline]
    pub(crate) fn text(&self, units: i64) -> (u64, usize) {
        let digits = eight_digits(units.unsigned_abs() as u32);
        let number = digits >> 8 & self.whole | digits & self.part;
        let in_front = (self.first | number).trailing_zeros() as usize / 8;
        let behind = (self.last | number).leading_zeros() as usize / 8;
        ((self.zeros | number) >> (8 * in_front), 8 - in_front - behind)
    }
}

/// The lowest bit of a byte.
fn bit_of(byte: u8) -> Option<NonZeroU64> {
    NonZeroU64::new(1_u64.checked_shl(8 * u32::from(byte))?)
}

/// All bits of the first bytes.
fn bytes_before(byte: u8) -> u64 {
    bit_of(byte).map_or(!0, |bit| bit.get() - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pictures with every number of digits and least digits, and every point.
    fn pictures() -> impl Iterator<Item = Picture> {
        let places = (0..=9_u8).flat_map(|all| (0..=all).map(move |least| (all, least)));
        let digits = places.clone().flat_map(move |integer| places.clone().map(move |decimals| (integer, decimals)));
        let points = [DecimalPoint::Always, DecimalPoint::Needed, DecimalPoint::Never];
        digits.flat_map(move |(integer, decimals)| {
            points.map(|point| Picture {
                plus: false,
                integer_digits: integer.0,
                integer_least: integer.1,
                decimals: decimals.0,
                decimals_least: decimals.1,
                point,
                zero: None,
            })
        })
    }

    /// Numbers of every length, with zeros at either end, and the first and the last of each length.
    fn numbers() -> impl Iterator<Item = i64> {
        let powers = (0..9).map(|n| 10_i64.pow(n));
        powers.flat_map(|power| [power - 1, power, power + 1, 12_345_678 / power, 7 * power])
    }

    #[test]
    fn prints_what_the_picture_prints() {
        let mut compared = 0;
        for picture in pictures() {
            let Some(short) = ShortNumber::new(&picture) else { continue };
            for units in numbers().filter(|units| short.takes(*units)) {
                let mut expected = Vec::new();
                picture.print(units, &mut expected);
                for units in [units, -units] {
                    let (text, length) = short.text(units);
                    assert_eq!(text.to_le_bytes()[..length], expected, "{units} by {picture:?}");
                    compared += 1;
                }
            }
        }
        assert!(compared > 25_000, "{compared}");
    }

    #[test]
    fn what_is_not_taken() {
        let short = ShortNumber::new(&Picture::WHOLE).expect("a short number");
        for units in [0, 10_000_000, -10_000_000, i64::MAX, i64::MIN] {
            assert!(!short.takes(units), "{units}");
        }
    }
}
