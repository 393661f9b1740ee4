//! From a value to whole units of a picture's last decimal.

/// A resolution and a bound.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rounding {
    units_per_one: f64,
    /// The least number that is rounded to too many units.
    too_many: f64,
}

/// The first whole number from which on doubles have no fraction.
const NO_FRACTION: f64 = (1_u64 << 52) as f64;

impl Rounding {
    /// Rounds to units of which so many make one, and refuses what is that many units or more.
    pub(super) fn new(units_per_one: i64, too_many_units: i64) -> Self {
        Self { units_per_one: units_per_one as f64, too_many: too_many_units as f64 - 0.5 }
    }

    /// The value in whole units, halves away from zero; nothing when it is not a number or has too many digits.
    ///
    /// A double to which 2^52 is added is rounded to a whole number, halves to even, and has it in its last bits.
    #[inline]
    pub(crate) fn units(&self, value: f64) -> Option<i64> {
        let scaled = (value * self.units_per_one).abs();
        let whole = scaled + NO_FRACTION;
        let is_half_lost = scaled - (whole - NO_FRACTION) >= 0.5;
        let units = whole.to_bits().wrapping_sub(NO_FRACTION.to_bits()) as i64 + i64::from(is_half_lost);
        (scaled < self.too_many).then_some(if value < 0.0 { -units } else { units })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rule in whole numbers: twice the value, and one more, halved.
    fn rounded(scaled: f64) -> i64 {
        let units = ((2.0 * scaled.abs()) as i64 + 1) / 2;
        if scaled < 0.0 { -units } else { units }
    }

    #[test]
    fn halves_go_away_from_zero() {
        let rounding = Rounding::new(1, 1_000_000_000_000_000);
        let halves =
            (0..50).flat_map(|n| [1_i64 << n, (1 << n) - 1, 3 << n >> 2]).filter(|n| *n < 1_000_000_000_000_000);
        for half in halves.map(|whole| whole as f64 - 0.5) {
            for value in [half.next_down(), half, half.next_up(), half + 0.5] {
                assert_eq!(rounding.units(value), Some(rounded(value)), "{value}");
                assert_eq!(rounding.units(-value), Some(rounded(-value)), "-{value}");
            }
        }
    }

    #[test]
    fn what_has_too_many_digits() {
        for digits in 1..=15 {
            let too_many = 10_i64.pow(digits);
            let (rounding, greatest) = (Rounding::new(1, too_many), too_many - 1);
            let end = greatest as f64 + 0.5;
            assert_eq!(rounding.units(end.next_down()), Some(greatest));
            assert_eq!(rounding.units(-end.next_down()), Some(-greatest));
            for value in [end, -end, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
                assert_eq!(rounding.units(value), None, "{value}");
            }
        }
    }
}
