//! A checked machine. Nothing in it can be wrong any more: directions are unit vectors, every axis stands in the chain
//! once, the axes that the pose decides can be solved for, and the dialect prints every axis.

use super::errors::Errors;
use mach_runtime::machine::{BranchPolicy, Motion, Rule, Travel, Written};
use mach_runtime::nc::dialect::Dialect;
use mach_runtime::strictness::Strictness;
use mach_runtime::tool::ToolGeometry;
use nalgebra::Vector3;

/// A checked machine. Points and directions are in the machine frame with every axis at zero; lengths in millimetres.
#[derive(Debug, Clone)]
pub struct Model {
    /// The name in the file.
    pub name: String,
    /// What people call it.
    pub title: Option<String>,
    /// The parameters of the file with their values, as a person would write them (`-20 mm`).
    pub parameters: Vec<(String, String)>,
    /// In the order of declaration, which is the order in which their words are written.
    pub axes: Vec<ModelAxis>,
    /// From the workpiece to the tool.
    pub chain: Vec<ModelJoint>,
    /// How many joints of the chain carry the workpiece: those before the bed.
    pub bed: usize,
    /// The tool.
    pub tool: Tool,
    /// What was measured of the machine: `axes` are as they should be.
    pub errors: Errors,
    /// The program zero.
    pub zero_mm: Vector3<f64>,
    /// How far the tool axis may be from the wanted one, in radians.
    pub axis_tolerance_rad: f64,
    /// How far the tip may be off the plane of two linear axes, in millimetres.
    pub plane_tolerance_mm: f64,
    /// How far a segment may leave an arc, in millimetres.
    pub chord_tolerance_mm: f64,
    /// What an unknown CL record does.
    pub unknown_records: Strictness,
    /// How a candidate is chosen; indices are into `axes`.
    pub branch: BranchPolicy,
    /// The controller's dialect, where the machine names one; its axis words are in the order of `axes`.
    pub dialect: Option<Dialect>,
}

/// A declared axis.
#[derive(Debug, Clone)]
pub struct ModelAxis {
    /// Its name.
    pub name: String,
    /// How it moves.
    pub motion: Motion,
    /// Its unit direction.
    pub direction: Vector3<f64>,
    /// A point on a rotary axis; the origin for a linear one.
    pub point_mm: Vector3<f64>,
    /// How far it can go: millimetres or degrees.
    pub travel: Travel,
    /// What decides where it stands.
    pub rule: Rule,
    /// Rapid traverse in mm/min or deg/min.
    pub rapid_per_min: Option<f64>,
    /// How a rotary value is written.
    pub written: Written,
}

impl ModelAxis {
    /// Whether the pose decides where it stands.
    pub fn is_solved(&self) -> bool {
        self.rule == Rule::Pose
    }
}

/// One joint of the chain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModelJoint {
    /// Index into [`Model::axes`].
    pub axis: usize,
    /// Whether its positive sense is the workpiece's motion.
    pub primed: bool,
}

/// The tool at home.
#[derive(Debug, Clone)]
pub struct Tool {
    /// From the tip to the spindle; a unit vector.
    pub axis: Vector3<f64>,
    /// The gauge point.
    pub gauge_mm: Vector3<f64>,
    /// From the gauge point to the tip, against `axis`.
    pub length_mm: f64,
}

impl Tool {
    /// As the kinematics sees it.
    pub fn geometry(&self) -> ToolGeometry {
        ToolGeometry::of_length(self.length_mm)
    }
}
