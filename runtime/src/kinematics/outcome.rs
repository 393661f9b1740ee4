//! What comes of a wanted pose.

/// What the inverse makes of a pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Outcome {
    /// Every candidate takes the tool there.
    Reached,
    /// It stands at a pole: this axis (an index) is free, and the linear axes follow it. What the candidates say of them
    /// means nothing; [`super::Kinematics::position`] knows.
    FreeAtPole {
        /// The free axis.
        axis: usize,
    },
    /// The candidates do not take the tool there.
    Missed(Miss),
}

/// Why the candidates do not take the tool to a pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Miss {
    /// The direction is not one that the machine can reach. The candidates are about the closest that it can do.
    OutOfReach {
        /// The angle to the nearest that it can, in radians (to first order).
        by_rad: f64,
    },
    /// The tip is inside the dead radius of the rotary that the position decides: no angle brings it to the linear axes.
    InsideDeadRadius {
        /// By how much, in millimetres.
        gap_mm: f64,
        /// The dead radius there, in millimetres.
        radius_mm: f64,
    },
    /// The tip is off the plane of the only two linear axes.
    OffPlane {
        /// By how much, in millimetres.
        by_mm: f64,
    },
    /// With one of the candidates, at least, the linear axes do not span space.
    Singular,
    /// The correction of the machine's errors comes to no rest.
    NotCompensated,
}

/// Where a rotary axis (an index) is free: whatever it does, the tool can be held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pole {
    /// Where the tool is along the axis. The distance to there is the sine of the angle between the two.
    Direction {
        /// The axis.
        axis: usize,
    },
    /// Where the tip is on the axis, as the position decides the rotary (X Z C). The distance is in millimetres.
    Position {
        /// The axis.
        axis: usize,
    },
}

impl Pole {
    /// The axis that is free there.
    pub fn axis(self) -> usize {
        match self {
            Self::Direction { axis } | Self::Position { axis } => axis,
        }
    }

    /// At less than this the axis is free. As a sine: a few hundred roundings of a unit vector, so that the axis is exact
    /// to 1e-12 rad whatever the free axis does. In millimetres: what rounding does to a point some hundred metres away.
    pub(super) fn bound(self) -> f64 {
        match self {
            Self::Direction { .. } => 1e-13,
            Self::Position { .. } => 1e-10,
        }
    }
}

/// How far a pose may be from what the machine reaches and still count as reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerances {
    /// Between the tool axis and the wanted one, in radians.
    pub axis_rad: f64,
    /// Between the tip and the plane of two linear axes, in millimetres.
    pub plane_mm: f64,
}
