//! Machine coordinates and the program's: what the control adds to an axis' programmed value, and where a point of the CL is in
//! the machine frame. Who writes, reads back or solves asks here.

use crate::machine::{Axis, Machine, Motion};
use crate::unit::LengthUnit;
use crate::vector::{Vec3, add, sub};

/// What the control adds to the programmed value of an axis: the program zero, and a share of the tool's length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisOffset {
    zero: f64,
    length_share: f64,
}

impl AxisOffset {
    /// An axis' offset.
    pub fn of(axis: &Axis) -> Self {
        Self { zero: axis.zero, length_share: axis.length_share }
    }

    /// The programmed value at a joint value (machine coordinates); both in millimetres or degrees.
    #[inline]
    pub fn programmed(self, joint: f64, tool_length_mm: f64) -> f64 {
        joint - self.zero - self.length_share * tool_length_mm
    }

    /// The joint value (machine coordinates) at a programmed value; both in millimetres or degrees.
    #[inline]
    pub fn joint(self, programmed: f64, tool_length_mm: f64) -> f64 {
        programmed + self.zero + self.length_share * tool_length_mm
    }
}

/// How many millimetres or degrees the unit of an axis' word is, in a program with this unit of length.
pub fn word_unit(motion: Motion, units: LengthUnit) -> f64 {
    match motion {
        Motion::Linear => units.mm(),
        Motion::Rotary => 1.0,
    }
}

/// A tip of the CL, in millimetres from the program zero, as the machine frame has it with every axis at zero.
#[inline]
pub fn in_machine_frame(machine: &Machine, tip_mm: Vec3) -> Vec3 {
    add(tip_mm, machine.zero_mm)
}

/// A tip of the machine frame in millimetres from the program zero, as a CL has it.
#[inline]
pub fn from_program_zero(machine: &Machine, tip_mm: Vec3) -> Vec3 {
    sub(tip_mm, machine.zero_mm)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_program_counts_from_its_zero_and_along_the_tool_from_the_tip() {
        let offset = AxisOffset { zero: -350.0, length_share: 0.5 };
        assert_eq!(offset.programmed(-350.0, 0.0), 0.0);
        assert_eq!(offset.programmed(-290.0, 120.0), 0.0);
        assert_eq!(offset.joint(10.0, 120.0), -280.0);
    }
}
