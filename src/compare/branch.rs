//! Whether two machines turn their rotary axes into a direction in the same way.

use super::side::Reached;

/// Angles that differ by less than this, in degrees, are equal: rounding must not decide.
const TIE_DEG: f64 = 1e-6;

/// Whether the new machine takes the other of the old machine's solutions: it is nearer to that one, whole turns aside.
/// `rotaries` pairs the axes' indices.
pub(super) fn is_other(old: &Reached, new: &Reached, rotaries: &[(usize, usize)]) -> bool {
    let from_new = |joints: &[f64]| -> f64 {
        let apart = |&(a, b): &(usize, usize)| apart_deg(joints[a], new.joints()[b]);
        rotaries.iter().map(apart).sum()
    };
    let chosen = from_new(old.joints());
    old.candidates.iter().any(|candidate| from_new(&candidate.joints) + TIE_DEG < chosen)
}

/// Whether two angles differ by whole turns, as far as solutions that are the same can.
pub(super) fn has_other_turns(old_deg: f64, new_deg: f64) -> bool {
    (new_deg - old_deg).abs() > 180.0 + TIE_DEG
}

/// The angle between two angles, from 0 to 180 degrees.
fn apart_deg(a: f64, b: f64) -> f64 {
    let apart = (a - b).rem_euclid(360.0);
    apart.min(360.0 - apart)
}
