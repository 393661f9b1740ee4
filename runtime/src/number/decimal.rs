//! Plain decimals at the start of a text: for CL data, and for the program read back.

/// Powers of ten that a double holds exactly.
const POWERS_OF_TEN: [f64; Decimal::MOST_DIGITS + 1] =
    [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18];

/// Digits with or without a point: `12.3456`, `.5`, `25.`, `7`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Decimal {
    /// All digits as one whole number.
    pub(crate) digits: u64,
    /// How many there are.
    pub(crate) count: usize,
    /// How many of them stand behind the point.
    decimals: usize,
    /// How many bytes they and the point take.
    pub(crate) length: usize,
}

impl Decimal {
    /// More digits are not taken: a word of 64 bits holds all numbers of so many.
    pub(crate) const MOST_DIGITS: usize = 18;

    /// The decimal that the text begins with, if it does.
    pub(crate) fn leading(text: &[u8]) -> Option<Self> {
        let (mut digits, mut length) = leading_digits(text, 0, 0);
        let (mut count, mut decimals) = (length, 0);
        if text.get(length) == Some(&b'.') {
            let point = length;
            (digits, length) = leading_digits(text, point + 1, digits);
            decimals = length - point - 1;
            count += decimals;
        }
        (1..=Self::MOST_DIGITS).contains(&count).then_some(Self { digits, count, decimals, length })
    }

    /// Its value behind a sign, as [`quotient`] says.
    pub(crate) fn value(self, negative: bool) -> f64 {
        quotient(self.digits, self.decimals, negative)
    }
}

/// The value of digits with so many decimals behind a sign, never -0. With up to 15 digits it is the double closest to the
/// decimal: both the digits and the power of ten are exact, and so their quotient is rounded once.
#[inline]
pub(super) fn quotient(digits: u64, decimals: usize, negative: bool) -> f64 {
    // The sign is put on the whole number, which has no -0.
    let digits = digits as i64;
    (if negative { -digits } else { digits }) as f64 / POWERS_OF_TEN[decimals]
}

/// Appends the digits from one place on to a number, and says where they end. Too many of them wrap around.
fn leading_digits(text: &[u8], mut at: usize, mut number: u64) -> (u64, usize) {
    while let Some(digit) = text.get(at).map(|byte| byte.wrapping_sub(b'0'))
        && digit < 10
    {
        number = number.wrapping_mul(10).wrapping_add(u64::from(digit));
        at += 1;
    }
    (number, at)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Digits of every count, before and behind a point.
    fn decimals() -> impl Iterator<Item = String> {
        let digits = "918273645081726354";
        let split = move |whole: usize, part: usize| format!("{}.{}", &digits[..whole], &digits[whole..whole + part]);
        (0..=9).flat_map(move |whole| (0..=9).map(move |part| split(whole, part))).filter(|text| text.len() > 1)
    }

    #[test]
    fn every_count_of_digits_with_every_byte_behind() {
        for text in decimals().chain((1..=18).map(|count| "123456789012345678"[..count].to_owned())) {
            for next in (0..=u8::MAX).filter(|next| !next.is_ascii_digit() && *next != b'.') {
                for room in 0..9 {
                    let mut bytes = text.as_bytes().to_vec();
                    bytes.extend(std::iter::repeat_n(next, room));
                    let decimal = Decimal::leading(&bytes).expect("up to 18 digits");
                    let digits: String = text.chars().filter(char::is_ascii_digit).collect();
                    assert_eq!(decimal.digits, digits.parse().expect("digits"), "{text} {next}");
                    assert_eq!((decimal.count, decimal.length), (digits.len(), text.len()), "{text} {next}");
                    if decimal.count <= 15 {
                        let expected: f64 = text.parse().expect("a number");
                        assert_eq!(decimal.value(false), expected, "{text}");
                        assert_eq!(decimal.value(true), -expected, "{text}");
                    }
                }
            }
        }
    }

    #[test]
    fn what_is_no_decimal() {
        for text in ["", ".", "-1", "+1", "x", "..5", "1234567890123456789", "1234567890.123456789"] {
            assert_eq!(Decimal::leading(text.as_bytes()), None, "{text}");
        }
    }

    #[test]
    fn there_is_no_minus_zero() {
        let zero = Decimal::leading(b"0.000").expect("a decimal");
        assert_eq!(zero.value(true).to_bits(), 0);
    }
}
