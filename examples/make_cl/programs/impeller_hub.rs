//! The hub of an impeller, one stroke a passage from the inlet down to the outlet. The cutter leans far out at the inlet
//! and stands up at the outlet, and the passages wind about the axis.

use super::clsf::{Clsf, Cutter, Pose};
use std::f64::consts::FRAC_PI_2;

const INLET_MM: [f64; 2] = [14.0, 44.0];
const OUTLET_MM: [f64; 2] = [48.0, 12.0];
const TILT_DEG: [f64; 2] = [70.0, 25.0];
const WRAP_DEG: f64 = 45.0;
/// How far the cutter leans out of the plane through the axis, along the blades.
const LEAN_DEG: f64 = 12.0;
const PASSAGES: u32 = 5;
const STEPS: u32 = 14;

/// The hub's profile is the quarter of an ellipse, steep at the inlet and flat at the outlet.
fn pose(passage: u32, step: u32) -> Pose {
    let share = f64::from(step) / f64::from(STEPS);
    let between = |ends: [f64; 2]| ends[0] + share * (ends[1] - ends[0]);
    let (down, out) = libm::sincos(share * FRAC_PI_2);
    let radius_mm = OUTLET_MM[0] - out * (OUTLET_MM[0] - INLET_MM[0]);
    let z_mm = INLET_MM[1] - down * (INLET_MM[1] - OUTLET_MM[1]);
    let azimuth_deg = 360.0 * f64::from(passage) / f64::from(PASSAGES) + share * WRAP_DEG;
    let (place_sine, place_cosine) = libm::sincos(azimuth_deg.to_radians());
    let (sine, cosine) = libm::sincos((azimuth_deg + LEAN_DEG).to_radians());
    let (level, up) = libm::sincos(between(TILT_DEG).to_radians());
    Pose { tip_mm: [radius_mm * place_cosine, radius_mm * place_sine, z_mm], axis: [level * cosine, level * sine, up] }
}

pub(crate) fn text() -> String {
    let mut cl = Clsf::default();
    let taper = Cutter { number: 8, name: "BALL_D4", diameter_mm: 4.0, corner_mm: 2.0, speed_rpm: 14000 };
    cl.begin("HUB_FINISH", taper);
    for passage in 0..PASSAGES {
        let cut: Vec<Pose> = (0..=STEPS).map(|step| pose(passage, step)).collect();
        cl.cut(&cut, 700.0, 40.0);
    }
    cl.end();
    cl.text()
}
