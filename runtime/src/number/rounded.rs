//! Values for people's eyes.

/// The value to so many decimals. What rounds to zero has no minus.
fn rounded(value: f64, decimals: usize) -> f64 {
    let one = (0..decimals).fold(1.0, |one, _| 10.0 * one);
    (value * one).round() / one + 0.0
}

/// The value with so many decimals.
pub fn fixed(value: f64, decimals: usize) -> String {
    format!("{:.decimals$}", rounded(value, decimals))
}

/// The value with so many decimals at most: without zeros at the end.
pub fn short(value: f64, decimals: usize) -> String {
    format!("{}", rounded(value, decimals))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_printed_as_minus_zero() {
        assert_eq!(fixed(-0.000_04, 4), "0.0000");
        assert_eq!(short(-0.000_04, 4), "0");
        assert_eq!(fixed(-12.345_67, 3), "-12.346");
        assert_eq!(short(-12.34, 3), "-12.34");
    }
}
