//! Between two points: how far the tip leaves the straight line while every axis moves linearly, as a bound that is proved.
//!
//! Where the tip is along the block is a smooth function of its share of the time. Bounds on its derivatives come from the tool
//! outwards: a linear joint adds to the first one, a rotary one turns what is on its tool side about an axis at a known distance.
//! From them follow three bounds, each closer than the one before and taking longer:
//!
//! - an eighth of the second derivative;
//! - where the tip is half-way, and √3/216 of the third derivative: so far may a function be off the parabola through its ends
//!   and its middle;
//! - where it is at many moments: between two of them it is off the line through their places by an eighth of the second
//!   derivative and of the square of the time, and no point of that line is farther off than its ends.

use crate::kinematics::{JointBlock, LANES, Lane};
use crate::machine::{Chain, Joint, Motion};
use crate::tool::ToolGeometry;
use crate::vector::{Vec3, add, dot, norm, scale, sub};

/// The greatest of |t (t - 1/2) (t - 1)| / 6 between 0 and 1, √3/216: what the third derivative adds to the parabola.
const THIRD: f64 = 0.008_018_753_738_744_804;

/// A bound may be above what was seen by this share of it, or by [`LEAST_MM`]; else it is looked at more moments.
const SHARE: f64 = 0.01;
/// See [`SHARE`].
const LEAST_MM: f64 = 1e-6;

/// At most so many moments of a block are looked at.
const MOST_MOMENTS: f64 = 512.0;

/// The ends of up to [`LANES`] blocks that follow one another: the first is where the first of them begins.
type Ends = [f64; LANES + 1];

/// The blocks of a program, so many at once as there are lanes.
#[derive(Debug)]
pub struct Segments<'m> {
    chain: &'m Chain,
    tool: ToolGeometry,
    /// The place of the rotary joint that is nearest to the workpiece.
    outermost: Option<usize>,
    /// Millimetres and degrees, in the machine's order.
    joints: Vec<Ends>,
    /// The tip in millimetres: x, y, z.
    tips_mm: [Ends; 3],
    /// For each joint of the chain, the tip's distance from its axis in millimetres; zero for a linear one.
    radii_mm: Vec<Ends>,
    /// Bounds on the first three derivatives of the tip in each block, in millimetres.
    derivatives_mm: [Lane; 3],
    count: usize,
}

impl<'m> Segments<'m> {
    /// At the start of a program: every axis at zero.
    pub fn new(chain: &'m Chain, tool: ToolGeometry) -> Self {
        let none = vec![[0.0; LANES + 1]; chain.joints.len()];
        let outermost = chain.joints.iter().position(|joint| joint.motion == Motion::Rotary);
        let (tips_mm, derivatives_mm) = ([[0.0; LANES + 1]; 3], [[0.0; LANES]; 3]);
        Self { chain, tool, outermost, joints: none.clone(), tips_mm, radii_mm: none, derivatives_mm, count: 0 }
    }

    /// The next blocks: they begin where the last one ended, and end at these joints, one block after the other (machine
    /// coordinates in millimetres and degrees, in the machine's order), which take the tip here (in millimetres).
    ///
    /// # Panics
    /// When there are more blocks than lanes.
    pub fn go_to(&mut self, joints: &[f64], tips_mm: &[Lane; 3]) {
        let axes = self.joints.len();
        for column in self.joints.iter_mut().chain(&mut self.radii_mm).chain(&mut self.tips_mm) {
            column[0] = column[self.count];
        }
        self.count = joints.len() / axes;
        assert!(self.count <= LANES, "so many blocks fit the lanes");
        for (lane, joints) in joints.chunks(axes).enumerate() {
            for (column, joint) in self.joints.iter_mut().zip(joints) {
                column[lane + 1] = *joint;
            }
        }
        for (column, tips_mm) in self.tips_mm.iter_mut().zip(tips_mm) {
            column[1..].copy_from_slice(tips_mm);
        }
        self.measure(tips_mm);
        self.differentiate();
    }

    /// A quick bound on [`Self::deviation_mm`] of a block.
    pub fn quick_bound_mm(&self, lane: usize) -> f64 {
        self.derivatives_mm[1][lane] / 8.0
    }

    /// The joints half-way of each block.
    pub fn half_way(&self, joints: &mut JointBlock) {
        for (half_way, ends) in joints.iter_mut().zip(&self.joints) {
            *half_way = std::array::from_fn(|lane| 0.5 * (ends[lane] + ends[lane + 1]));
        }
    }

    /// The tip is nowhere in the block of this lane farther than this from the straight line between its ends, in millimetres;
    /// half-way it is at `half_way_mm`.
    pub fn deviation_mm(&self, lane: usize, half_way_mm: Vec3) -> f64 {
        let [start, end]: [Vec3; 2] = [lane, lane + 1].map(|end| self.tips_mm.map(|tips| tips[end]));
        let third = self.derivatives_mm[2][lane];
        let line = sub(end, start);
        let off = sub(half_way_mm, scale(0.5, add(start, end)));
        let length = norm(line);
        let along = dot(off, line).abs() / length.max(f64::MIN_POSITIVE);
        let across = (dot(off, off) - along * along).max(0.0).sqrt();
        // Along the line the tip is late or early by at most t (1 - t) of this; beyond an end only where it exceeds the length.
        let early = 4.0 * along + third / 12.0;
        let beyond = if early > length { (early - length) * (early - length) / (4.0 * early) } else { 0.0 };
        let beside = across + THIRD * third;
        let bound_mm = libm::hypot(beside, beyond).min(self.quick_bound_mm(lane));
        if bound_mm <= (1.0 + SHARE) * across + LEAST_MM { bound_mm } else { self.many_moments_mm(lane).min(bound_mm) }
    }

    /// The same by looking at as many moments as bring the bound close to what is seen.
    fn many_moments_mm(&self, lane: usize) -> f64 {
        let line = [0.0, 1.0].map(|share| self.tip(lane, share));
        let quick_mm = self.quick_bound_mm(lane);
        let between_mm = (SHARE * self.off_the_line(lane, 0.5, &line)).max(LEAST_MM);
        let moments = (quick_mm / between_mm).sqrt().ceil().clamp(1.0, MOST_MOMENTS);
        let seen = (1..moments as u32).map(|n| self.off_the_line(lane, f64::from(n) / moments, &line));
        seen.fold(0.0, f64::max) + quick_mm / (moments * moments)
    }

    /// The tip's distance from a line with ends, after this share of the time.
    fn off_the_line(&self, lane: usize, share: f64, [start, end]: &[Vec3; 2]) -> f64 {
        let (line, off) = (sub(*end, *start), sub(self.tip(lane, share), *start));
        let along = dot(off, line) / dot(line, line).max(f64::MIN_POSITIVE);
        norm(sub(off, scale(along.clamp(0.0, 1.0), line)))
    }

    fn tip(&self, lane: usize, share: f64) -> Vec3 {
        let at = |ends: &Ends| ends[lane] + share * (ends[lane + 1] - ends[lane]);
        let joints: Vec<f64> = self.joints.iter().map(at).collect();
        self.chain.pose(&joints, self.tool).0
    }

    fn differentiate(&mut self) {
        self.derivatives_mm = [[0.0; LANES]; 3];
        for (joint, radii_mm) in self.chain.joints.iter().zip(&self.radii_mm).rev() {
            let (ends, first) = (&self.joints[joint.axis], &mut self.derivatives_mm[0]);
            match joint.motion {
                Motion::Linear => (0..LANES).for_each(|lane| first[lane] += (ends[lane + 1] - ends[lane]).abs()),
                Motion::Rotary => turn(&mut self.derivatives_mm, ends, radii_mm),
            }
        }
    }

    /// The tip's distances from the rotary axes, from the tool outwards. The outermost one's is seen from the workpiece, as
    /// turning about it does not change it: with two rotaries no angle needs a sine.
    fn measure(&mut self, tips_mm: &[Lane; 3]) {
        let mut tips = self.chain.tip_at_home(self.tool).map(|home| [home; LANES]);
        for (place, joint) in self.chain.joints.iter().enumerate().rev() {
            let values = &self.joints[joint.axis];
            if joint.motion == Motion::Linear {
                shift(&mut tips, joint, 1.0, values);
                continue;
            }
            if self.outermost == Some(place) {
                tips = *tips_mm;
                let outside = &self.chain.joints[..place];
                outside.iter().for_each(|joint| shift(&mut tips, joint, -1.0, &self.joints[joint.axis]));
            }
            distances(&tips, joint, &mut self.radii_mm[place]);
            let rotaries_left =
                self.chain.joints[..place].iter().filter(|joint| joint.motion == Motion::Rotary).count();
            match rotaries_left {
                0 => return,
                1 => {} // its distances need no angle of this one
                _ => turn_tips(&mut tips, joint, values),
            }
        }
    }
}

/// Bounds on the derivatives, turned by what an axis does in each block, about that axis. Between the ends the tip is no farther
/// from it than at the farther one and what the second derivative allows.
fn turn([first, second, third]: &mut [Lane; 3], ends: &Ends, radii_mm: &Ends) {
    for lane in 0..LANES {
        let w = (ends[lane + 1] - ends[lane]).abs().to_radians();
        let turned_mm = w * (radii_mm[lane].max(radii_mm[lane + 1]) + second[lane] / 8.0);
        third[lane] += w * (3.0 * second[lane] + w * (3.0 * first[lane] + turned_mm));
        second[lane] += w * (2.0 * first[lane] + turned_mm);
        first[lane] += turned_mm;
    }
}

/// The tips moved by a linear joint, or back by it.
fn shift(tips: &mut [Lane; 3], joint: &Joint, sense: f64, values: &Ends) {
    let along = scale(joint.signed(sense), joint.direction);
    for (tip, along) in tips.iter_mut().zip(along) {
        (0..LANES).for_each(|lane| tip[lane] += along * values[lane + 1]);
    }
}

/// How far the tips are from a rotary joint's axis, behind the end that is known already.
fn distances(tips: &[Lane; 3], Joint { direction: n, point_mm, .. }: &Joint, radii_mm: &mut Ends) {
    for lane in 0..LANES {
        let [x, y, z]: Vec3 = std::array::from_fn(|i| tips[i][lane] - point_mm[i]);
        let across = [n[1] * z - n[2] * y, n[2] * x - n[0] * z, n[0] * y - n[1] * x];
        radii_mm[lane + 1] = norm(across);
    }
}

/// The tips turned by a rotary joint.
fn turn_tips(tips: &mut [Lane; 3], joint: &Joint, values: &Ends) {
    for lane in 0..LANES {
        let tip = std::array::from_fn(|i| tips[i][lane]);
        let (turned, _) = joint.moved(joint.signed(values[lane + 1]), (tip, joint.direction));
        (0..3).for_each(|i| tips[i][lane] = turned[i]);
    }
}
