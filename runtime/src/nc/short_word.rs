//! Words whose number has at most seven digits, compiled.
//!
//! Address and number are stored with all of their eight bytes, the number over what does not count of the address.

use crate::number::{Picture, ShortNumber};

/// A word and a blank behind it take so many bytes at most.
pub(super) const ROOM: usize = 24;

/// An address and a picture, ready to print numbers of one to seven digits.
#[derive(Debug)]
pub(super) struct ShortWord {
    /// The address, and the sign of a number above zero and of one below.
    heads: [Head; 2],
    number: ShortNumber,
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
    /// Compiles a word; none for a long address, and for a picture that needs more than seven digits.
    pub(super) fn new(address: &str, picture: &Picture) -> Option<Self> {
        let plus = if picture.plus { "+" } else { "" };
        let heads = [Head::new(address, plus)?, Head::new(address, "-")?];
        Some(Self { heads, number: ShortNumber::new(picture)? })
    }

    /// Whether the number has one to seven digits.
    #[inline]
    pub(super) fn takes(&self, units: i64) -> bool {
        self.number.takes(units)
    }

    /// Prints the word of a number it takes, and says how long it is.
    #[inline]
    pub(super) fn print(&self, units: i64, room: &mut [u8; ROOM]) -> usize {
        let head = &self.heads[usize::from(units < 0)];
        let (text, length) = self.number.text(units);
        put(head.text, 0, room);
        put(text, head.length, room);
        head.length + length
    }
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
    use crate::number::DecimalPoint;

    /// `####.###`, with a sign or without.
    fn picture(plus: bool) -> Picture {
        Picture { plus, integer_digits: 4, decimals: 3, point: DecimalPoint::Always, ..Picture::WHOLE }
    }

    #[test]
    fn address_sign_and_number_as_the_picture_prints_them() {
        for picture in [picture(false), picture(true), Picture::WHOLE] {
            for address in ["", "X", "C1=", "ABCDEFG"] {
                let word = ShortWord::new(address, &picture).expect("a short word");
                for units in [1, -1, 10, -25_000, 100_250, -123_456, 9_999_999, -9_999_999] {
                    let mut expected = address.as_bytes().to_vec();
                    picture.print(units, &mut expected);
                    let mut room = [0; ROOM];
                    let length = word.print(units, &mut room);
                    assert_eq!(room[..length], expected, "{address}{units} by {picture:?}");
                }
            }
        }
    }

    #[test]
    fn a_long_address_is_no_short_word() {
        assert!(ShortWord::new("ABCDEFGH", &Picture::WHOLE).is_none());
    }
}
