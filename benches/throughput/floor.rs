//! The floor: the least work that yields the same numbers for an A/C table with its centre at z = -20.

#![allow(clippy::disallowed_methods)] // the platform's own functions: this is what a hand-written post would call

use std::io::Write;
use std::path::Path;

/// Reads GOTO records, takes the nearer of two solutions, prints three decimals.
pub(crate) fn post(cl: &Path, nc: &Path) {
    let text = std::fs::read(cl).expect("the CL file is there");
    let mut out = Vec::with_capacity(text.len());
    let mut axis = [0.0, 0.0, 1.0];
    let mut previous = [0.0, 0.0];
    let mut start = 0;
    for end in memchr::memchr_iter(b'\n', &text) {
        let line = &text[start..end];
        start = end + 1;
        let Some(arguments) = line.strip_prefix(b"GOTO/") else { continue };
        let (numbers, count) = six_numbers(arguments);
        if count == 6 {
            axis.copy_from_slice(&numbers[3..]);
        }
        previous = nearer(axis, previous);
        block(&mut out, [numbers[0], numbers[1], numbers[2]], previous);
    }
    std::fs::File::create(nc).and_then(|mut file| file.write_all(&out)).expect("the NC file is written");
}

fn six_numbers(mut text: &[u8]) -> ([f64; 6], usize) {
    let mut numbers = [0.0; 6];
    for (count, number) in numbers.iter_mut().enumerate() {
        let (value, used) = fast_float2::parse_partial(text).expect("a number");
        *number = value;
        match text.get(used) {
            Some(b',') => text = &text[used + 1..],
            _ => return (numbers, count + 1),
        }
    }
    (numbers, 6)
}

fn nearer([i, j, k]: [f64; 3], [a, c]: [f64; 2]) -> [f64; 2] {
    let tilt = i.hypot(j).atan2(k);
    let turn = if tilt == 0.0 { c } else { i.atan2(-j) };
    let unwound = |turn: f64| turn - ((turn - c) / std::f64::consts::TAU).round() * std::f64::consts::TAU;
    let candidates = [[tilt, unwound(turn)], [-tilt, unwound(turn + std::f64::consts::PI)]];
    let [first, second] = candidates.map(|[tilt, turn]| (tilt - a).abs() + (turn - c).abs());
    candidates[usize::from(second < first)]
}

fn block(out: &mut Vec<u8>, [x, y, z]: [f64; 3], [a, c]: [f64; 2]) {
    let ((sin_a, cos_a), (sin_c, cos_c)) = (a.sin_cos(), c.sin_cos());
    let (height, along) = (z + 20.0, -x * sin_c + y * cos_c);
    out.extend_from_slice(b"G1");
    word(out, b'X', x * cos_c + y * sin_c);
    word(out, b'Y', along * cos_a + height * sin_a);
    word(out, b'Z', -along * sin_a + height * cos_a - 20.0);
    word(out, b'A', a.to_degrees());
    word(out, b'C', c.to_degrees());
    out.push(b'\n');
}

fn word(out: &mut Vec<u8>, letter: u8, value: f64) {
    out.extend_from_slice(&[b' ', letter]);
    let units = (value * 1000.0).round() as i64;
    if units < 0 {
        out.push(b'-');
    }
    let (mut whole, mut fraction) = (units.unsigned_abs() / 1000, units.unsigned_abs() % 1000);
    let (mut digits, mut at) = ([0; 20], 20);
    while whole > 0 {
        at -= 1;
        digits[at] = b'0' + (whole % 10) as u8;
        whole /= 10;
    }
    out.extend_from_slice(&digits[at..]);
    if at == 20 && fraction == 0 {
        out.push(b'0');
    }
    out.push(b'.');
    let mut place = 100;
    while fraction > 0 {
        out.push(b'0' + (fraction / place) as u8);
        fraction %= place;
        place /= 10;
    }
}
