//! Strokes over a dome, each in a plane: through its very top, where the first rotary axis of many machines is free, or
//! a tenth of a degree beside it.

use super::clsf::{Clsf, Cutter, Pose};

const RADIUS_MM: f64 = 100.0;
const TOP_MM: f64 = 30.0;
const HALF_DEG: f64 = 18.0;
const MISS_DEG: f64 = 0.1;
const STEPS: u32 = 20;
/// Where the strokes lead to, from x.
const HEADINGS_DEG: [f64; 3] = [0.0, 90.0, 225.0];

/// On the stroke with this heading, whose plane leans by `miss_deg`.
fn pose(heading_deg: f64, miss_deg: f64, step: u32) -> Pose {
    let share = 2.0 * f64::from(step) / f64::from(STEPS) - 1.0;
    let (along, rest) = libm::sincos((share * HALF_DEG).to_radians());
    let (aside, up) = libm::sincos(miss_deg.to_radians());
    let (sine, cosine) = libm::sincos(heading_deg.to_radians());
    let (left, z) = (rest * aside, rest * up);
    let axis = [along * cosine - left * sine, along * sine + left * cosine, z];
    Pose { tip_mm: [RADIUS_MM * axis[0], RADIUS_MM * axis[1], TOP_MM - RADIUS_MM * (1.0 - axis[2])], axis }
}

fn strokes(operation: &str, miss_deg: f64) -> String {
    let mut cl = Clsf::default();
    let ball = Cutter { number: 7, name: "BALL_D12", diameter_mm: 12.0, corner_mm: 6.0, speed_rpm: 7000 };
    cl.begin(operation, ball);
    for heading_deg in HEADINGS_DEG {
        let cut: Vec<Pose> = (0..=STEPS).map(|step| pose(heading_deg, miss_deg, step)).collect();
        cl.cut(&cut, 1200.0, 10.0);
    }
    cl.end();
    cl.text()
}

pub(crate) fn crossed() -> String {
    strokes("POLE_CROSSED", 0.0)
}

pub(crate) fn missed() -> String {
    strokes("POLE_MISSED", MISS_DEG)
}
