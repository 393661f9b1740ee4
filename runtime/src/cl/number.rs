//! Numbers of CL text.

/// Powers of ten that a double holds exactly.
const POWERS_OF_TEN: [f64; 16] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

/// A plain decimal (`-12.3456`, `.5`, `25.`) at the start of `text`, and how many bytes it takes. `None` when there is
/// none or when it has more than 15 digits: [`number`] decides those.
///
/// Both the digits and the power of ten are exact, so their quotient is correctly rounded.
#[inline]
pub(super) fn leading_decimal(text: &[u8]) -> Option<(f64, usize)> {
    let negative = text.first() == Some(&b'-');
    let sign = usize::from(negative);
    let (whole, at) = digits(text, sign, 0);
    let mut count = at - sign;
    let (mut mantissa, mut end, mut decimals) = (whole, at, 0);
    if text.get(at) == Some(&b'.') {
        (mantissa, end) = digits(text, at + 1, whole);
        decimals = end - at - 1;
        count += decimals;
    }
    if count == 0 || count > 15 {
        return None;
    }
    // The sign is put on the whole number, which has no -0.
    let mantissa = mantissa as i64;
    let mantissa = if negative { -mantissa } else { mantissa };
    Some((mantissa as f64 / POWERS_OF_TEN[decimals], end))
}

/// Appends the digits from `at` on to `value`; more than 15 of them wrap around, which the caller checks.
#[inline]
fn digits(text: &[u8], mut at: usize, mut value: u64) -> (u64, usize) {
    while let Some(digit) = text.get(at).map(|byte| byte.wrapping_sub(b'0')).filter(|digit| *digit < 10) {
        value = value.wrapping_mul(10).wrapping_add(u64::from(digit));
        at += 1;
    }
    (value, at)
}

/// The whole text as a number: decimals with or without a leading zero, a trailing point, an exponent.
/// The result may be infinite (`1e999`), never NaN or -0.
pub(super) fn number(text: &[u8]) -> Option<f64> {
    let plain = text.iter().all(|byte| matches!(byte, b'0'..=b'9' | b'+' | b'-' | b'.' | b'e' | b'E'));
    let value = plain.then(|| fast_float2::parse::<f64, _>(text).ok())?;
    value.map(|value| value + 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_decimals_are_correctly_rounded() {
        for text in
            ["0", "25.", ".5", "-.5", "-12.3456", "0.9138645", "123456789.012345", "-0.0000000", "999999999999999"]
        {
            let expected: f64 = text.parse().unwrap();
            let (value, length) = leading_decimal(text.as_bytes()).unwrap();
            assert_eq!(value.to_bits(), (expected + 0.0).to_bits(), "{text}");
            assert_eq!(length, text.len());
        }
    }

    #[test]
    fn what_is_not_plain_is_left() {
        for text in ["", "-", ".", "-.", "+1", "x", "1234567890.123456"] {
            assert_eq!(leading_decimal(text.as_bytes()), None, "{text}");
        }
        assert_eq!(leading_decimal(b"1.5,2"), Some((1.5, 3)));
        assert_eq!(leading_decimal(b"1.5E3"), Some((1.5, 3)));
    }

    #[test]
    fn whatever_follows_a_number_does_not_change_it() {
        for text in ["1", "12.5", "-123.4567", "12345678", "123456.78901234"] {
            for next in 0..=u8::MAX {
                let mut bytes = text.as_bytes().to_vec();
                bytes.extend([next; 9]);
                let expected = (text.parse().unwrap(), text.len());
                if !next.is_ascii_digit() && (next != b'.' || text.contains('.')) {
                    assert_eq!(leading_decimal(&bytes), Some(expected), "{text} {next}");
                }
            }
        }
    }

    #[test]
    fn all_spellings() {
        let spellings = [("25.", 25.0), ("-.5", -0.5), ("+.5", 0.5), ("1.5E+02", 150.0), ("1e-3", 0.001), ("-0", 0.0)];
        for (text, value) in spellings {
            assert_eq!(number(text.as_bytes()).map(f64::to_bits), Some(f64::to_bits(value)), "{text}");
        }
        for text in ["", ".", "-", "nan", "inf", "1 2", "1,2", "0x1", "1.2.3", "e5", "--1"] {
            assert_eq!(number(text.as_bytes()), None, "{text}");
        }
        assert_eq!(number(b"1e999"), Some(f64::INFINITY));
    }
}
