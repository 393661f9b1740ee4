//! A word as it is printed: its address and its number, the short way where there is one.

use super::dialect::{Picture, Word};
use super::short_word::{ROOM, ShortWord};

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

    /// How many bytes the word and a blank behind it take at most.
    pub(super) fn room(&self) -> usize {
        ROOM + self.address.len() + self.picture.zero.as_ref().map_or(0, String::len)
    }

    /// Prints the word of a number of units that fits, and says how long it is. All of the room may be written to.
    #[inline]
    pub(super) fn print(&self, units: i64, room: &mut [u8]) -> usize {
        match &self.short {
            Some(short) if short.takes(units) => short.print(units, room.first_chunk_mut().expect("room for a word")),
            _ => self.print_any(units, room),
        }
    }

    #[cold]
    fn print_any(&self, units: i64, room: &mut [u8]) -> usize {
        let mut word = self.address.clone().into_bytes();
        self.picture.print(units, &mut word);
        room[..word.len()].copy_from_slice(&word);
        word.len()
    }
}
