//! Bytes to lines, as a stream: one buffer, no copies, no line longer than a bound.

use std::io::{self, ErrorKind, Read};

use memchr::{memchr, memrchr};

/// How much is read at once.
const BUFFER_BYTES: usize = 256 * 1024;
/// The longest line taken.
pub(super) const LONGEST_LINE_BYTES: usize = 64 * 1024;
/// How much of a longer line is kept to be shown.
const HEAD_BYTES: usize = 120;

/// One line, without its end.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum SourceLine<'a> {
    /// The whole of it.
    Text(&'a [u8]),
    /// The first bytes of a line that is longer than [`LONGEST_LINE_BYTES`].
    TooLong(&'a [u8]),
}

/// A text read line by line.
#[derive(Debug)]
pub(super) struct Source<R> {
    input: R,
    buffer: Vec<u8>,
    /// Where the next line starts.
    start: usize,
    /// Up to here every line is whole: it ends in a line feed, or at the end of the file.
    whole: usize,
    /// Up to here the buffer is filled.
    end: usize,
    at_end: bool,
    lines_read: u64,
}

impl<R: Read> Source<R> {
    pub(super) fn new(input: R) -> Self {
        let buffer = vec![0; BUFFER_BYTES];
        Self { input, buffer, start: 0, whole: 0, end: 0, at_end: false, lines_read: 0 }
    }

    /// The number of the line that was read last, from 1.
    pub(super) fn line(&self) -> u64 {
        self.lines_read
    }

    /// The whole lines that are at hand; nothing at the end of the file.
    #[inline]
    pub(super) fn whole_lines(&mut self) -> io::Result<&[u8]> {
        if self.start == self.whole {
            self.fill()?;
        }
        Ok(&self.buffer[self.start..self.whole])
    }

    /// Takes one line of `bytes` bytes from what [`Self::whole_lines`] gave.
    #[inline]
    pub(super) fn take_line(&mut self, bytes: usize) {
        self.start += bytes;
        self.lines_read += 1;
    }

    /// The next line; `None` at the end of the file.
    pub(super) fn next_line(&mut self) -> io::Result<Option<SourceLine<'_>>> {
        let rest = self.whole_lines()?;
        if rest.is_empty() {
            return if self.at_end { Ok(None) } else { self.skip_long_line().map(Some) };
        }
        let length = memchr(b'\n', rest).map_or(rest.len(), |feed| feed + 1);
        let line = self.start..self.start + length;
        self.take_line(length);
        let text = without_end(&self.buffer[line]);
        Ok(Some(if text.len() <= LONGEST_LINE_BYTES {
            SourceLine::Text(text)
        } else {
            SourceLine::TooLong(&text[..HEAD_BYTES])
        }))
    }

    /// Reads until there is a whole line, or the file ends, or the buffer is full.
    fn fill(&mut self) -> io::Result<()> {
        self.buffer.copy_within(self.start..self.end, 0);
        self.end -= self.start;
        (self.start, self.whole) = (0, 0);
        while self.whole == 0 && !self.at_end && self.end < self.buffer.len() {
            let from = self.end;
            self.read_more()?;
            self.whole = match memrchr(b'\n', &self.buffer[from..self.end]) {
                Some(feed) => from + feed + 1,
                None if self.at_end => self.end,
                None => 0,
            };
        }
        Ok(())
    }

    fn read_more(&mut self) -> io::Result<()> {
        loop {
            match self.input.read(&mut self.buffer[self.end..]) {
                Ok(bytes) => {
                    self.end += bytes;
                    self.at_end = bytes == 0;
                    return Ok(());
                }
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
    }

    /// The buffer is full of one line: drops the rest of it as it comes.
    fn skip_long_line(&mut self) -> io::Result<SourceLine<'_>> {
        loop {
            self.end = HEAD_BYTES;
            self.read_more()?;
            match memchr(b'\n', &self.buffer[HEAD_BYTES..self.end]) {
                Some(feed) => {
                    self.start = HEAD_BYTES + feed + 1;
                    let lines = memrchr(b'\n', &self.buffer[self.start..self.end]);
                    self.whole = lines.map_or(self.start, |last| self.start + last + 1);
                    break;
                }
                None if self.at_end => {
                    (self.start, self.whole) = (self.end, self.end);
                    break;
                }
                None => {}
            }
        }
        self.lines_read += 1;
        Ok(SourceLine::TooLong(&self.buffer[..HEAD_BYTES]))
    }
}

/// The line without its line feed or carriage return and line feed.
fn without_end(line: &[u8]) -> &[u8] {
    let line = line.strip_suffix(b"\n").unwrap_or(line);
    line.strip_suffix(b"\r").unwrap_or(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lengths(text: &[u8]) -> Vec<(u64, usize, bool)> {
        let mut source = Source::new(text);
        let mut found = Vec::new();
        while let Some(line) = source.next_line().unwrap() {
            let (length, whole) = match line {
                SourceLine::Text(text) => (text.len(), true),
                SourceLine::TooLong(head) => (head.len(), false),
            };
            found.push((source.line(), length, whole));
        }
        found
    }

    #[test]
    fn every_kind_of_line_end() {
        assert_eq!(lengths(b"ab\r\n\nabc\nabcd"), [(1, 2, true), (2, 0, true), (3, 3, true), (4, 4, true)]);
        assert_eq!(lengths(b""), []);
    }

    #[test]
    fn a_line_of_any_length_does_not_stop_the_reading() {
        for length in [LONGEST_LINE_BYTES + 1, BUFFER_BYTES - 3, BUFFER_BYTES, BUFFER_BYTES + 1, 10_000_000] {
            let mut text = b"a\n".to_vec();
            text.extend(vec![b'x'; length]);
            assert_eq!(lengths(&text), [(1, 1, true), (2, HEAD_BYTES, false)], "{length}");
            text.extend(b"\nbb\nccc");
            let all = [(1, 1, true), (2, HEAD_BYTES, false), (3, 2, true), (4, 3, true)];
            assert_eq!(lengths(&text), all, "{length}");
        }
    }
}
