//! The machine as bodies: the bed stands still, the sides to the workpiece and to the tool move on from it.

use super::*;

/// Tip and tool axis in the workpiece, for joints in millimetres and degrees.
pub(crate) fn pose(model: &Model, axes: &[mach_runtime::machine::Axis], joints: &[f64]) -> ([f64; 3], [f64; 3]) {
    let joint = |place: usize| Body::of(model, axes, place, joints);
    // From the bed outwards: each body in the frame of the one before, seen with every axis at zero.
    let tool =
        (model.bed..model.chain.len()).fold(Isometry3::identity(), |body, place| body * joint(place).in_bed(1.0));
    let workpiece = (0..model.bed).rev().fold(Isometry3::identity(), |body, place| body * joint(place).in_bed(-1.0));
    let home = Point3::from(model.tool.gauge_mm - model.tool.axis * model.tool.length_mm);
    let tip = workpiece.inverse() * tool * home;
    let axis = workpiece.inverse() * tool * model.tool.axis;
    (tip.coords.into(), axis.into())
}

/// A joint with its value and its errors there.
struct Body {
    motion: Motion,
    direction: Vector3<f64>,
    point_mm: Vector3<f64>,
    /// Millimetres or radians, of the tool's side relative to the workpiece's.
    value: f64,
    shift_mm: Vector3<f64>,
    turn_rad: Vector3<f64>,
    primed: bool,
}

impl Body {
    fn of(model: &Model, axes: &[mach_runtime::machine::Axis], place: usize, joints: &[f64]) -> Self {
        let ModelJoint { axis, primed } = model.chain[place];
        let location = |component: Component| -> f64 {
            let of_this = |error: &&LocationError| error.axis == axis && error.component == component;
            model.errors.locations.iter().filter(of_this).map(|error| error.value).sum()
        };
        let table = |component: Component| {
            let found = model.errors.tables.iter().find(|table| table.axis == axis && table.component == component);
            found.map_or(0.0, |table| table.at(&axes[axis], joints[axis]))
        };
        let [x, y, z, a, b, c] = Component::ALL.map(location);
        let [ex, ey, ez, ea, eb, ec] = Component::ALL.map(table);
        let motion = model.axes[axis].motion;
        let value = if primed { -joints[axis] } else { joints[axis] };
        let shift = if motion == Motion::Rotary { Vector3::new(x, y, z) } else { Vector3::zeros() };
        Self {
            motion,
            direction: Rotation3::from_euler_angles(a, b, c) * model.axes[axis].direction,
            point_mm: model.axes[axis].point_mm + shift,
            value: if motion == Motion::Rotary { value.to_radians() } else { value },
            shift_mm: Vector3::new(ex, ey, ez),
            turn_rad: Vector3::new(ea, eb, ec),
            primed,
        }
    }

    /// The motion of the side away from the bed, as the bed sees it: nominal, then the small one about the point that the
    /// nominal motion has brought the centre to. `side` is 1 towards the tool and -1 towards the workpiece.
    fn in_bed(&self, side: f64) -> Isometry3<f64> {
        let value = side * self.value;
        let nominal = match self.motion {
            Motion::Rotary => about(
                &self.point_mm,
                UnitQuaternion::from_axis_angle(&UnitVector3::new_normalize(self.direction), value),
            ),
            Motion::Linear => Isometry3::from(Translation3::from(self.direction * value)),
        };
        let home = if self.motion == Motion::Rotary { self.point_mm } else { Vector3::zeros() };
        let centre = nominal * Point3::from(home);
        let [a, b, c] = self.turn_rad.into();
        let small =
            Translation3::from(self.shift_mm) * about(&centre.coords, UnitQuaternion::from_euler_angles(a, b, c));
        // The errors are of the side whose motion the axis counts; seen from the bed the other side moves the other way.
        let is_of_this_side = (side > 0.0) != self.primed;
        if is_of_this_side { small * nominal } else { small.inverse() * nominal }
    }
}

fn about(centre: &Vector3<f64>, turn: UnitQuaternion<f64>) -> Isometry3<f64> {
    Translation3::from(*centre) * turn * Translation3::from(-centre)
}
