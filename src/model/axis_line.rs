//! Where the axes of a machine really lie.

use super::error_name::ErrorName;
use super::machine::{Model, ModelAxis};
use mach_runtime::machine::Component;
use nalgebra::{Rotation3, Unit, Vector3};

/// The line of an axis with every axis at zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisLine {
    /// Its unit direction.
    pub direction: Vector3<f64>,
    /// A point on it; the origin for a linear axis.
    pub point_mm: Vector3<f64>,
}

impl Model {
    /// The name of an error of an axis (an index) in ISO 230: `EX0C` for a location error, else `EXC`.
    pub fn error_name(&self, component: Component, axis: usize, is_location: bool) -> String {
        ErrorName { component, is_location, axis: &self.axes[axis].name }.canonical()
    }

    /// Where an axis (an index) really lies: its line as it is declared, turned about x, then y, then z of the frame by its
    /// location errors A, B and C, and shifted by X, Y and Z.
    pub fn line(&self, axis: usize) -> AxisLine {
        let ModelAxis { direction, point_mm, .. } = &self.axes[axis];
        let errors = || self.errors.locations.iter().filter(|error| error.axis == axis);
        let sum = |component| errors().filter(|error| error.component == component).map(|error| error.value).sum();
        let [x, y, z, a, b, c]: [f64; 6] = Component::ALL.map(sum);
        let turned = [a, b, c].into_iter().enumerate().fold(*direction, |v, (about, angle)| turn(about, angle) * v);
        AxisLine { direction: turned, point_mm: point_mm + Vector3::new(x, y, z) }
    }
}

/// A turn about x, y or z; none at all where the angle is zero, so that what is exact stays so.
fn turn(about: usize, angle_rad: f64) -> Rotation3<f64> {
    if angle_rad == 0.0 {
        return Rotation3::identity();
    }
    let (sine, cosine) = libm::sincos(angle_rad);
    let axis = Unit::new_unchecked(Vector3::ith(about, 1.0));
    let (cross, along) = (axis.cross_matrix(), axis.into_inner() * axis.transpose());
    Rotation3::from_matrix_unchecked(along + (nalgebra::Matrix3::identity() - along) * cosine + cross * sine)
}
