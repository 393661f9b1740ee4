//! A cone, finished from near its top in 1.6 turns, the cutter square on it: tilted by 30 degrees, and 576 degrees round.

use super::clsf::{Clsf, Cutter, Pose};

const TILT_DEG: f64 = 30.0;
const TOP_RADIUS_MM: f64 = 20.0;
const TOP_MM: f64 = 40.0;
const GROWTH_MM: f64 = 32.0;
const ROUND_DEG: f64 = 576.0;
const STEPS: u32 = 48;

fn pose(step: u32) -> Pose {
    let share = f64::from(step) / f64::from(STEPS);
    let (sine, cosine) = libm::sincos((share * ROUND_DEG).to_radians());
    let (level, up) = libm::sincos(TILT_DEG.to_radians());
    let radius_mm = TOP_RADIUS_MM + share * GROWTH_MM;
    let z_mm = TOP_MM - share * GROWTH_MM * level / up;
    Pose { tip_mm: [radius_mm * cosine, radius_mm * sine, z_mm], axis: [level * cosine, level * sine, up] }
}

pub(crate) fn text() -> String {
    let cut: Vec<Pose> = (0..=STEPS).map(pose).collect();

    let mut cl = Clsf::default();
    let ball = Cutter { number: 6, name: "BALL_D10", diameter_mm: 10.0, corner_mm: 5.0, speed_rpm: 8000 };
    cl.begin("CONE_FINISH", ball);
    cl.cut(&cut, 1000.0, 10.0);
    cl.end();
    cl.text()
}
