//! A strip that twists like a turbine blade: straight across, its stagger growing along the span.

use super::clsf::{Clsf, Cutter, Pose};

const HALF_SPAN_MM: f64 = 60.0;
const HALF_CHORD_MM: f64 = 12.0;
const HEIGHT_MM: f64 = 30.0;
const ROOT_STAGGER_DEG: f64 = 15.0;
const TWIST_DEG: f64 = 40.0;
const PASSES: u32 = 5;
const STEPS: u32 = 30;

/// The point (x, t cos φ, t sin φ) above the table, φ growing evenly with x, and the normal there.
fn pose(x: f64, t: f64) -> Pose {
    let share = (x + HALF_SPAN_MM) / (2.0 * HALF_SPAN_MM);
    let (sine, cosine) = libm::sincos((ROOT_STAGGER_DEG + share * TWIST_DEG).to_radians());
    let twist_rad_per_mm = TWIST_DEG.to_radians() / (2.0 * HALF_SPAN_MM);
    let length = (1.0 + t * t * twist_rad_per_mm * twist_rad_per_mm).sqrt();
    Pose {
        tip_mm: [x, t * cosine, HEIGHT_MM + t * sine],
        axis: [-t * twist_rad_per_mm / length, -sine / length, cosine / length],
    }
}

pub(crate) fn text() -> String {
    let at = |step: u32, steps: u32| 2.0 * f64::from(step) / f64::from(steps) - 1.0;
    let pass = |pass: u32| {
        let sense = if pass.is_multiple_of(2) { HALF_SPAN_MM } else { -HALF_SPAN_MM };
        (0..=STEPS).map(move |step| pose(sense * at(step, STEPS), HALF_CHORD_MM * at(pass, PASSES - 1)))
    };
    let cut: Vec<Pose> = (0..PASSES).flat_map(pass).collect();

    let mut cl = Clsf::default();
    let ball = Cutter { number: 4, name: "BALL_D6", diameter_mm: 6.0, corner_mm: 3.0, speed_rpm: 12000 };
    cl.begin("BLADE_SIDE", ball);
    cl.cut(&cut, 1000.0, 8.0);
    cl.end();
    cl.text()
}
