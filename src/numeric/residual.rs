//! What is left between the pose of some joints and the wanted one.
//!
//! Scaled so that one bound holds for all six components: the tip in units of [`LENGTH_MM`], the axis as the difference of
//! two unit vectors. The length of that is the chord, twice the sine of half the angle: the angle itself where it is small,
//! and zero for equal axes only (the vector product is zero for opposite ones as well).

use crate::plan::Pose;
use crate::prove::{AXIS_BOUND_RAD, TIP_BOUND_MM};
use mach_runtime::tool::ToolGeometry;
use mach_runtime::vector::{Vec3, angle_rad, norm, sub};

/// A length that weighs as much as a radian: the ratio of the proof's two bounds, one metre.
pub(super) const LENGTH_MM: f64 = TIP_BOUND_MM / AXIS_BOUND_RAD;

/// What a scaled residual or step has to be within: a tenth of the proof's bound. The rest is for turning joints into
/// degrees, and for what iterates around this inverse.
pub(super) const BOUND: f64 = AXIS_BOUND_RAD / 10.0;

/// Where the tool is to be: tip in millimetres, unit axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Target {
    pub(super) tip_mm: Vec3,
    pub(super) axis: Vec3,
    /// The tool.
    pub(super) tool: ToolGeometry,
}

impl Target {
    /// A pose as a target, for the same tool.
    pub(super) fn with(&self, pose: &Pose) -> Self {
        let [tip_mm, axis] = halves(pose);
        Self { tip_mm, axis, ..*self }
    }

    /// The residual of a pose, scaled.
    pub(super) fn residual(&self, pose: &Pose) -> Pose {
        let wanted = [self.tip_mm, self.axis];
        std::array::from_fn(|i| (pose[i] - wanted[i / 3][i % 3]) / unit(i))
    }

    /// How far a pose is from it: of the tips in millimetres, of the axes in radians.
    pub(super) fn distance(&self, pose: &Pose) -> (f64, f64) {
        let [tip, axis] = halves(pose);
        (norm(sub(tip, self.tip_mm)), angle_rad(axis, self.axis))
    }

    /// Whether a pose is within the bounds.
    pub(super) fn is_met_by(&self, pose: &Pose) -> bool {
        let (tip_mm, axis_rad) = self.distance(pose);
        tip_mm <= BOUND * LENGTH_MM && axis_rad <= BOUND
    }

    /// The pose half-way from another one; none between opposite axes.
    pub(super) fn half_way_from(&self, other: &Self) -> Option<Self> {
        let tip_mm = std::array::from_fn(|i| (self.tip_mm[i] + other.tip_mm[i]) / 2.0);
        let sum: Vec3 = std::array::from_fn(|i| self.axis[i] + other.axis[i]);
        let length = norm(sum);
        (length > BOUND).then(|| Self { tip_mm, axis: sum.map(|component| component / length), ..*self })
    }
}

/// The unit of a component of a pose.
pub(super) fn unit(component: usize) -> f64 {
    if component < 3 { LENGTH_MM } else { 1.0 }
}

/// Tip and axis.
fn halves(pose: &Pose) -> [Vec3; 2] {
    [0, 3].map(|first| std::array::from_fn(|i| pose[first + i]))
}
