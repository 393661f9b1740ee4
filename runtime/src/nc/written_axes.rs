//! The axis words of a program, and what the control knows of them.

use super::axis_word::AxisWord;
use super::dialect::Dialect;
use super::line_buffer::LineBuffer;
use super::write_error::WriteError;
use crate::machine::{Axis, Retract};

/// The axes, in the machine's order.
#[derive(Debug)]
pub(super) struct WrittenAxes {
    axes: Vec<WrittenAxis>,
    /// How many bytes their words take at most, a blank behind each.
    room: usize,
}

/// An axis, with numbers in units of its word's last decimal.
#[derive(Debug)]
struct WrittenAxis {
    word: AxisWord,
    /// Before the motion being printed.
    before: i64,
    /// Behind it.
    now: i64,
}

/// In place of a number that the control does not know. No word has so many digits.
const UNKNOWN: i64 = i64::MIN;

impl WrittenAxis {
    #[inline]
    fn changes(&self) -> bool {
        self.now != self.before
    }
}

impl WrittenAxes {
    /// The axes at the start of a program.
    pub(super) fn new(dialect: &Dialect, axes: &[Axis]) -> Self {
        assert_eq!(dialect.axes.len(), axes.len(), "a dialect has one word for each axis of its machine");
        let words = dialect.axes.iter().zip(axes).map(|(word, axis)| AxisWord::new(word, axis, dialect.units));
        let axes: Vec<_> = words.map(|word| WrittenAxis { word, before: UNKNOWN, now: UNKNOWN }).collect();
        Self { room: axes.iter().map(|axis| axis.word.room()).sum(), axes }
    }

    /// Moves them to `joints` (machine coordinates in mm and degrees). Says whether a word changes.
    ///
    /// # Errors
    /// When a number does not fit its word; all axes are then where they were.
    #[inline]
    pub(super) fn go_to(&mut self, joints: &[f64], tool_length_mm: f64) -> Result<bool, WriteError> {
        let mut changes = false;
        for (index, (axis, joint)) in self.axes.iter_mut().zip(joints).enumerate() {
            let Some(units) = axis.word.units(*joint, tool_length_mm) else {
                let error = axis.word.too_large(*joint, tool_length_mm);
                go_back(&mut self.axes[..index]);
                return Err(error);
            };
            (axis.before, axis.now) = (axis.now, units);
            changes |= axis.changes();
        }
        Ok(changes)
    }

    /// Takes the last motion back.
    pub(super) fn go_back(&mut self) {
        go_back(&mut self.axes);
    }

    /// The control knows none of them any more.
    pub(super) fn forget(&mut self) {
        self.axes.iter_mut().for_each(|axis| axis.now = UNKNOWN);
    }

    /// Whether the control knows all of them.
    pub(super) fn are_known(&self) -> bool {
        self.axes.iter().all(|axis| axis.now != UNKNOWN)
    }

    /// Whether the word of one of these axes changes.
    pub(super) fn change(&self, indices: &[usize]) -> bool {
        indices.iter().any(|index| self.axes[*index].changes())
    }

    /// Prints the words of these axes that change, a blank between them.
    #[inline]
    pub(super) fn print(&self, indices: &[usize], line: &mut LineBuffer) {
        let room = line.room(self.room);
        let (all, mut left) = (room.len(), room);
        for &index in indices {
            let axis = &self.axes[index];
            if axis.changes() {
                let length = axis.word.print(axis.now, left);
                left[length] = b' ';
                left = &mut left[length + 1..];
            }
        }
        let length = all - left.len();
        line.take(length.saturating_sub(1));
    }

    /// Prints the word that takes the tool to its way out.
    ///
    /// # Errors
    /// When a number does not fit its word.
    pub(super) fn print_retract(&self, retract: &Retract, line: &mut LineBuffer) -> Result<(), WriteError> {
        let word = &self.axes[retract.axis].word;
        let length = word.print(word.retract_units(retract)?, line.room(word.room()));
        line.take(length);
        Ok(())
    }
}

#[cold]
fn go_back(axes: &mut [WrittenAxis]) {
    axes.iter_mut().for_each(|axis| axis.now = axis.before);
}
