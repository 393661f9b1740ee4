//! A sine surface, finished zig-zag with a ball cutter that stands square on it.

use super::clsf::{Clsf, Cutter, Pose};
use std::f64::consts::TAU;

const HALF_MM: f64 = 50.0;
const LENGTH_MM: f64 = 100.0;
const HEIGHT_MM: f64 = 5.0;
const PASSES: u32 = 11;
const STEPS: u32 = 20;

/// z = 20 + 5 sin(2πx/100) + 5 sin(2πy/100), and the normal there.
fn pose(x: f64, y: f64) -> Pose {
    let wave = |at: f64| libm::sin(TAU * at / LENGTH_MM) * HEIGHT_MM;
    let slope = |at: f64| libm::cos(TAU * at / LENGTH_MM) * HEIGHT_MM * TAU / LENGTH_MM;
    let length = (slope(x) * slope(x) + slope(y) * slope(y) + 1.0).sqrt();
    Pose { tip_mm: [x, y, 20.0 + wave(x) + wave(y)], axis: [-slope(x) / length, -slope(y) / length, 1.0 / length] }
}

pub(crate) fn text() -> String {
    let at = |step: u32, steps: u32| HALF_MM * (2.0 * f64::from(step) / f64::from(steps) - 1.0);
    let pass = |pass: u32| {
        let along = move |step| if pass.is_multiple_of(2) { at(step, STEPS) } else { -at(step, STEPS) };
        (0..=STEPS).map(move |step| pose(along(step), at(pass, PASSES - 1)))
    };
    let cut: Vec<Pose> = (0..PASSES).flat_map(pass).collect();

    let mut cl = Clsf::default();
    let ball = Cutter { number: 2, name: "BALL_D10", diameter_mm: 10.0, corner_mm: 5.0, speed_rpm: 8000 };
    cl.begin("SINE_FINISH", ball);
    cl.cut(&cut, 1200.0, 8.0);
    cl.end();
    cl.text()
}
