//! A word as it is printed: its address and its number, the short way where there is one.

use super::dialect::Word;
use super::short_word::{ROOM, ShortWord};

/// A word, ready to print.
#[derive(Debug)]
pub(super) struct PrintedWord {
    short: Option<ShortWord>,
    pub(super) word: Word,
}

impl PrintedWord {
    pub(super) fn new(word: Word) -> Self {
        Self { short: ShortWord::new(&word.address, &word.picture), word }
    }

    /// How many bytes the word and a blank behind it take at most.
    pub(super) fn room(&self) -> usize {
        let Word { address, picture, .. } = &self.word;
        ROOM + address.len() + picture.zero.as_ref().map_or(0, String::len)
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
        let mut text = self.word.address.clone().into_bytes();
        self.word.picture.print(units, &mut text);
        room[..text.len()].copy_from_slice(&text);
        text.len()
    }
}
