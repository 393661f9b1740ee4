//! JSON has a -0, which nobody means.

/// The vector with each -0 as 0.
pub(super) fn unsigned_zero(vector: [f64; 3]) -> [f64; 3] {
    vector.map(|component| component + 0.0)
}
