//! The poses that everyone solves.

/// A tool on a part.
pub(crate) struct Pose {
    /// The tip, in millimetres from the part's zero.
    pub(crate) tip_mm: [f64; 3],
    /// The unit direction from the tip to the spindle.
    pub(crate) axis: [f64; 3],
    /// How far the tool is turned about itself. Only the robot has to be told.
    pub(crate) roll_rad: f64,
}

/// Tips in a box of 200 x 200 x 100 mm, tilted by up to 40 degrees: within reach of every machine here.
pub(crate) fn seeded(count: usize) -> Vec<Pose> {
    let mut random = SplitMix(0x7065_6572);
    (0..count).map(|_| pose(&mut random)).collect()
}

fn pose(random: &mut SplitMix) -> Pose {
    let half_turn = std::f64::consts::PI;
    let tip_mm = [random.within(-100.0, 100.0), random.within(-100.0, 100.0), random.within(0.0, 100.0)];
    let (sin_tilt, cos_tilt) = libm::sincos(random.within(0.0, 40.0_f64.to_radians()));
    let (sin_turn, cos_turn) = libm::sincos(random.within(-half_turn, half_turn));
    let axis = [sin_tilt * cos_turn, sin_tilt * sin_turn, cos_tilt];
    Pose { tip_mm, axis, roll_rad: random.within(-half_turn, half_turn) }
}

/// Steele, Lea and Flood's generator: the same poses on every machine.
struct SplitMix(u64);

impl SplitMix {
    fn within(&mut self, least: f64, most: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        least + (most - least) * ((bits >> 11) as f64 / (1_u64 << 53) as f64)
    }
}
