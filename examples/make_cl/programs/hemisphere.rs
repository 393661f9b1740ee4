//! A hemisphere, finished in one spiral from near its foot up to the very top, the cutter square on it.

use super::clsf::{Clsf, Cutter, Pose};
use std::f64::consts::{FRAC_PI_2, TAU};

const RADIUS_MM: f64 = 30.0;
const TURNS: u32 = 6;
const STEPS_A_TURN: u32 = 36;
/// From the horizontal.
const FOOT_RAD: f64 = FRAC_PI_2 / 9.0;

fn pose(step: u32) -> Pose {
    let steps = TURNS * STEPS_A_TURN;
    let share = f64::from(step) / f64::from(steps);
    let height_rad = FOOT_RAD + share * (FRAC_PI_2 - FOOT_RAD);
    let (sine, cosine) = libm::sincos(TAU * f64::from(step) / f64::from(STEPS_A_TURN));
    let (z, level) = if step == steps { (1.0, 0.0) } else { libm::sincos(height_rad) };
    let axis = [level * cosine, level * sine, z];
    Pose { tip_mm: axis.map(|component| RADIUS_MM * component), axis }
}

pub(crate) fn text() -> String {
    let cut: Vec<Pose> = (0..=TURNS * STEPS_A_TURN).map(pose).collect();

    let mut cl = Clsf::default();
    let ball = Cutter { number: 3, name: "BALL_D8", diameter_mm: 8.0, corner_mm: 4.0, speed_rpm: 10000 };
    cl.begin("DOME_FINISH", ball);
    cl.cut(&cut, 900.0, 10.0);
    cl.end();
    cl.text()
}
