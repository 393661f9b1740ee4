//! Numbers in a person's notation.

use nalgebra::Vector3;

/// A number to twelve digits; multiples of a right angle as such, a half diagonal as `√½`.
pub fn number(value: f64) -> String {
    let close = |to: f64| (value.abs() - to).abs() < 4.0 * f64::EPSILON;
    let sign = if value < 0.0 { "-" } else { "" };
    if close(std::f64::consts::PI) {
        return format!("{sign}π");
    }
    if close(std::f64::consts::FRAC_PI_2) {
        return format!("{sign}π/2");
    }
    if close(std::f64::consts::FRAC_1_SQRT_2) {
        return format!("{sign}√½");
    }
    let text = format!("{value:.12}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A vector of such numbers.
pub fn vector(v: &Vector3<f64>) -> String {
    format!("({}, {}, {})", number(v.x), number(v.y), number(v.z))
}
