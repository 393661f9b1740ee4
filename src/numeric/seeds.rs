//! Where to start when there is no solution to follow: a grid over the rotary joints.

use std::f64::consts::FRAC_PI_4;

/// The angles of each rotary joint on the grid: no two of them are stationary together, as those along the machine's axes
/// often are.
const ANGLES_RAD: [f64; 4] = [FRAC_PI_4, -FRAC_PI_4, 3.0 * FRAC_PI_4, -3.0 * FRAC_PI_4];

/// Every combination of the angles, the linear joints at zero: near home first.
pub(super) fn starts(rotary: &[bool]) -> Vec<Vec<f64>> {
    let home = vec![vec![0.0; rotary.len()]];
    let turning = rotary.iter().enumerate().filter(|(_, rotary)| **rotary);
    turning.fold(home, |starts, (axis, _)| ANGLES_RAD.iter().flat_map(|&angle| turned(&starts, axis, angle)).collect())
}

/// The same starts with one joint at this angle.
fn turned(starts: &[Vec<f64>], axis: usize, angle_rad: f64) -> Vec<Vec<f64>> {
    let mut starts = starts.to_vec();
    starts.iter_mut().for_each(|start| start[axis] = angle_rad);
    starts
}
