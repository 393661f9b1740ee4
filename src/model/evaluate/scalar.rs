//! Scalar arithmetic: formulas over at most three numbers, evaluated by meval with functions that give the same bits on
//! every machine. Angles are in degrees, so that the quadrants are exact: `cos` of 90 is 0.
//!
//! Nothing else in the compiler knows meval. Its own functions and its `^` are the platform's: they are never reached.

use meval::{ContextProvider, Expr, FuncEvalError};

/// The arguments of a formula, under the names `a`, `b` and `c`.
struct Arguments<'a>(&'a [f64]);

impl ContextProvider for Arguments<'_> {
    fn get_var(&self, name: &str) -> Option<f64> {
        let index = ["a", "b", "c"].iter().position(|known| *known == name)?;
        self.0.get(index).copied()
    }

    fn eval_func(&self, name: &str, arguments: &[f64]) -> Result<f64, FuncEvalError> {
        match (name, arguments) {
            ("sin", &[a]) => Ok(sine(a, 0)),
            ("cos", &[a]) => Ok(sine(a, 1)),
            ("tan", &[a]) => Ok(sine(a, 0) / sine(a, 1)),
            ("asin", &[a]) => Ok(libm::asin(a).to_degrees()),
            ("acos", &[a]) => Ok(libm::acos(a).to_degrees()),
            ("atan", &[a]) => Ok(libm::atan(a).to_degrees()),
            ("atan2", &[a, b]) => Ok(libm::atan2(a, b).to_degrees()),
            ("sqrt", &[a]) => Ok(a.sqrt()),
            ("abs", &[a]) => Ok(a.abs()),
            ("min", &[a, b]) => Ok(a.min(b)),
            ("max", &[a, b]) => Ok(a.max(b)),
            ("pow", &[a, b]) => Ok(libm::pow(a, b)),
            _ => Err(FuncEvalError::UnknownFunction),
        }
    }
}

/// Evaluates a formula of ours such as `a + b` or `atan2(a, b)`. Angles in degrees; the result may be NaN or infinite,
/// and is never a negative zero.
///
/// # Panics
///
/// When the formula is not one: formulas are written in this program, not by its users.
pub(crate) fn evaluate(formula: &str, arguments: &[f64]) -> f64 {
    let expression: Expr = formula.parse().expect("formulas of the compiler's own can be parsed");
    let value = expression.eval_with_context(Arguments(arguments)).expect("formulas name what there is");
    value + 0.0
}

/// The sine of an angle and so many quadrants: exact at multiples of 90 degrees, and as near as a number can be at
/// those of 30 and 45 degrees.
fn sine(angle_deg: f64, quadrants_ahead: i64) -> f64 {
    let turn_deg = angle_deg % 360.0;
    let quadrant = (turn_deg / 90.0).round();
    let rest_deg = turn_deg - 90.0 * quadrant;
    match (quadrant as i64 + quadrants_ahead).rem_euclid(4) {
        0 => sin_near_zero(rest_deg),
        1 => cos_near_zero(rest_deg),
        2 => -sin_near_zero(rest_deg),
        _ => -cos_near_zero(rest_deg),
    }
}

/// The sine within half a quadrant.
fn sin_near_zero(angle_deg: f64) -> f64 {
    match angle_deg.abs() {
        30.0 => 0.5_f64.copysign(angle_deg),
        45.0 => std::f64::consts::FRAC_1_SQRT_2.copysign(angle_deg),
        _ => libm::sin(angle_deg.to_radians()),
    }
}

/// The cosine within half a quadrant.
fn cos_near_zero(angle_deg: f64) -> f64 {
    match angle_deg.abs() {
        45.0 => std::f64::consts::FRAC_1_SQRT_2,
        _ => libm::cos(angle_deg.to_radians()),
    }
}

#[cfg(test)]
mod tests {
    use super::evaluate;

    #[test]
    fn the_quadrants_are_exact() {
        for turns in -3..=3 {
            let angle_deg = f64::from(turns) * 360.0;
            let sines = [0.0, 90.0, 180.0, 270.0].map(|quadrant| evaluate("sin(a)", &[angle_deg + quadrant]));
            assert_eq!(sines, [0.0, 1.0, 0.0, -1.0]);
            let cosines = [0.0, 90.0, 180.0, 270.0].map(|quadrant| evaluate("cos(a)", &[angle_deg + quadrant]));
            assert_eq!(cosines, [1.0, 0.0, -1.0, 0.0]);
        }
    }

    #[test]
    fn the_usual_angles_are_exact() {
        assert_eq!(evaluate("sin(a)", &[30.0]), 0.5);
        assert_eq!(evaluate("cos(a)", &[60.0]), 0.5);
        assert_eq!(evaluate("cos(a)", &[-120.0]), -0.5);
        assert_eq!(evaluate("tan(a)", &[45.0]), 1.0);
        assert_eq!(evaluate("tan(a)", &[-45.0]), -1.0);
        assert_eq!(evaluate("atan2(a, b)", &[1.0, 1.0]), 45.0);
        assert_eq!(evaluate("asin(a)", &[1.0]), 90.0);
    }

    #[test]
    fn other_angles_agree_with_the_radians() {
        for step in -1000..1000 {
            let angle_deg = f64::from(step) * 0.737;
            let expected = libm::sin(angle_deg.to_radians());
            assert!((evaluate("sin(a)", &[angle_deg]) - expected).abs() < 1e-14, "{angle_deg}");
        }
    }

    #[test]
    fn a_negative_zero_does_not_leave() {
        assert_eq!(evaluate("-a", &[0.0]).to_bits(), 0.0_f64.to_bits());
        assert_eq!(evaluate("sin(a)", &[180.0]).to_bits(), 0.0_f64.to_bits());
    }

    #[test]
    fn precedence_is_the_usual_one() {
        assert_eq!(evaluate("a + b * c", &[1.0, 2.0, 3.0]), 7.0);
        assert_eq!(evaluate("pow(a, b)", &[2.0, 10.0]), 1024.0);
    }
}
