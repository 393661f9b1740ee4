//! One line while it is printed: its sequence number, its blanks, its end.

use super::dialect::Sequence;
use super::numbering::Numbering;

/// The line being printed, behind the number that it may take.
#[derive(Debug)]
pub(super) struct LineBuffer {
    /// The number and its blank, the line, and any bytes behind it.
    bytes: Vec<u8>,
    /// Where the line begins.
    body: usize,
    /// Where it ends so far.
    end: usize,
    numbering: Option<Numbering>,
}

/// So many bytes are added when there is no room in a line.
const MORE: usize = 256;

impl LineBuffer {
    /// An empty line behind the first number.
    pub(super) fn new(sequence: Option<Sequence>) -> Self {
        let mut line = Self { bytes: Vec::new(), body: 0, end: 0, numbering: sequence.map(Numbering::new) };
        line.print_number();
        line
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

    /// The room behind it, which has so many bytes or more. What is printed there has to be [taken](Self::take).
    #[inline]
    pub(super) fn room(&mut self, count: usize) -> &mut [u8] {
        if self.bytes.len() < self.end + count {
            self.grow(count);
        }
        &mut self.bytes[self.end..]
    }

    /// Takes so many bytes of the room.
    #[inline]
    pub(super) fn take(&mut self, count: usize) {
        self.end += count;
    }

    #[cold]
    fn grow(&mut self, count: usize) {
        self.bytes.resize(self.end + count + MORE, 0);
    }

    /// Prints a byte.
    #[inline]
    pub(super) fn byte(&mut self, byte: u8) {
        self.room(1)[0] = byte;
        self.take(1);
    }

    /// Prints anything.
    pub(super) fn print<T>(&mut self, print: impl FnOnce(&mut Vec<u8>) -> T) -> T {
        self.bytes.truncate(self.end);
        let printed = print(&mut self.bytes);
        self.end = self.bytes.len();
        self.grow(0);
        printed
    }

    /// Prints text.
    pub(super) fn text(&mut self, text: &str) {
        self.room(text.len())[..text.len()].copy_from_slice(text.as_bytes());
        self.take(text.len());
    }

    /// Prints a blank of the template, which is left out behind another one and where the line begins.
    #[inline]
    pub(super) fn blank(&mut self) {
        if !self.is_behind_blank() {
            self.byte(b' ');
        }
    }

    /// Prints text of the template; its first blanks are left out behind another one and where the line begins.
    pub(super) fn template(&mut self, text: &str) {
        self.text(if self.is_behind_blank() { text.trim_start_matches(' ') } else { text });
    }

    #[inline]
    fn is_behind_blank(&self) -> bool {
        self.end == self.body || self.bytes[self.end - 1] == b' '
    }

    /// Ends the line and moves it into the program, with its number or without; one that has nothing in it is not a
    /// line, and takes no number. Says whether it is one. (The compiler finds it too large for its place, which every line passes.)
    #[inline(always)]
    pub(super) fn finish(&mut self, numbered: bool, out: &mut Vec<u8>) -> bool {
        let mut line = &self.bytes[..self.end];
        while line.len() > self.body
            && let [rest @ .., b' '] = line
        {
            line = rest;
        }
        let is_line = line.len() > self.body;
        if is_line {
            out.extend_from_slice(if numbered { line } else { &line[self.body..] });
            out.push(b'\n');
            if numbered {
                self.count_up();
            }
        }
        is_line
    }

    /// Goes on to the next number.
    #[inline]
    fn count_up(&mut self) {
        let Some(numbering) = &mut self.numbering else { return };
        match numbering.advance() {
            Some(digits) => {
                self.bytes[numbering.digits_at()..][..digits.len()].copy_from_slice(&digits);
                self.bytes[self.body - 1] = b' ';
            }
            None => self.print_number(),
        }
    }

    /// Prints the number as a whole.
    #[cold]
    fn print_number(&mut self) {
        self.bytes.clear();
        if let Some(numbering) = &self.numbering {
            numbering.print(&mut self.bytes);
        }
        (self.body, self.end) = (self.bytes.len(), self.bytes.len());
        self.grow(0);
    }
}
