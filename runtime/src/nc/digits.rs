//! The digits of a number, all at once.

/// The eight digits of a number as the bytes of a word, the first in the lowest byte: halved three times, all parts at
/// once.
#[inline]
pub(super) fn eight_digits(number: u32) -> u64 {
    let high = u64::from(number / 10_000);
    let fours = (u64::from(number) << 32) - high * ((10_000 << 32) - 1);
    let hundreds = (fours * 10_486) >> 20 & 0x0000_007f_0000_007f;
    let twos = (fours << 16) - hundreds * ((100 << 16) - 1);
    let tens = (twos * 103) >> 10 & 0x000f_000f_000f_000f;
    (twos << 8) - tens * ((10 << 8) - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_digit_is_in_the_lowest_byte() {
        let powers = (0..8).map(|n| 10_u32.pow(n));
        let near_powers = powers.flat_map(|power| [power - 1, power, 9 * power, 10 * power - 1]);
        for number in near_powers.chain((0..100_000_000).step_by(997)) {
            let digits = format!("{number:08}").into_bytes().try_into().expect("eight digits");
            assert_eq!(eight_digits(number) | u64::from_le_bytes([b'0'; 8]), u64::from_le_bytes(digits), "{number}");
        }
    }
}
