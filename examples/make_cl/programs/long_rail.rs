//! The top of a rail along x, upright: more than a metre, which many machines do not have.

use super::clsf::{Clsf, Cutter, Pose, UP};

const HALF_MM: f64 = 600.0;
const HALF_WIDTH_MM: f64 = 10.0;
const STEPS: u32 = 12;

pub(crate) fn text() -> String {
    let x_mm = |step: u32| HALF_MM * (2.0 * f64::from(step) / f64::from(STEPS) - 1.0);
    let there = (0..=STEPS).map(|step| [x_mm(step), -HALF_WIDTH_MM, 0.0]);
    let back = (0..=STEPS).map(|step| [-x_mm(step), HALF_WIDTH_MM, 0.0]);
    let cut: Vec<Pose> = there.chain(back).map(|tip_mm| Pose { tip_mm, axis: UP }).collect();

    let mut cl = Clsf::default();
    let mill = Cutter { number: 9, name: "MILL_D32", diameter_mm: 32.0, corner_mm: 0.0, speed_rpm: 3000 };
    cl.begin("RAIL_TOP", mill);
    cl.cut(&cut, 1500.0, 20.0);
    cl.end();
    cl.text()
}
