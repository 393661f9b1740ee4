//! One line while it is printed: its sequence number, its blanks, its end.

use super::dialect::Sequence;
use super::numbering::Numbering;

/// The line being printed, behind the number that it may take.
#[derive(Debug)]
pub(super) struct Line {
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

impl Line {
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
    /// line, and takes no number.
    #[inline]
    pub(super) fn finish(&mut self, numbered: bool, out: &mut Vec<u8>) {
        while self.end > self.body && self.bytes[self.end - 1] == b' ' {
            self.end -= 1;
        }
        if self.end > self.body {
            self.byte(b'\n');
            let start = if numbered { 0 } else { self.body };
            out.extend_from_slice(&self.bytes[start..self.end]);
            if numbered {
                self.count_up();
            }
        }
    }

    /// Goes on to the next number.
    #[inline]
    fn count_up(&mut self) {
        let Some(numbering) = &mut self.numbering else { return };
        match numbering.advance() {
            Some(digits) => {
                self.end = numbering.address().len();
                *self.room(digits.len()).first_chunk_mut().expect("the room asked for") = digits;
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
    }
}
