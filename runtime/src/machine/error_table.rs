//! Errors that depend on where an axis is, as they were measured: values at positions, linear in between.

use super::{Axis, Motion};

/// Which of the six errors of an axis, in the directions of the machine frame (the first letter behind the E of ISO 230-1).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Component {
    /// A shift along x.
    X,
    /// A shift along y.
    Y,
    /// A shift along z.
    Z,
    /// A turn about x.
    A,
    /// A turn about y.
    B,
    /// A turn about z.
    C,
}

impl Component {
    /// Every component: shifts along x, y, z, then turns about x, y, z.
    pub const ALL: [Self; 6] = [Self::X, Self::Y, Self::Z, Self::A, Self::B, Self::C];

    /// Its letter.
    pub fn letter(self) -> char {
        ['X', 'Y', 'Z', 'A', 'B', 'C'][self as usize]
    }

    /// The direction of the frame it is along or about: 0, 1, 2 for x, y, z.
    pub fn direction(self) -> usize {
        self as usize % 3
    }

    /// Whether it is a turn.
    pub fn is_turn(self) -> bool {
        self as usize >= 3
    }
}

/// One measured error of one axis.
#[derive(Debug, Clone, PartialEq)]
pub struct ErrorTable {
    /// The axis, as an index into the machine's.
    pub axis: usize,
    /// Which of its errors.
    pub component: Component,
    /// Position (mm or deg, in machine coordinates) and error (mm or rad) there; at least one row, positions ascending.
    pub rows: Vec<(f64, f64)>,
}

impl ErrorTable {
    /// The error at a joint value of its axis: linear between rows, and beyond the ends what it is there. A table of a
    /// rotary axis that spans no more than a turn is looked up at the whole turn that is nearest to its middle.
    pub fn at(&self, axis: &Axis, joint: f64) -> f64 {
        let (first, last) = (self.rows[0], self.rows[self.rows.len() - 1]);
        let is_one_turn = axis.motion == Motion::Rotary && last.0 - first.0 <= 360.0;
        let position = if is_one_turn { nearest_turn(joint, first.0 + (last.0 - first.0) / 2.0) } else { joint };
        let above = self.rows.partition_point(|row| row.0 <= position);
        match (above.checked_sub(1).map(|below| self.rows[below]), self.rows.get(above)) {
            (None, _) => first.1,
            (Some(below), None) => below.1,
            (Some(below), Some(above)) => below.1 + (above.1 - below.1) * ((position - below.0) / (above.0 - below.0)),
        }
    }
}

/// The angle, by whole turns from `angle`, that is at most half a turn from `middle`.
fn nearest_turn(angle: f64, middle: f64) -> f64 {
    angle - 360.0 * ((angle - middle) / 360.0).round()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Rule, Travel, Written};

    fn axis(motion: Motion) -> Axis {
        Axis {
            name: "C".to_owned(),
            motion,
            travel: Travel::UNLIMITED,
            written: Written::Unwound,
            zero: 0.0,
            rule: Rule::Pose,
            length_share: 0.0,
            rapid_per_min: None,
        }
    }

    #[test]
    fn a_table_is_linear_between_its_rows_and_level_beyond_them() {
        let table = ErrorTable { axis: 0, component: Component::X, rows: vec![(-10.0, 1.0), (0.0, 3.0), (20.0, -1.0)] };
        let linear = axis(Motion::Linear);
        let at = |position: f64| table.at(&linear, position);
        assert_eq!([at(-400.0), at(-10.0), at(-5.0), at(0.0), at(5.0), at(400.0)], [1.0, 1.0, 2.0, 3.0, 2.0, -1.0]);
    }

    #[test]
    fn whole_turns_do_not_matter_to_a_table_of_one_turn() {
        let table = ErrorTable { axis: 0, component: Component::A, rows: vec![(0.0, 0.0), (90.0, 9.0), (360.0, 0.0)] };
        let rotary = axis(Motion::Rotary);
        for turns in [-3.0, 0.0, 5.0] {
            assert_eq!(table.at(&rotary, 45.0 + 360.0 * turns), 4.5);
        }
        let tilting = ErrorTable { axis: 0, component: Component::A, rows: vec![(-30.0, 1.0), (120.0, 2.0)] };
        assert_eq!([tilting.at(&rotary, -31.0), tilting.at(&rotary, 121.0)], [1.0, 2.0]);
    }

    #[test]
    fn no_number_is_no_panic() {
        let table = ErrorTable { axis: 0, component: Component::A, rows: vec![(0.0, 7.0)] };
        assert_eq!(table.at(&axis(Motion::Linear), f64::NAN), 7.0);
    }
}
