//! The peer: `rs-opw-kinematics`, closed-form inverses of robots with six rotary joints and a spherical wrist.

use crate::GAUGE_LENGTH_MM;
use crate::poses::Pose;
use rs_opw_kinematics::glam::{DQuat, DVec3};
use rs_opw_kinematics::kinematic_traits::{Kinematics, Pose as Flange, Solutions};
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;
use std::hint::black_box;

/// Where the part's zero is on the robot's floor, in metres.
const PART_M: DVec3 = DVec3::new(0.8, 0.0, 0.4);
/// The peer promises a millionth of the robot's links, 2.4 m altogether.
const TOLERANCE_M: f64 = 2.4e-6;
const TOLERANCE_RAD: f64 = 1e-6;

/// An ABB IRB 2400/10 that holds the tool over the part.
pub(crate) struct Robot {
    kinematics: OPWKinematics,
    flanges: Vec<Flange>,
}

impl Robot {
    pub(crate) fn new(poses: &[Pose]) -> Self {
        let kinematics = OPWKinematics::new(Parameters::irb2400_10());
        Self { kinematics, flanges: poses.iter().map(flange).collect() }
    }

    /// Solves every pose; how many solutions there are.
    pub(crate) fn solve(&self) -> usize {
        self.flanges.iter().map(|flange| black_box(self.kinematics.inverse(flange)).len()).sum()
    }

    /// As [`Self::solve`] where the tool may turn about itself: joint 6 stays at zero.
    pub(crate) fn solve_without_roll(&self) -> usize {
        self.flanges.iter().map(|flange| black_box(self.kinematics.inverse_5dof(flange, 0.0)).len()).sum()
    }

    /// How many solutions lead back to their pose.
    pub(crate) fn right(&self) -> usize {
        let same = |wanted: &Flange, found: Flange| found.angular_distance(*wanted) <= TOLERANCE_RAD;
        self.count(|flange| self.kinematics.inverse(flange), same)
    }

    /// How many solutions without roll lead back to their tip and direction.
    pub(crate) fn right_without_roll(&self) -> usize {
        let same = |wanted: &Flange, found: Flange| {
            (found.rotation * DVec3::Z - wanted.rotation * DVec3::Z).length() <= TOLERANCE_RAD
        };
        self.count(|flange| self.kinematics.inverse_5dof(flange, 0.0), same)
    }

    fn count(&self, solve: impl Fn(&Flange) -> Solutions, turned: impl Fn(&Flange, Flange) -> bool) -> usize {
        let right = |wanted: &Flange| {
            let back = solve(wanted).into_iter().map(|joints| self.kinematics.forward(&joints));
            back.filter(|found| {
                (found.translation - wanted.translation).length() <= TOLERANCE_M && turned(wanted, *found)
            })
            .count()
        };
        self.flanges.iter().map(right).sum()
    }
}

/// The flange looks along the tool, from the spindle to the tip.
fn flange(pose: &Pose) -> Flange {
    let axis = DVec3::from(pose.axis);
    let tip_m = PART_M + DVec3::from(pose.tip_mm) / 1000.0;
    let rotation = DQuat::from_rotation_arc(DVec3::Z, -axis) * DQuat::from_rotation_z(pose.roll_rad);
    Flange::from_parts(tip_m + axis * (GAUGE_LENGTH_MM / 1000.0), rotation)
}
