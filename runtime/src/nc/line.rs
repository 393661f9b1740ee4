//! One line while it is printed: its sequence number, its blanks, its end.

use super::dialect::Sequence;
use super::picture::print_whole;

/// Sequence numbers, and the one that comes next.
#[derive(Debug)]
pub(super) struct Numbering {
    sequence: Option<Sequence>,
    next: u64,
}

impl Numbering {
    pub(super) fn new(sequence: Option<Sequence>) -> Self {
        let next = sequence.as_ref().map_or(0, |sequence| sequence.start);
        Self { sequence, next }
    }

    fn print(&self, out: &mut Vec<u8>) {
        if let Some(sequence) = &self.sequence {
            out.extend_from_slice(sequence.address.as_bytes());
            print_whole(self.next, out);
            out.push(b' ');
        }
    }

    fn advance(&mut self) {
        if let Some(sequence) = &self.sequence {
            let next = self.next.saturating_add(sequence.step);
            self.next = if next > sequence.greatest { sequence.start } else { next };
        }
    }
}

/// Where a line being printed begins.
#[derive(Debug, Clone, Copy)]
pub(super) struct OpenLine {
    start: usize,
    body: usize,
    numbered: bool,
}

impl OpenLine {
    /// Begins a line.
    pub(super) fn begin(numbered: bool, numbering: &Numbering, out: &mut Vec<u8>) -> Self {
        let start = out.len();
        if numbered {
            numbering.print(out);
        }
        Self { start, body: out.len(), numbered }
    }

    /// Prints text of the template; blanks that would follow a blank or begin the line are left out.
    pub(super) fn text(self, text: &str, out: &mut Vec<u8>) {
        let after_blank = out.len() == self.body || out.last() == Some(&b' ');
        let blanks = text.bytes().take_while(|byte| after_blank && *byte == b' ').count();
        out.extend_from_slice(&text.as_bytes()[blanks..]);
    }

    /// Ends the line; one that has nothing in it is taken back, with its number.
    pub(super) fn end(self, numbering: &mut Numbering, out: &mut Vec<u8>) {
        while out.len() > self.body && out.last() == Some(&b' ') {
            out.pop();
        }
        if out.len() == self.body {
            out.truncate(self.start);
            return;
        }
        out.push(b'\n');
        if self.numbered {
            numbering.advance();
        }
    }
}
