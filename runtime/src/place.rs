//! Placing: where the frames of the CL lie.
//!
//! The first MSYS of a file is the program zero, and its points are taken as they are. A point under a later MSYS is
//! carried over into the first.

use crate::vector::{Vec3, add, cross, dot, norm, scale, sub};

/// The sine of the smallest angle between two axes that still span a plane.
const LEAST_SINE: f64 = 1e-6;

/// A right-handed frame with orthonormal axes; the origin in millimetres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    origin_mm: Vec3,
    x: Vec3,
    y: Vec3,
    z: Vec3,
}

impl Frame {
    /// The frame that others are given in.
    pub const BASE: Self = Self { origin_mm: [0.0; 3], x: [1.0, 0.0, 0.0], y: [0.0, 1.0, 0.0], z: [0.0, 0.0, 1.0] };

    /// From an origin and two directions that need not be exact: the first is kept, the second is made square to it,
    /// the third is their product. `None` when they do not span a plane.
    pub fn new(origin_mm: Vec3, x: Vec3, y: Vec3) -> Option<Self> {
        let x = unit(x)?;
        let y = unit(y)?;
        let square = sub(y, scale(dot(x, y), x));
        if norm(square) < LEAST_SINE {
            return None;
        }
        let y = unit(square)?;
        Some(Self { origin_mm, x, y, z: cross(x, y) })
    }

    /// Its origin, in millimetres.
    pub fn origin_mm(&self) -> Vec3 {
        self.origin_mm
    }

    /// The direction of its X.
    pub fn x(&self) -> Vec3 {
        self.x
    }

    /// The direction of its Y.
    pub fn y(&self) -> Vec3 {
        self.y
    }

    /// A direction of this frame in the frame that this one is given in.
    #[inline]
    pub fn direction(&self, v: Vec3) -> Vec3 {
        add(add(scale(v[0], self.x), scale(v[1], self.y)), scale(v[2], self.z))
    }

    /// A point of this frame, in millimetres, in the frame that this one is given in.
    #[inline]
    pub fn point(&self, p_mm: Vec3) -> Vec3 {
        add(self.origin_mm, self.direction(p_mm))
    }

    /// This frame as `base` sees it; both are given in the same frame.
    pub fn relative_to(&self, base: &Self) -> Self {
        let into = |v: Vec3| [dot(base.x, v), dot(base.y, v), dot(base.z, v)];
        Self { origin_mm: into(sub(self.origin_mm, base.origin_mm)), x: into(self.x), y: into(self.y), z: into(self.z) }
    }
}

/// The direction with length 1; `None` when it has no length.
fn unit(v: Vec3) -> Option<Vec3> {
    let length = norm(v);
    (length.is_finite() && length > 0.0).then(|| scale(1.0 / length, v))
}

/// Carries points and directions of the frame in force over into the first one.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Placement {
    first: Option<Frame>,
    /// `None` when points are taken as they are.
    current: Option<Frame>,
}

impl Placement {
    /// Puts a frame in force. The first one becomes the program zero.
    pub fn set(&mut self, frame: Frame) {
        let first = *self.first.get_or_insert(frame);
        self.current = (frame != first).then(|| frame.relative_to(&first));
    }

    /// The frame in force, in the first one.
    pub fn current(&self) -> Frame {
        self.current.unwrap_or(Frame::BASE)
    }

    /// A point in millimetres.
    #[inline]
    pub fn point(&self, p_mm: Vec3) -> Vec3 {
        self.current.map_or(p_mm, |frame| frame.point(p_mm))
    }

    /// A direction.
    #[inline]
    pub fn direction(&self, v: Vec3) -> Vec3 {
        self.current.map_or(v, |frame| frame.direction(v))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_later_frame_is_carried_over_into_the_first() {
        let mut placement = Placement::default();
        placement.set(Frame::new([100.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]).unwrap());
        assert_eq!(placement.point([1.0, 2.0, 3.0]), [1.0, 2.0, 3.0]);
        placement.set(Frame::new([100.0, 50.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]).unwrap());
        assert_eq!(placement.point([1.0, 2.0, 3.0]), [-2.0, 51.0, 3.0]);
        assert_eq!(placement.direction([1.0, 0.0, 0.0]), [0.0, 1.0, 0.0]);
        placement.set(Frame::new([100.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]).unwrap());
        assert_eq!(placement.point([1.0, 2.0, 3.0]), [1.0, 2.0, 3.0]);
    }

    #[test]
    fn axes_are_made_square() {
        let frame = Frame::new([0.0; 3], [2.0, 0.0, 0.0], [0.1, 3.0, 0.0]).unwrap();
        assert_eq!(frame.direction([0.0, 1.0, 0.0]), [0.0, 1.0, 0.0]);
        assert_eq!(frame.direction([0.0, 0.0, 1.0]), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn axes_that_span_no_plane_are_refused() {
        assert_eq!(Frame::new([0.0; 3], [1.0, 0.0, 0.0], [-2.0, 0.0, 0.0]), None);
        assert_eq!(Frame::new([0.0; 3], [0.0; 3], [0.0, 1.0, 0.0]), None);
        assert_eq!(Frame::new([0.0; 3], [f64::NAN, 0.0, 0.0], [0.0, 1.0, 0.0]), None);
    }
}
