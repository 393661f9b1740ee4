//! The usual decimal, eight digits at once: a point and up to eight digits, as nearly every number of a CL file and of a
//! program is written. [`Decimal`](super::Decimal) takes all of them, and says the same.
//!
//! The digits are the bytes of two words, one from the first byte on and one from the second: up to the point they stand
//! in the one, and behind it, as if it were not there, in the other.

use super::decimal::quotient;

/// What is looked at behind the sign: eight digits, the point, and what stands behind.
const WINDOW_BYTES: usize = 10;

/// The number that the text begins with (`-12.3456`, `.5`, `25.`), and what stands behind it. `None` when there is none, or
/// when it has no point, more than eight digits, or hardly anything behind it: that wants a closer look.
#[inline]
pub(crate) fn usual_decimal(text: &[u8]) -> Option<(f64, &[u8])> {
    // Two ways, so that what stands behind the sign need not wait for it.
    match text {
        [b'-', unsigned @ ..] => behind_sign(unsigned, true),
        unsigned => behind_sign(unsigned, false),
    }
}

/// The same behind a sign.
#[inline]
fn behind_sign(text: &[u8], negative: bool) -> Option<(f64, &[u8])> {
    let (digits, count, decimals) = digits(text.first_chunk()?)?;
    Some((quotient(digits, decimals, negative), &text[count + 1..]))
}

/// The digits as one whole number, how many there are, and how many of them stand behind the point.
#[inline]
fn digits(text: &[u8; WINDOW_BYTES]) -> Option<(u64, usize, usize)> {
    let whole = text[..8].iter().position(|&byte| byte == b'.')?;
    let [before, behind] = [word(text, 0), word(text, 1)];
    let from_point = !0 << (8 * whole);
    let values = before ^ ((before ^ behind) & from_point) ^ u64::from_le_bytes([b'0'; 8]);
    let count = leading_digits(values);
    let decimals = count.checked_sub(whole)?;
    let more = count == 8 && text[WINDOW_BYTES - 1].is_ascii_digit();
    (count > 0 && !more).then(|| (eight_digits(values << (64 - 8 * count)), count, decimals))
}

/// Eight bytes from one place on: the first one is the lowest of the word.
#[inline]
fn word(text: &[u8; WINDOW_BYTES], from: usize) -> u64 {
    u64::from_le_bytes(*text[from..].first_chunk().expect("eight bytes from the first or the second on"))
}

/// How many of the bytes, from the lowest on, are below ten.
#[inline]
fn leading_digits(values: u64) -> usize {
    // The top bits of the others, at least up to the first one: a sum may carry over into the byte behind it.
    let others = (values.wrapping_add(u64::from_le_bytes([0x80 - 10; 8])) | values) & u64::from_le_bytes([0x80; 8]);
    others.trailing_zeros() as usize / 8
}

/// The number with these eight digits, the first one in the lowest byte: two bytes become a number below 100, two of those
/// one below 10,000, and two of those the whole.
#[inline]
fn eight_digits(values: u64) -> u64 {
    let pairs = (values.wrapping_mul((10 << 8) + 1) >> 8) & 0x00FF_00FF_00FF_00FF;
    let fours = (pairs.wrapping_mul((100 << 16) + 1) >> 16) & 0x0000_FFFF_0000_FFFF;
    fours.wrapping_mul((10_000 << 32) + 1) >> 32
}

#[cfg(test)]
mod tests {
    use super::super::Decimal;
    use super::*;

    /// What [`Decimal`] says of it.
    fn expected(text: &[u8]) -> Option<(u64, &[u8])> {
        let negative = text.first() == Some(&b'-');
        let unsigned = &text[usize::from(negative)..];
        let decimal = Decimal::leading(unsigned)?;
        Some((decimal.value(negative).to_bits(), &unsigned[decimal.length..]))
    }

    fn found(text: &[u8]) -> Option<(u64, &[u8])> {
        usual_decimal(text).map(|(value, behind)| (value.to_bits(), behind))
    }

    #[test]
    fn every_count_of_digits_with_every_byte_behind() {
        let digits = "91827364";
        let places = (0..=8).flat_map(|whole| (whole.max(1)..=8).map(move |end| (whole, end)));
        for ((whole, end), sign) in places.flat_map(|place| ["", "-"].map(|sign| (place, sign))) {
            for next in 0..=u8::MAX {
                let mut text = format!("{sign}{}.{}", &digits[..whole], &digits[whole..end]).into_bytes();
                text.extend([next; 10]);
                let usual = whole < 8 && !next.is_ascii_digit();
                assert_eq!(found(&text), expected(&text).filter(|_| usual), "{text:?}");
            }
        }
    }

    #[test]
    fn whatever_is_taken_is_what_a_decimal_says() {
        let alphabet = b"0123456789.0123456789.-+ \nXE,:/\xB9\xFF";
        let mut state = 88_172_645_463_325_252_u64;
        let mut taken = 0;
        for _ in 0..500_000 {
            let text: [u8; 14] = std::array::from_fn(|_| {
                state ^= state << 13;
                state ^= state >> 7;
                state ^= state << 17;
                alphabet[state as usize % alphabet.len()]
            });
            if let Some(found) = found(&text) {
                taken += 1;
                assert_eq!(Some(found), expected(&text), "{text:?}");
            }
        }
        assert!(taken > 50_000, "{taken}");
    }

    #[test]
    fn what_wants_a_closer_look() {
        for text in
            ["", "1.5", "1.5,2,3,4", "15,2,3,4,5,6", ".,2,3,4,5,6,7", "+1.5,2,3,4,5", "1.23456789,0", "--1.5,2,3,4"]
        {
            assert_eq!(usual_decimal(text.as_bytes()), None, "{text}");
        }
        assert_eq!(found(b"-0.0000,0,0"), Some((0, &b",0,0"[..])));
    }
}
