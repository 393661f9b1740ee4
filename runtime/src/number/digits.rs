//! The digits of a number, all at once.

/// The eight digits of a number as the bytes of a word, the first in the lowest byte: halved three times, all parts at
/// once.
#[inline]
pub(super) fn eight_digits(number: u32) -> u64 {
    let high = u64::from(number / 10_000);
    let fours = (u64::from(number) << 32) - high * ((10_000 << 32) - 1);
    let hundreds = (fours * 10_486) >> 20 & 0x0000_007f_0000_007f;
    let twos = (fours << 16) - hundreds * ((100 << 16) - 1);
    let tens = (twos * 103) >> 10 & 0x000f_000f_000f_000f;
    (twos << 8) - tens * ((10 << 8) - 1)
}

/// Prints a whole number in decimal.
pub(super) fn print_whole(number: u64, out: &mut Vec<u8>) {
    let digits = Digits::of(number % Digits::LIMIT);
    if number >= Digits::LIMIT {
        print_whole(number / Digits::LIMIT, out);
        digits.print(0, Digits::COUNT, out);
    } else {
        digits.print(digits.first.min(Digits::COUNT - 1), Digits::COUNT, out);
    }
}

/// The sixteen digits of a number, zeros in front.
pub(super) struct Digits {
    /// The digits, and room for a copy that begins at the last of them.
    text: [u8; 2 * Self::COUNT],
    /// Where the first digit other than zero stands; the end for zero.
    pub(super) first: usize,
    /// Behind the last digit other than zero; the start for zero.
    pub(super) behind_last: usize,
}

impl Digits {
    pub(super) const COUNT: usize = 16;
    /// The first number with more digits.
    const LIMIT: u64 = 10_000_000_000_000_000;

    #[inline]
    pub(super) fn of(number: u64) -> Self {
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
    pub(super) fn print(&self, from: usize, to: usize, out: &mut Vec<u8>) {
        let end = out.len() + to - from;
        let window = self.text[from..].first_chunk::<{ Self::COUNT }>();
        out.extend_from_slice(window.expect("a place among the digits has as many bytes behind it"));
        out.truncate(end);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_digit_is_in_the_lowest_byte() {
        let powers = (0..8).map(|n| 10_u32.pow(n));
        let near_powers = powers.flat_map(|power| [power - 1, power, 9 * power, 10 * power - 1]);
        for number in near_powers.chain((0..100_000_000).step_by(997)) {
            let digits = format!("{number:08}").into_bytes().try_into().expect("eight digits");
            assert_eq!(eight_digits(number) | u64::from_le_bytes([b'0'; 8]), u64::from_le_bytes(digits), "{number}");
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
}
