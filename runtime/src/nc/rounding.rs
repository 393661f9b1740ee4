//! From a value to whole units of a word's last decimal.

use super::dialect::Picture;

/// A picture's resolution and digits, as numbers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rounding {
    units_per_one: f64,
    /// The least number of units that has too many digits.
    too_many: u64,
}

/// The first whole number from which on doubles have no fraction.
const NO_FRACTION: f64 = (1_u64 << 52) as f64;

impl Rounding {
    pub(super) fn new(picture: &Picture) -> Self {
        Self { units_per_one: picture.units_per_one() as f64, too_many: picture.too_many_units().unsigned_abs() }
    }

    /// The value in whole units, halves away from zero, for a value that need not fit before it is reduced to a turn;
    /// nothing when it is not finite or has more digits than any picture.
    ///
    /// A double to which 2^52 is added is rounded to a whole number, halves to even, and has it in its last bits.
    #[inline]
    pub(super) fn unbounded(&self, value: f64) -> Option<i64> {
        const LIMIT: f64 = 1e15; // 10^MOST_DIGITS
        let scaled = (value * self.units_per_one).abs();
        let whole = scaled + NO_FRACTION;
        let is_half_lost = scaled - (whole - NO_FRACTION) >= 0.5;
        let units = whole.to_bits().wrapping_sub(NO_FRACTION.to_bits()) as i64 + i64::from(is_half_lost);
        (scaled < LIMIT).then_some(if value < 0.0 { -units } else { units })
    }

    /// Whether there are digits enough for so many units.
    #[inline]
    pub(super) fn fits(&self, units: i64) -> bool {
        units.unsigned_abs() < self.too_many
    }
}
