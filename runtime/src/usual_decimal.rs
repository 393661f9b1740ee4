//! The usual decimal, eight digits at once: a point and up to eight digits, as nearly every number of a CL file and of a
//! program is written. [`Decimal`](crate::decimal::Decimal) takes them all, and says the same.
//!
//! Two words of eight bytes are taken, one from the first byte on and one from the second: up to the point the digits stand
//! in the one, and behind it, without the point, in the other.

use crate::decimal::quotient;

/// What is looked at: a sign, eight digits, the point, and what stands behind.
const WINDOW_BYTES: usize = 1 + UNSIGNED_BYTES;
/// The same without the sign.
const UNSIGNED_BYTES: usize = 10;

/// The number that the text begins with (`-12.3456`, `.5`, `25.`), and what stands behind it. `None` when there is none, or
/// when it has no point, more than eight digits, or hardly anything behind it: that wants a closer look.
#[inline]
pub(crate) fn usual_decimal(text: &[u8]) -> Option<(f64, &[u8])> {
    let window = text.first_chunk::<WINDOW_BYTES>()?;
    let negative = window[0] == b'-';
    let (digits, count, decimals) = digits(window[usize::from(negative)..].first_chunk()?)?;
    Some((quotient(digits, decimals, negative), &text[usize::from(negative) + count + 1..]))
}

/// The digits as one whole number, how many there are, and how many of them stand behind the point.
#[inline]
fn digits(text: &[u8; UNSIGNED_BYTES]) -> Option<(u64, usize, usize)> {
    let [before, behind] = [digit_values(text, 0), digit_values(text, 1)];
    let end_of_whole = no_digits(before);
    let whole = bytes_below(end_of_whole);
    let from_point = at_and_above(end_of_whole);
    let end = no_digits(behind) & from_point;
    let count = bytes_below(end);
    let more = text[count + 1].is_ascii_digit();
    if text[whole] != b'.' || count == 0 || more {
        return None;
    }
    let digits = before ^ ((before ^ behind) & from_point);
    Some((eight_digits(digits << (64 - 8 * count)), count, count - whole))
}

/// Eight bytes from one place on, each less the digit 0: the first one is the lowest of the word.
#[inline]
fn digit_values(text: &[u8; UNSIGNED_BYTES], from: usize) -> u64 {
    let bytes = text[from..].first_chunk().expect("eight bytes from the first or the second on");
    u64::from_le_bytes(*bytes) ^ u64::from_le_bytes([b'0'; 8])
}

/// The top bits of the bytes that are no digits. (A byte above 0x89 carries over into the next one, so that nothing is
/// said of what stands behind the first byte that is neither digit nor point.)
#[inline]
fn no_digits(values: u64) -> u64 {
    (values.wrapping_add(u64::from_le_bytes([0x7F - 9; 8])) | values) & u64::from_le_bytes([0x80; 8])
}

/// How many bytes stand before the first one that has its top bit in `top_bits`: eight when none has.
#[inline]
fn bytes_below(top_bits: u64) -> usize {
    top_bits.trailing_zeros() as usize / 8
}

/// The first byte that has its top bit in `top_bits`, and all behind it, filled with ones.
#[inline]
fn at_and_above(top_bits: u64) -> u64 {
    let lowest_bits = top_bits >> 7;
    lowest_bits | lowest_bits.wrapping_neg()
}

/// The number with these eight digits, the first one in the lowest byte: two bytes become a number below 100, two of those
/// one below 10,000, and two of those the whole.
#[inline]
fn eight_digits(values: u64) -> u64 {
    let pairs = (values.wrapping_mul((10 << 8) + 1) >> 8) & 0x00FF_00FF_00FF_00FF;
    let fours = (pairs.wrapping_mul((100 << 16) + 1) >> 16) & 0x0000_FFFF_0000_FFFF;
    fours.wrapping_mul((10_000 << 32) + 1) >> 32
}
