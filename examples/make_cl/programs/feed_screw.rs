//! A helical groove around a bar that lies along x: four axes, several turns.

use super::clsf::{Clsf, Cutter, Pose};
use std::f64::consts::TAU;

const RADIUS_MM: f64 = 25.0;
const PITCH_MM: f64 = 20.0;
const TURNS: u32 = 3;
const STEPS_A_TURN: u32 = 24;

fn pose(step: u32) -> Pose {
    let turns = f64::from(step) / f64::from(STEPS_A_TURN);
    let (sine, cosine) = libm::sincos(TAU * turns);
    let axis = [0.0, -sine, cosine];
    let along_mm = PITCH_MM * (turns - f64::from(TURNS) / 2.0);
    Pose { tip_mm: [along_mm, RADIUS_MM * axis[1], RADIUS_MM * axis[2]], axis }
}

pub(crate) fn text() -> String {
    let cut: Vec<Pose> = (0..=TURNS * STEPS_A_TURN).map(pose).collect();

    let mut cl = Clsf::default();
    let ball = Cutter { number: 5, name: "BALL_D10", diameter_mm: 10.0, corner_mm: 5.0, speed_rpm: 6000 };
    cl.begin("SCREW_GROOVE", ball);
    cl.cut(&cut, 600.0, 8.0);
    cl.end();
    cl.text()
}
