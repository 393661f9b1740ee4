//! Numbers of CL text.

use crate::number::{Decimal, usual_decimal};

/// With more digits, a plain decimal is not sure to be the closest double.
const MOST_PLAIN_DIGITS: usize = 15;

/// A plain decimal (`-12.3456`, `.5`, `25.`) at the start of `text`, and what stands behind it. `None` when there is none
/// or when it has more than 15 digits: [`number`] decides those.
#[inline]
pub(super) fn plain_decimal(text: &[u8]) -> Option<(f64, &[u8])> {
    usual_decimal(text).or_else(|| unusual_decimal(text))
}

#[cold]
#[inline(never)]
fn unusual_decimal(text: &[u8]) -> Option<(f64, &[u8])> {
    let negative = text.first() == Some(&b'-');
    let unsigned = &text[usize::from(negative)..];
    let decimal = Decimal::leading(unsigned).filter(|decimal| decimal.count <= MOST_PLAIN_DIGITS)?;
    Some((decimal.value(negative), &unsigned[decimal.length..]))
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
            let (value, rest) = plain_decimal(text.as_bytes()).unwrap();
            assert_eq!(value.to_bits(), (expected + 0.0).to_bits(), "{text}");
            assert!(rest.is_empty(), "{text}");
        }
    }

    #[test]
    fn what_is_not_plain_is_left() {
        for text in ["", "-", ".", "-.", "+1", "x", "1234567890.123456"] {
            assert_eq!(plain_decimal(text.as_bytes()), None, "{text}");
        }
        assert_eq!(plain_decimal(b"1.5,2"), Some((1.5, &b",2"[..])));
        assert_eq!(plain_decimal(b"1.5E3"), Some((1.5, &b"E3"[..])));
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
