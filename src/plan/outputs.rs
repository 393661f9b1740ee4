//! What an inverse gives, and in which order: whoever lists or reads its outputs does so by this.

use super::{Id, Plan};

/// One output of an inverse.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InverseOutput {
    /// The joint of an axis in a branch, in millimetres or radians.
    Joint {
        /// Which branch.
        branch: usize,
        /// The axis, as an index into the model's.
        axis: usize,
    },
    /// Zero inside the reach, else minus the angle to it, in radians.
    Reach,
    /// How far it is to the pole: a sine or millimetres.
    PoleDistance,
    /// Zero where the linear axes reach the tip, else how far it is from there, in millimetres.
    Gap,
}

impl Plan {
    /// The outputs of the inverse with their nodes: the joints branch by branch, then the margins.
    pub fn inverse_outputs(&self) -> Vec<(InverseOutput, Id)> {
        let joints = |(branch, solution): (usize, &super::Branch)| -> Vec<(InverseOutput, Id)> {
            let joints = solution.joints.iter().enumerate();
            joints.map(|(axis, &id)| (InverseOutput::Joint { branch, axis }, id)).collect()
        };
        let margins = [
            (InverseOutput::Reach, self.reach),
            (InverseOutput::PoleDistance, self.pole_distance),
            (InverseOutput::Gap, self.gap),
        ];
        self.branches.iter().enumerate().flat_map(joints).chain(margins).collect()
    }
}
