//! The machine's kinematics as the runtime sees it: blocks of poses in, blocks of candidates out, and back.

mod outcome;
mod rates;
mod solution;

pub use outcome::{Miss, Outcome, Pole, Tolerances};
pub use rates::{Rate, rates};
pub use solution::{Margins, SolutionBlock, held};

use crate::tool::ToolGeometry;
use crate::vector::Vec3;

/// How many poses are solved at once.
pub const LANES: usize = 64;

/// One scalar of a block.
pub type Lane = [f64; LANES];

/// Poses of the tool in the workpiece: tip in millimetres and unit tool axis (from the tip to the spindle), both in the
/// machine frame with every axis at zero.
#[derive(Debug, Clone)]
pub struct PoseBlock {
    /// Tip x, y, z in millimetres.
    pub tip_mm: [Lane; 3],
    /// Unit tool axis i, j, k.
    pub axis: [Lane; 3],
}

impl PoseBlock {
    /// All lanes zero: a block to be filled.
    pub const ZERO: Self = Self { tip_mm: [[0.0; LANES]; 3], axis: [[0.0; LANES]; 3] };

    /// Puts a pose into one lane.
    pub fn set(&mut self, lane: usize, tip_mm: Vec3, axis: Vec3) {
        for i in 0..3 {
            self.tip_mm[i][lane] = tip_mm[i];
            self.axis[i][lane] = axis[i];
        }
    }

    /// The tip of one lane.
    pub fn tip(&self, lane: usize) -> Vec3 {
        std::array::from_fn(|i| self.tip_mm[i][lane])
    }

    /// The tool axis of one lane.
    pub fn axis(&self, lane: usize) -> Vec3 {
        std::array::from_fn(|i| self.axis[i][lane])
    }
}

/// Joint values: `joints[a][l]` is axis `a` of lane `l`, in millimetres or degrees, machine coordinates.
pub type JointBlock = Vec<Lane>;

/// The joints of a block whose number of axes is known.
///
/// # Panics
/// When the block is of another number of axes.
#[inline]
pub fn joint_lanes<const AXES: usize>(joints: &JointBlock) -> &[Lane; AXES] {
    joints.as_slice().try_into().expect("a block has a lane for each axis")
}

/// The same for each candidate.
///
/// # Panics
/// When the blocks are of another number of candidates or axes.
#[inline]
pub fn candidate_lanes<const AXES: usize, const COUNT: usize>(
    branches: &mut [JointBlock],
) -> [&mut [Lane; AXES]; COUNT] {
    let branches: &mut [JointBlock; COUNT] = branches.try_into().expect("there is a block for each candidate");
    branches.each_mut().map(|joints| joints.as_mut_slice().try_into().expect("a block has a lane for each axis"))
}

/// A machine's forward chain and its inverse.
pub trait Kinematics {
    /// How many axes there are, in the order of [`crate::machine::Machine::axes`].
    fn axis_count(&self) -> usize;

    /// How many candidates an inverse gives: 2 with two rotaries, else 1.
    fn branch_count(&self) -> usize;

    /// Where an axis is free, if one ever is.
    fn pole(&self) -> Option<Pole>;

    /// The axes that the pose leaves open, as indices: an inverse is given their values.
    fn surplus_axes(&self) -> &[usize] {
        &[]
    }

    /// Every candidate for each pose of the block. `surplus[s]` holds the values of axis `surplus_axes()[s]`, in
    /// millimetres or degrees; the candidates repeat them.
    fn inverse(&mut self, poses: &PoseBlock, surplus: &[Lane], tool: ToolGeometry, out: &mut SolutionBlock);

    /// The linear joints that put the tip on `tip_mm`, for the rotary joints and the surplus ones that are already in
    /// `joints`; one pose.
    ///
    /// # Errors
    ///
    /// Why none do.
    fn position(&mut self, tip_mm: Vec3, tool: ToolGeometry, joints: &mut [f64]) -> Result<(), Miss>;

    /// The pose of each lane's joints.
    fn forward(&mut self, joints: &JointBlock, tool: ToolGeometry, out: &mut PoseBlock);

    /// The pose of each lane's joints with these errors of the axes: one lane for each of
    /// [`crate::machine::Machine::errors`], in millimetres or radians. Only a machine with such tables needs it.
    fn forward_actual(&mut self, joints: &JointBlock, deviations: &[Lane], tool: ToolGeometry, out: &mut PoseBlock) {
        assert!(deviations.is_empty(), "a machine with error tables has a forward chain for them");
        self.forward(joints, tool, out);
    }
}

impl<K: Kinematics + ?Sized> Kinematics for &mut K {
    fn axis_count(&self) -> usize {
        (**self).axis_count()
    }

    fn branch_count(&self) -> usize {
        (**self).branch_count()
    }

    fn pole(&self) -> Option<Pole> {
        (**self).pole()
    }

    fn surplus_axes(&self) -> &[usize] {
        (**self).surplus_axes()
    }

    fn inverse(&mut self, poses: &PoseBlock, surplus: &[Lane], tool: ToolGeometry, out: &mut SolutionBlock) {
        (**self).inverse(poses, surplus, tool, out);
    }

    fn position(&mut self, tip_mm: Vec3, tool: ToolGeometry, joints: &mut [f64]) -> Result<(), Miss> {
        (**self).position(tip_mm, tool, joints)
    }

    fn forward(&mut self, joints: &JointBlock, tool: ToolGeometry, out: &mut PoseBlock) {
        (**self).forward(joints, tool, out);
    }

    fn forward_actual(&mut self, joints: &JointBlock, deviations: &[Lane], tool: ToolGeometry, out: &mut PoseBlock) {
        (**self).forward_actual(joints, deviations, tool, out);
    }
}
