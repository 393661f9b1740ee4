//! The forward chain with everything scaled as the residual is: linear joints in units of [`LENGTH_MM`], rotary ones in
//! radians.

use super::residual::{LENGTH_MM, unit};
use crate::plan::{Jacobian, Plan, Pose};
use mach_runtime::tool::ToolGeometry;

/// Poses and derivatives of scaled joints.
#[derive(Debug, Clone)]
pub(super) struct Forward {
    chain: Jacobian,
    /// The unit of each joint.
    units: Vec<f64>,
    joints: Vec<f64>,
    /// The tool.
    pub(super) tool: ToolGeometry,
}

impl Forward {
    pub(super) fn new(plan: &Plan) -> Self {
        let units: Vec<f64> = plan.rotary.iter().map(|&rotary| if rotary { 1.0 } else { LENGTH_MM }).collect();
        Self { chain: Jacobian::new(plan), joints: vec![0.0; units.len()], units, tool: ToolGeometry::of_length(0.0) }
    }

    /// The pose, in millimetres.
    pub(super) fn pose(&mut self, scaled: &[f64]) -> Pose {
        self.take(scaled);
        self.chain.pose(&self.joints, self.tool)
    }

    /// The pose, in millimetres, and its scaled derivatives by the scaled joints.
    pub(super) fn derivatives(&mut self, scaled: &[f64], columns: &mut [Pose]) -> Pose {
        self.take(scaled);
        let pose = self.chain.derivatives(&self.joints, self.tool, columns);
        for (column, joint_unit) in columns.iter_mut().zip(&self.units) {
            for (i, entry) in column.iter_mut().enumerate() {
                *entry *= joint_unit / unit(i);
            }
        }
        pose
    }

    fn take(&mut self, scaled: &[f64]) {
        for ((joint, value), unit) in self.joints.iter_mut().zip(scaled).zip(&self.units) {
            *joint = value * unit;
        }
    }
}
