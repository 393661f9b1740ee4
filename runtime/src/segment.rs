//! Between two points: how far the tip leaves the straight line while every axis moves linearly, as a bound that is proved.
//!
//! Where the tip is along the block is a smooth function of its share of the time. Between two moments it is off the straight
//! line between their places by at most an eighth of a bound on the second derivative and of the square of the time; and no
//! point of that line is farther from the block's own than its ends are. The bound comes from the tool outwards: a linear joint
//! adds to the first derivative, a rotary one turns what is on its tool side about an axis at a known distance.

use crate::machine::{Chain, Motion, ToolGeometry};
use crate::vector::{Vec3, cross, dot, norm, scale, sub};

/// Between the moments that are looked at, the tip may leave its line by this share of what was seen, or by
/// [`LEAST_MM`].
const SHARE: f64 = 0.01;
/// See [`SHARE`].
const LEAST_MM: f64 = 1e-6;

/// At most so many moments of a block are looked at.
const MOST_MOMENTS: f64 = 512.0;

/// The blocks of a program, one after the other.
#[derive(Debug)]
pub struct Segments<'m> {
    chain: &'m Chain,
    tool: ToolGeometry,
    from: Station,
    to: Station,
}

/// An end of a block.
#[derive(Debug, Clone)]
struct Station {
    /// Millimetres and degrees, in the machine's order.
    joints: Vec<f64>,
    /// For each joint of the chain, the tip's distance from its axis in millimetres; zero for a linear one.
    radii_mm: Vec<f64>,
}

/// Bounds on the first two derivatives of the tip along the block, in millimetres.
#[derive(Debug, Clone, Copy, Default)]
struct Bounds {
    first: f64,
    second: f64,
}

impl<'m> Segments<'m> {
    /// At the start of a program: every axis at zero.
    pub fn new(chain: &'m Chain, tool: ToolGeometry) -> Self {
        let joints = chain.joints.len();
        let home = Station { joints: vec![0.0; joints], radii_mm: vec![0.0; joints] };
        Self { chain, tool, from: home.clone(), to: home }
    }

    /// The next block begins where the last one ended, and ends here: machine coordinates in millimetres and degrees.
    pub fn go_to(&mut self, joints: &[f64]) {
        std::mem::swap(&mut self.from, &mut self.to);
        self.to.set(joints, self.chain, self.tool);
    }

    /// A quick bound on [`Self::deviation_mm`].
    pub fn quick_bound_mm(&self) -> f64 {
        self.bounds().second / 8.0
    }

    /// The tip is nowhere in the block farther than this from the straight line between its ends, in millimetres.
    pub fn deviation_mm(&self) -> f64 {
        let line = self.line();
        let quick_mm = self.quick_bound_mm();
        let between_mm = (SHARE * self.off_the_line(0.5, &line)).max(LEAST_MM);
        let moments = (quick_mm / between_mm).sqrt().ceil().clamp(1.0, MOST_MOMENTS);
        let seen = (1..moments as u32).map(|n| self.off_the_line(f64::from(n) / moments, &line));
        (seen.fold(0.0, f64::max) + quick_mm / (moments * moments)).min(quick_mm)
    }

    fn line(&self) -> [Vec3; 2] {
        [&self.from, &self.to].map(|end| self.tip(&end.joints))
    }

    /// The tip's distance from a line with ends, after this share of the time.
    fn off_the_line(&self, share: f64, [start, end]: &[Vec3; 2]) -> f64 {
        let ends = self.from.joints.iter().zip(&self.to.joints);
        let joints: Vec<f64> = ends.map(|(from, to)| from + share * (to - from)).collect();
        let (line, off) = (sub(*end, *start), sub(self.tip(&joints), *start));
        let along = dot(off, line) / dot(line, line).max(f64::MIN_POSITIVE);
        norm(sub(off, scale(along.clamp(0.0, 1.0), line)))
    }

    fn tip(&self, joints: &[f64]) -> Vec3 {
        self.chain.pose(joints, self.tool).0
    }

    fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::default();
        for (index, joint) in self.chain.joints.iter().enumerate().rev() {
            let step = (self.to.joints[joint.axis] - self.from.joints[joint.axis]).abs();
            let radius_mm = self.from.radii_mm[index].max(self.to.radii_mm[index]);
            bounds = match joint.motion {
                Motion::Linear => Bounds { first: bounds.first + step, ..bounds },
                Motion::Rotary => bounds.turned(step.to_radians(), radius_mm),
            };
        }
        bounds
    }
}

impl Bounds {
    /// Turned by so much in the block, about an axis that is so far from the tip at the farther end.
    fn turned(self, w: f64, radius_mm: f64) -> Self {
        let Self { first, second } = self;
        // Between the ends the distance exceeds theirs by no more than the second derivative allows.
        let radius_mm = radius_mm + second / 8.0;
        Self { first: first + w * radius_mm, second: second + w * (2.0 * first + w * radius_mm) }
    }
}

impl Station {
    /// The distances from the tool outwards; the outermost rotary need not be turned for its own.
    fn set(&mut self, joints: &[f64], chain: &Chain, tool: ToolGeometry) {
        self.joints.copy_from_slice(joints);
        let mut pose = (chain.tip_at_home(tool), chain.tool_axis);
        let outermost = chain.joints.iter().position(|joint| joint.motion == Motion::Rotary);
        for (index, joint) in chain.joints.iter().enumerate().rev() {
            if joint.motion == Motion::Rotary {
                self.radii_mm[index] = norm(cross(joint.direction, sub(pose.0, joint.point_mm)));
            }
            if Some(index) == outermost {
                return;
            }
            pose = joint.moved(joint.signed(joints[joint.axis]), pose);
        }
    }
}
