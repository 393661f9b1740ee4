//! The candidates of a block of poses, and what came of each pose.

use super::{JointBlock, Kinematics, LANES, Lane, Miss, Outcome, Pole, Tolerances};

/// The candidates of a block.
#[derive(Debug, Clone)]
pub struct SolutionBlock {
    /// `branches[b][a][l]`. Rotary values lie within one turn; whole turns are the branch choice's business.
    pub branches: Vec<JointBlock>,
    margins: Margins,
    pole: Option<Pole>,
    /// A bit for each lane.
    uncompensated: u64,
}

/// What an inverse leaves beside the joints, lane by lane. Where the linear axes do not span space some joints are no numbers.
#[derive(Debug, Clone)]
pub struct Margins {
    /// Zero where the wanted direction is within reach. Else minus the angle to the nearest direction that is, in radians (to
    /// first order).
    pub reach_rad: Lane,
    /// How far it is to the [`Pole`]: a sine or millimetres; of no meaning without one.
    pub pole: Lane,
    /// Zero where the wanted tip is within reach of the linear axes. Else how far it is from there, in millimetres (to first
    /// order): only machines with fewer than three linear axes know such tips.
    pub gap_mm: Lane,
}

impl SolutionBlock {
    /// A block to be filled by these kinematics.
    pub fn of<K: Kinematics + ?Sized>(kinematics: &K) -> Self {
        Self {
            branches: vec![vec![[0.0; LANES]; kinematics.axis_count()]; kinematics.branch_count()],
            margins: Margins { reach_rad: [0.0; LANES], pole: [0.0; LANES], gap_mm: [0.0; LANES] },
            pole: kinematics.pole(),
            uncompensated: 0,
        }
    }

    /// The candidates and the margins, for an inverse to fill; everybody else reads outcomes.
    pub fn parts_mut(&mut self) -> (&mut [JointBlock], &mut Margins) {
        (&mut self.branches, &mut self.margins)
    }

    /// What came of each pose.
    pub fn outcomes(&self, tolerances: Tolerances) -> [Outcome; LANES] {
        if self.is_reached(tolerances) {
            return [Outcome::Reached; LANES];
        }
        std::array::from_fn(|lane| self.outcome(lane, tolerances))
    }

    /// What came of one pose.
    pub fn outcome(&self, lane: usize, tolerances: Tolerances) -> Outcome {
        let Margins { reach_rad, pole, gap_mm } = &self.margins;
        let (by_rad, pole_distance, gap_mm) = (-reach_rad[lane], pole[lane], gap_mm[lane]);
        match self.pole {
            _ if by_rad > tolerances.axis_rad => Outcome::Missed(Miss::OutOfReach { by_rad }),
            Some(Pole::Position { .. }) if gap_mm > tolerances.plane_mm => {
                Outcome::Missed(Miss::InsideDeadRadius { gap_mm, radius_mm: pole_distance + gap_mm })
            }
            _ if gap_mm > tolerances.plane_mm => Outcome::Missed(Miss::OffPlane { by_mm: gap_mm }),
            Some(pole) if pole_distance < pole.bound() => Outcome::FreeAtPole { axis: pole.axis() },
            _ if self.uncompensated & (1 << lane) != 0 => Outcome::Missed(Miss::NotCompensated),
            _ if !self.joints().all(|joint| joint[lane].is_finite()) => Outcome::Missed(Miss::Singular),
            _ => Outcome::Reached,
        }
    }

    /// Whether all of them are reached: the usual case, found without looking at one after the other.
    fn is_reached(&self, tolerances: Tolerances) -> bool {
        let Margins { reach_rad, pole, gap_mm } = &self.margins;
        let bound = self.pole.map_or(f64::NEG_INFINITY, Pole::bound);
        // Zero where every joint is a number.
        let mut sums = [0.0; LANES];
        for joint in self.joints() {
            (0..LANES).for_each(|lane| sums[lane] += 0.0 * joint[lane]);
        }
        let is_off = |lane: usize| {
            (-reach_rad[lane] > tolerances.axis_rad)
                | (gap_mm[lane] > tolerances.plane_mm)
                | (pole[lane] < bound)
                | (sums[lane] != 0.0)
        };
        self.uncompensated == 0 && !(0..LANES).fold(false, |any, lane| any | is_off(lane))
    }

    fn joints(&self) -> impl Iterator<Item = &Lane> {
        self.branches.iter().flatten()
    }

    /// Which lanes' candidates are not compensated: a bit for each.
    pub(crate) fn set_uncompensated(&mut self, lanes: u64) {
        self.uncompensated = lanes;
    }
}

/// Whether joints hold the tip: where the linear axes do not span space some are no numbers.
///
/// # Errors
///
/// Where they do not.
pub fn held(joints: &[f64]) -> Result<(), Miss> {
    if joints.iter().all(|joint| joint.is_finite()) { Ok(()) } else { Err(Miss::Singular) }
}
