//! The word of one axis: from a joint value to the whole units that are printed.

use super::dialect::{LengthUnit, Word};
use super::printed_word::PrintedWord;
use super::rounding::Rounding;
use super::write_error::WriteError;
use crate::machine::{Axis, Motion, Retract, Written};

/// How an axis' joint value becomes the number in its word.
#[derive(Debug)]
pub struct AxisWord {
    word: Word,
    printed: PrintedWord,
    zero: f64,
    length_share: f64,
    /// Words' units in a millimetre or a degree.
    scale: f64,
    rounding: Rounding,
    /// The least units written, and the units of a turn.
    turn: Option<(i64, i64)>,
}

impl AxisWord {
    /// The word of an axis, in a program in these units.
    pub fn new(word: &Word, axis: &Axis, units: LengthUnit) -> Self {
        let scale = match (axis.motion, units) {
            (Motion::Linear, LengthUnit::Inch) => 1.0 / 25.4,
            _ => 1.0,
        };
        let rounding = Rounding::new(&word.picture);
        let turn = match axis.written {
            Written::Wrapped { from_deg } if axis.motion == Motion::Rotary => {
                Some((rounding.unbounded(from_deg).unwrap_or(0), 360 * word.picture.units_per_one()))
            }
            _ => None,
        };
        let (word, printed) = (word.clone(), PrintedWord::new(word));
        Self { word, printed, zero: axis.zero, length_share: axis.length_share, scale, rounding, turn }
    }

    /// The units to print for a joint value in machine coordinates. A turn is taken off after rounding, so that what
    /// rounds to 360 degrees is written as 0.
    ///
    /// # Errors
    /// When the word has too few digits.
    #[inline]
    pub fn units(&self, joint: f64, tool_length_mm: f64) -> Result<i64, WriteError> {
        let value = (joint - self.zero - self.length_share * tool_length_mm) * self.scale;
        match self.rounding.unbounded(value).map(|units| self.within_turn(units)) {
            Some(units) if self.rounding.fits(units) => Ok(units),
            _ => Err(WriteError::too_large(&self.word, value)),
        }
    }

    #[inline]
    fn within_turn(&self, units: i64) -> i64 {
        match self.turn {
            Some((from, turn)) if !(from..from + turn).contains(&units) => from + (units - from).rem_euclid(turn),
            _ => units,
        }
    }

    /// The units to print for the way out, as the machine counts it: at the end of the travel, or just within it. Zero
    /// where the travel has no end, as most controls count from there.
    pub(super) fn retract_units(&self, retract: &Retract) -> Result<i64, WriteError> {
        if retract.end_mm.is_infinite() {
            return Ok(0);
        }
        let value = retract.end_mm * self.scale;
        let picture = &self.word.picture;
        let units = picture.units(value).ok_or_else(|| WriteError::too_large(&self.word, value))?;
        let above = units as f64 / picture.units_per_one() as f64 - value;
        Ok(match retract.is_upper {
            true if above > 1e-9 => units - 1,
            false if above < -1e-9 => units + 1,
            _ => units,
        })
    }

    /// What so many units mean: millimetres or degrees from the program zero.
    pub fn value(&self, units: i64) -> f64 {
        units as f64 / self.word.picture.units_per_one() as f64 / self.scale
    }

    /// Where a control takes the axis for a value in the program: machine coordinates.
    pub fn joint(&self, value: f64, tool_length_mm: f64) -> f64 {
        value + self.zero + self.length_share * tool_length_mm
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
