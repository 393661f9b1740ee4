//! One line while it is printed: its sequence number, its blanks, its end.

use super::numbering::Numbering;
use super::short_word::ROOM;

/// The line being printed, behind the number that it may take.
#[derive(Debug)]
pub(super) struct Line {
    /// The number and its blank, the line, and always room for a word and a byte more behind it.
    bytes: Vec<u8>,
    /// Where the line begins.
    body: usize,
    /// Where it ends so far.
    end: usize,
}

impl Line {
    /// An empty line behind the first number.
    pub(super) fn new(numbering: &Numbering) -> Self {
        let mut line = Self { bytes: vec![0; 2 * ROOM], body: 0, end: 0 };
        line.put_behind(numbering);
        line
    }

    /// Empties it, and puts it behind the next number.
    #[inline]
    pub(super) fn put_behind(&mut self, numbering: &Numbering) {
        self.end = 0;
        numbering.print(self);
        self.body = self.end;
    }

    /// Empties it.
    #[inline]
    pub(super) fn clear(&mut self) {
        self.end = self.body;
    }

    /// How long it is, its number included.
    #[inline]
    pub(super) fn len(&self) -> usize {
        self.end
    }

    /// Prints a word, which says how much of the room it takes.
    #[inline]
    pub(super) fn word(&mut self, print: impl FnOnce(&mut [u8; ROOM]) -> usize) {
        let room = self.bytes[self.end..].first_chunk_mut().expect("there is always room for a word");
        self.end += print(room);
        self.make_room();
    }

    /// Prints a byte.
    #[inline]
    pub(super) fn byte(&mut self, byte: u8) {
        self.bytes[self.end] = byte;
        self.end += 1;
        self.make_room();
    }

    /// Prints anything.
    pub(super) fn print<T>(&mut self, print: impl FnOnce(&mut Vec<u8>) -> T) -> T {
        self.bytes.truncate(self.end);
        let printed = print(&mut self.bytes);
        self.end = self.bytes.len();
        self.make_room();
        printed
    }

    /// Prints text.
    pub(super) fn text(&mut self, text: &str) {
        self.print(|bytes| bytes.extend_from_slice(text.as_bytes()));
    }

    /// Prints text of the template; blanks that would follow a blank or begin the line are left out.
    #[inline]
    pub(super) fn template(&mut self, text: &str) {
        let after_blank = self.end == self.body || self.bytes[self.end - 1] == b' ';
        match text {
            " " if after_blank => {}
            " " => self.byte(b' '),
            text if after_blank => self.text(text.trim_start_matches(' ')),
            text => self.text(text),
        }
    }

    /// Ends the line and moves it into the program, with its number or without; one that has nothing in it is not a
    /// line. Says whether it was one.
    #[inline]
    pub(super) fn finish(&mut self, numbered: bool, out: &mut Vec<u8>) -> bool {
        while self.end > self.body && self.bytes[self.end - 1] == b' ' {
            self.end -= 1;
        }
        let is_line = self.end > self.body;
        if is_line {
            self.bytes[self.end] = b'\n';
            let start = if numbered { 0 } else { self.body };
            out.extend_from_slice(&self.bytes[start..=self.end]);
        }
        is_line
    }

    #[inline]
    fn make_room(&mut self) {
        if self.bytes.len() < self.end + ROOM {
            self.grow();
        }
    }

    #[cold]
    fn grow(&mut self) {
        self.bytes.resize(self.end + 4 * ROOM, 0);
    }
}
