//! A word as it is printed: its address and its number, the quick way where there is one.

use super::dialect::{Picture, Word};
use super::line::Line;
use super::short_word::ShortWord;

/// A word, ready to print.
#[derive(Debug)]
pub(super) struct PrintedWord {
    short: Option<ShortWord>,
    address: String,
    picture: Picture,
}

impl PrintedWord {
    pub(super) fn new(word: &Word) -> Self {
        let Word { address, picture, .. } = word.clone();
        Self { short: ShortWord::new(&address, &picture), address, picture }
    }

    /// Prints the word of a number of units that fits.
    #[inline]
    pub(super) fn print(&self, units: i64, line: &mut Line) {
        match &self.short {
            Some(short) if short.takes(units) => line.word(|room| short.print(units, room)),
            _ => self.print_any(units, line),
        }
    }

    #[cold]
    fn print_any(&self, units: i64, line: &mut Line) {
        line.print(|bytes| {
            bytes.extend_from_slice(self.address.as_bytes());
            self.picture.print(units, bytes);
        });
    }
}
