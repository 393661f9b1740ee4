//! Values for people's eyes.

/// The value to so many decimals. What rounds to zero has no minus.
pub fn rounded(value: f64, decimals: usize) -> f64 {
    let one = (0..decimals).fold(1.0, |one, _| 10.0 * one);
    (value * one).round() / one + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_printed_as_minus_zero() {
        assert_eq!(format!("{:.4}", rounded(-0.000_04, 4)), "0.0000");
        assert_eq!(rounded(-12.345_67, 3), -12.346);
        assert_eq!(rounded(1e300, 0), 1e300);
    }
}
