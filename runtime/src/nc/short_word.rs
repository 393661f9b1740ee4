//! Words whose number has at most seven digits, compiled: nearly all of a program.
//!
//! Seven digits and the point are the bytes of one machine word. Zeros at both ends are counted by its zero bits, and
//! address and number are stored with all of their eight bytes, the number over what does not count of the address: no
//! loop, and no branch that depends on digits. [`Picture::print`] prints all other numbers, and these the same way.

use super::dialect::{Picture, Point};
use super::digits::eight_digits;
use std::num::NonZeroU64;

/// A word and a blank behind it take so many bytes at most.
pub(super) const ROOM: usize = 24;

/// An address and a picture, ready to print numbers of one to seven digits.
#[derive(Debug)]
pub(super) struct ShortWord {
    /// The address, and the sign of a number above zero and of one below.
    heads: [Head; 2],
    /// The bytes of the digits before the point, and of those behind it.
    whole: u64,
    part: u64,
    /// What is printed for no digits at all: zeros, and the point.
    zeros: u64,
    /// A bit of the first byte that is printed whatever the digits are, and of the last one.
    first: NonZeroU64,
    last: NonZeroU64,
}

/// What stands before the digits.
#[derive(Debug)]
struct Head {
    text: u64,
    length: usize,
}

impl Head {
    /// An address and a sign; none where they are more than eight bytes.
    fn new(address: &str, sign: &str) -> Option<Self> {
        let length = address.len() + sign.len();
        let mut text = [0; 8];
        text.get_mut(..length)?.copy_from_slice([address, sign].concat().as_bytes());
        Some(Self { text: u64::from_le_bytes(text), length })
    }
}

impl ShortWord {
    /// The first number with more digits.
    const LIMIT: u64 = 10_000_000;

    /// Compiles a word; none for a long address, and for a picture that needs more than seven digits.
    pub(super) fn new(address: &str, picture: &Picture) -> Option<Self> {
        let Picture { integer_least, decimals, decimals_least, .. } = *picture;
        let has_point = picture.point != Point::Never;
        if decimals > 0 && !has_point {
            return None;
        }
        let point = 8_u8.checked_sub(decimals + u8::from(has_point))?;
        let first = point.checked_sub(integer_least)?.min(7);
        let last = match picture.point {
            Point::Needed | Point::Never if decimals_least == 0 => point.checked_sub(1)?,
            _ => point + decimals_least,
        };
        let plus = if picture.plus { "+" } else { "" };
        let mut zeros = [b'0'; 8];
        if has_point {
            zeros[usize::from(point)] = b'.';
        }
        let (whole, part) = if has_point { (bytes_before(point), !bytes_before(point + 1)) } else { (0, !0) };
        Some(Self {
            heads: [Head::new(address, plus)?, Head::new(address, "-")?],
            whole,
            part,
            zeros: u64::from_le_bytes(zeros),
            first: bit_of(first)?,
            last: bit_of(last)?,
        })
    }

    /// Whether the number has one to seven digits.
    #[inline]
    pub(super) fn takes(&self, units: i64) -> bool {
        units.unsigned_abs().wrapping_sub(1) < Self::LIMIT - 1
    }

    /// Prints the word of a number it takes, and says how long it is.
    #[inline]
    pub(super) fn print(&self, units: i64, room: &mut [u8; ROOM]) -> usize {
        let digits = eight_digits(units.unsigned_abs() as u32);
        let number = digits >> 8 & self.whole | digits & self.part;
        let in_front = (self.first | number).trailing_zeros() as usize / 8;
        let behind = (self.last | number).leading_zeros() as usize / 8;
        let head = &self.heads[usize::from(units < 0)];
        put(head.text, 0, room);
        put((self.zeros | number) >> (8 * in_front), head.length, room);
        head.length + 8 - in_front - behind
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

/// Stores eight bytes, the first of which is the lowest. All places are below 16, as the compiler shall know.
#[inline]
fn put(bytes: u64, at: usize, room: &mut [u8; ROOM]) {
    let at = at & 15;
    room[at..at + 8].copy_from_slice(&bytes.to_le_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pictures with every number of digits and least digits, and every point.
    fn pictures() -> impl Iterator<Item = Picture> {
        let places = (0..=9_u8).flat_map(|all| (0..=all).map(move |least| (all, least)));
        let digits = places.clone().flat_map(move |integer| places.clone().map(move |decimals| (integer, decimals)));
        let points = [(Point::Always, false), (Point::Needed, true), (Point::Never, false)];
        digits.flat_map(move |(integer, decimals)| {
            points.map(|(point, plus)| Picture {
                plus,
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
        let numbers = powers.flat_map(|power| [power - 1, power, power + 1, 12_345_678 / power, 7 * power]);
        numbers.flat_map(|number| [number, -number])
    }

    #[test]
    fn prints_what_the_picture_prints() {
        let mut compared = 0;
        for picture in pictures() {
            for address in ["", "X", "C1=", "ABCDEFG"] {
                let Some(word) = ShortWord::new(address, &picture) else { continue };
                for units in numbers().filter(|units| word.takes(*units)) {
                    let mut expected = address.as_bytes().to_vec();
                    picture.print(units, &mut expected);
                    let mut room = [0; ROOM];
                    let length = word.print(units, &mut room);
                    assert_eq!(room[..length], expected, "{units} by {picture:?}");
                    compared += 1;
                }
            }
        }
        assert!(compared > 100_000, "{compared}");
    }

    #[test]
    fn what_is_not_taken() {
        let word = ShortWord::new("X", &Picture::WHOLE).expect("a short word");
        for units in [0, 10_000_000, -10_000_000, i64::MAX, i64::MIN] {
            assert!(!word.takes(units), "{units}");
        }
        assert!(ShortWord::new("ABCDEFGH", &Picture::WHOLE).is_none());
    }
}
