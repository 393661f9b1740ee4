//! Numbers counted up as text.

use super::digits::{eight_digits, print_whole};

/// The number that comes next.
#[derive(Debug)]
pub(crate) struct Counter {
    start: u64,
    step: u64,
    greatest: u64,
    next: u64,
    /// Its last eight digits as the bytes of a word, the last one in the lowest byte.
    digits: u64,
    /// The same of the step.
    step_digits: u64,
    /// How many bits of the digits are zeros in front.
    zeros: u32,
    /// The first number that has more digits, or more than eight, or is too great.
    other_from: u64,
}

impl Counter {
    /// From one number on, in steps; after the greatest one it begins again.
    pub(crate) fn new(start: u64, step: u64, greatest: u64) -> Self {
        let step_digits = last_eight_digits(step);
        let mut counter = Self { start, step, greatest, next: start, digits: 0, step_digits, zeros: 0, other_from: 0 };
        counter.begin();
        counter
    }

    /// Prints the number.
    pub(crate) fn print(&self, out: &mut Vec<u8>) {
        print_whole(self.next, out);
    }

    /// Goes on to the next number. Gives its digits, and any bytes behind them, where it has as many as the one before.
    #[inline]
    pub(crate) fn advance(&mut self) -> Option<[u8; 8]> {
        self.next = self.next.saturating_add(self.step);
        if self.next >= self.other_from {
            self.begin();
            return None;
        }
        self.digits = sum_of_digits(self.digits, self.step_digits);
        Some(((self.digits | u64::from_le_bytes([b'0'; 8])) << self.zeros).to_be_bytes())
    }

    /// Begins to count at the next number.
    #[cold]
    fn begin(&mut self) {
        if self.next > self.greatest {
            self.next = self.start;
        }
        let count = (self.next.checked_ilog10().unwrap_or(0) + 1).min(8);
        self.digits = last_eight_digits(self.next);
        self.zeros = 8 * (8 - count);
        self.other_from = 10_u64.pow(count).min(self.greatest.saturating_add(1));
    }
}

/// The last eight digits of a number, the last one in the lowest byte.
fn last_eight_digits(number: u64) -> u64 {
    eight_digits((number % 100_000_000) as u32).swap_bytes()
}

/// Adds numbers of eight digits: 246 more in each byte carries at ten, and leaves its high bits where nothing carries.
#[inline]
fn sum_of_digits(a: u64, b: u64) -> u64 {
    let sum = (a + 0xf6f6_f6f6_f6f6_f6f6).wrapping_add(b);
    (sum & 0x0f0f_0f0f_0f0f_0f0f) - (sum >> 4 & 0x0606_0606_0606_0606)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Counts as a control would, and compares the text of every number.
    fn count(start: u64, step: u64, greatest: u64) {
        let mut counter = Counter::new(start, step, greatest);
        let mut text = Vec::new();
        counter.print(&mut text);
        let mut number = start;
        for _ in 0..1000 {
            assert_eq!(text, number.to_string().into_bytes(), "{start} {step} {greatest}");
            let next = number.saturating_add(step);
            number = if next > greatest { start } else { next };
            match counter.advance() {
                Some(digits) => {
                    let end = text.len();
                    text.copy_from_slice(&digits[..end]);
                }
                None => {
                    text.clear();
                    counter.print(&mut text);
                }
            }
        }
    }

    #[test]
    fn numbers_count_up() {
        for start in [0, 1, 5, 10, 97, 980, 99_999_000, 99_999_999, 123_456_789_012, u64::MAX - 9] {
            for step in [1, 3, 5, 10, 11, 25, 999, 12_345_678, 99_999_999, 100_000_000, 7_000_000_000] {
                for room in [0, 1, 30, 10_000, 9_999_999, u64::MAX] {
                    count(start, step, start.saturating_add(room));
                }
            }
        }
    }
}
