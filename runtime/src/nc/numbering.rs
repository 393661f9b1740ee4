//! Sequence numbers.

use super::dialect::{Picture, Sequence};
use super::line::Line;
use super::picture::print_whole;
use super::short_word::ShortWord;

/// Sequence numbers, and the one that comes next; none for a dialect without.
#[derive(Debug)]
pub(super) struct Numbering {
    sequence: Option<Sequence>,
    short: Option<ShortWord>,
    next: u64,
}

impl Numbering {
    pub(super) fn new(sequence: Option<Sequence>) -> Self {
        let short = sequence.as_ref().and_then(|sequence| ShortWord::new(&sequence.address, &Picture::WHOLE));
        let next = sequence.as_ref().map_or(0, |sequence| sequence.start);
        Self { sequence, short, next }
    }

    /// Prints the next number and a blank.
    #[inline]
    pub(super) fn print(&self, line: &mut Line) {
        match (&self.short, i64::try_from(self.next)) {
            (Some(short), Ok(next)) if short.takes(next) => {
                line.word(|room| short.print(next, room));
                line.byte(b' ');
            }
            _ => self.print_any(line),
        }
    }

    #[cold]
    fn print_any(&self, line: &mut Line) {
        if let Some(sequence) = &self.sequence {
            line.print(|bytes| {
                bytes.extend_from_slice(sequence.address.as_bytes());
                print_whole(self.next, bytes);
                bytes.push(b' ');
            });
        }
    }

    #[inline]
    pub(super) fn advance(&mut self) {
        if let Some(sequence) = &self.sequence {
            let next = self.next.saturating_add(sequence.step);
            self.next = if next > sequence.greatest { sequence.start } else { next };
        }
    }
}
