//! The word of one axis: from a joint value to the whole units that are printed.

use super::dialect::Word;
use super::printed_word::PrintedWord;
use super::write_error::WriteError;
use crate::coordinates::{AxisOffset, word_unit};
use crate::machine::{Axis, Motion, Retract, Travel, Written};
use crate::number::{Picture, Rounding};
use crate::unit::LengthUnit;

/// How an axis' joint value becomes the number in its word.
#[derive(Debug)]
pub struct AxisWord {
    printed: PrintedWord,
    offset: AxisOffset,
    /// Words' units in a millimetre or a degree.
    scale: f64,
    rounding: Rounding,
    travel: Travel,
    /// Where rounding takes no joint out of the travel.
    inside: Travel,
    turn: Option<Turn>,
}

/// How far beyond its travel a word may take an axis, in mm or degrees: what the sums of its value are off.
const BEYOND: f64 = 1e-9;

/// The turn that a rotary value is reduced to, in units.
#[derive(Debug, Clone, Copy)]
struct Turn {
    /// The least number written.
    from: i64,
    length: i64,
    /// The least number that has too many digits.
    too_many: i64,
}

impl Turn {
    fn new(from_deg: f64, picture: &Picture) -> Self {
        let from = picture.unbounded_rounding().units(from_deg).unwrap_or(0);
        Self { from, length: 360 * picture.units_per_one(), too_many: picture.too_many_units() }
    }

    /// The same angle within the turn, if there are digits enough for it.
    #[inline]
    fn reduce(&self, units: i64) -> Option<i64> {
        let Self { from, length, too_many } = *self;
        let is_within = (from..from + length).contains(&units);
        let reduced = if is_within { units } else { from + (units - from).rem_euclid(length) };
        (reduced.abs() < too_many).then_some(reduced)
    }
}

impl AxisWord {
    /// The word of an axis, in a program in these units.
    pub fn new(word: &Word, axis: &Axis, units: LengthUnit) -> Self {
        let turn = match axis.written {
            Written::Wrapped { from_deg } if axis.motion == Motion::Rotary => Some(Turn::new(from_deg, &word.picture)),
            _ => None,
        };
        let picture = &word.picture;
        let rounding = if turn.is_some() { picture.unbounded_rounding() } else { picture.rounding() };
        let (offset, scale) = (AxisOffset::of(axis), 1.0 / word_unit(axis.motion, units));
        let (travel, step) = (axis.travel, 1.0 / (scale * picture.units_per_one() as f64));
        let inside = Travel { lower: travel.lower + step, upper: travel.upper - step };
        Self { printed: PrintedWord::new(word.clone()), offset, scale, rounding, travel, inside, turn }
    }

    /// The units to print for a joint value in machine coordinates; nothing when the word has too few digits. What would be
    /// rounded out of the travel is rounded into it. A turn is taken off after rounding, so that what rounds to 360 degrees
    /// is written as 0.
    #[inline]
    pub fn units(&self, joint: f64, tool_length_mm: f64) -> Option<i64> {
        let mut units = self.rounding.units(self.value_at(joint, tool_length_mm))?;
        if !self.inside.contains(joint) {
            units = self.within_travel(units, self.offset.joint(self.value(units), tool_length_mm));
        }
        match &self.turn {
            None => Some(units),
            Some(turn) => turn.reduce(units),
        }
    }

    /// Why there are no units for a joint value.
    #[cold]
    pub(super) fn too_large(&self, joint: f64, tool_length_mm: f64) -> WriteError {
        WriteError::too_large(&self.printed.word, self.value_at(joint, tool_length_mm))
    }

    /// The value in the word's unit.
    #[inline]
    fn value_at(&self, joint: f64, tool_length_mm: f64) -> f64 {
        self.offset.programmed(joint, tool_length_mm) * self.scale
    }

    /// The units to print for the way out, as the machine counts it: at the end of the travel, or just within it. Zero
    /// where the travel has no end, as most controls count from there.
    pub(super) fn retract_units(&self, retract: &Retract) -> Result<i64, WriteError> {
        if retract.end_mm.is_infinite() {
            return Ok(0);
        }
        let value = retract.end_mm * self.scale;
        let picture = &self.printed.word.picture;
        let units = picture.units(value).ok_or_else(|| WriteError::too_large(&self.printed.word, value))?;
        Ok(self.within_travel(units, self.value(units)))
    }

    /// One unit farther inside where so many units take the axis beyond its travel.
    #[cold]
    fn within_travel(&self, units: i64, joint: f64) -> i64 {
        i64::from(joint < self.travel.lower - BEYOND) - i64::from(joint > self.travel.upper + BEYOND) + units
    }

    /// What so many units mean: millimetres or degrees from the program zero.
    pub fn value(&self, units: i64) -> f64 {
        self.printed.word.picture.value(units) / self.scale
    }

    /// How many bytes the word and a blank behind it take at most.
    pub(super) fn room(&self) -> usize {
        self.printed.room()
    }

    /// Prints the word, and says how long it is. All of the room may be written to.
    #[inline]
    pub(super) fn print(&self, units: i64, room: &mut [u8]) -> usize {
        self.printed.print(units, room)
    }
}
