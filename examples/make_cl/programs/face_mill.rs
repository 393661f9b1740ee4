//! Three axes, two tools: a face milled in rows joined by half circles, then the contour around it with round corners.

use super::clsf::{Clsf, Cutter, Pose, UP};

const HALF_MM: [f64; 2] = [60.0, 40.0];
const CORNER_MM: f64 = 10.0;
const DEPTH_MM: f64 = 8.0;
const CLEARANCE_MM: f64 = 20.0;

fn at(x: f64, y: f64, z: f64) -> Pose {
    Pose { tip_mm: [x, y, z], axis: UP }
}

/// The face at z = 0, in three rows along x.
fn face(cl: &mut Clsf) {
    let mill = Cutter { number: 1, name: "FACE_D40", diameter_mm: 40.0, corner_mm: 0.0, speed_rpm: 2400 };
    let (end, row) = (HALF_MM[0] + 5.0, 25.0);
    cl.begin("FACE", mill);
    cl.rapid(at(-end - 25.0, -row, CLEARANCE_MM));
    cl.rapid(at(-end - 25.0, -row, 2.0));
    cl.feed(800.0);
    cl.goto(at(-end - 25.0, -row, 0.0));
    cl.goto(at(end, -row, 0.0));
    cl.arc([end, -row / 2.0, 0.0], row / 2.0, true, at(end, 0.0, 0.0));
    cl.goto(at(-end, 0.0, 0.0));
    cl.arc([-end, row / 2.0, 0.0], row / 2.0, false, at(-end, row, 0.0));
    cl.goto(at(end + 25.0, row, 0.0));
    cl.rapid(at(end + 25.0, row, CLEARANCE_MM));
    cl.end();
}

/// Around the block, clockwise (climb milling), on a quarter circle in and out.
fn contour(cl: &mut Clsf) {
    let mill = Cutter { number: 6, name: "END_MILL_D12", diameter_mm: 12.0, corner_mm: 0.0, speed_rpm: 5300 };
    let radius = mill.diameter_mm / 2.0;
    let [x, y] = HALF_MM.map(|half| half + radius);
    let (r, z) = (CORNER_MM + radius, -DEPTH_MM);
    cl.begin("CONTOUR", mill);
    cl.rapid(at(-r, y + r, CLEARANCE_MM));
    cl.rapid(at(-r, y + r, 2.0));
    cl.feed(300.0);
    cl.goto(at(-r, y + r, z));
    cl.feed(700.0);
    cl.arc([0.0, y + r, z], r, true, at(0.0, y, z));
    for (corner, [cx, cy]) in [[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]].into_iter().enumerate() {
        let centre = [cx * (x - r), cy * (y - r), z];
        let side = at(centre[0] + cx * r, centre[1], z);
        let end = at(centre[0], centre[1] + cy * r, z);
        let (from, to) = if corner % 2 == 0 { (end, side) } else { (side, end) };
        cl.goto(from);
        cl.arc(centre, r, false, to);
    }
    cl.goto(at(0.0, y, z));
    cl.arc([0.0, y + r, z], r, true, at(r, y + r, z));
    cl.rapid(at(r, y + r, CLEARANCE_MM));
    cl.end();
}

pub(crate) fn text() -> String {
    let mut cl = Clsf::default();
    face(&mut cl);
    contour(&mut cl);
    cl.text()
}
