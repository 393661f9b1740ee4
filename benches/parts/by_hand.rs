//! Inverses as one writes them by hand for one machine: both solutions of every pose, the textbook's equations, nothing about
//! poles or reach.

use libm::{atan2, sincos};
use mach_runtime::kinematics::{LANES, PoseBlock, SolutionBlock};

/// A table C on a cradle A, both axes through (0, 0, -20).
pub(crate) fn trunnion(poses: &PoseBlock, tool_length_mm: f64, out: &mut SolutionBlock) {
    for lane in 0..LANES {
        let ([x, y, z], [i, j, k]) = (poses.tip(lane), poses.axis(lane));
        let tilt = atan2((i * i + j * j).sqrt(), k);
        let first = [tilt, atan2(i, -j)];
        let second = [-tilt, atan2(-i, j)];
        for (lanes, [a, c]) in out.branches.iter_mut().zip([first, second]) {
            let ((sin_a, cos_a), (sin_c, cos_c)) = (sincos(a), sincos(c));
            let (height, along) = (z + 20.0, y * cos_c - x * sin_c);
            lanes[0][lane] = x * cos_c + y * sin_c;
            lanes[1][lane] = along * cos_a + height * sin_a;
            lanes[2][lane] = height * cos_a - along * sin_a - 20.0 + tool_length_mm;
            lanes[3][lane] = a.to_degrees();
            lanes[4][lane] = c.to_degrees();
        }
    }
}

/// A table C on an axis B inclined by 45 degrees, which cross 155 mm above the table.
pub(crate) fn nutating(poses: &PoseBlock, tool_length_mm: f64, out: &mut SolutionBlock) {
    const HALF_DIAGONAL: f64 = std::f64::consts::FRAC_1_SQRT_2;
    for lane in 0..LANES {
        let ([x, y, z], [i, j, k]) = (poses.tip(lane), poses.axis(lane));
        let tilt = libm::acos(2.0 * k - 1.0);
        for (lanes, b) in out.branches.iter_mut().zip([tilt, -tilt]) {
            let (sin_b, cos_b) = sincos(b);
            let (across, along) = (HALF_DIAGONAL * sin_b, 0.5 * (cos_b - 1.0));
            let c = atan2(j * across - i * along, i * across + j * along);
            let (sin_c, cos_c) = sincos(c);
            let (u, v, w) = (x * cos_c + y * sin_c, y * cos_c - x * sin_c, z - 155.0);
            lanes[0][lane] = u * cos_b - across * (v + w) - 250.0;
            lanes[1][lane] = across * u + (along + 1.0) * v + along * w - 155.0;
            lanes[2][lane] = across * u + along * v + (along + 1.0) * w - 387.0 + tool_length_mm;
            lanes[3][lane] = b.to_degrees();
            lanes[4][lane] = c.to_degrees();
        }
    }
}
