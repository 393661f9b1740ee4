//! Sequence numbers: the address, the number, a blank.

use super::dialect::Sequence;
use crate::number::Counter;

/// The sequence number that comes next.
#[derive(Debug)]
pub(super) struct Numbering {
    address: String,
    counter: Counter,
}

impl Numbering {
    pub(super) fn new(Sequence { address, start, step, greatest }: Sequence) -> Self {
        Self { address, counter: Counter::new(start, step, greatest) }
    }

    /// Where the digits stand in what is printed.
    pub(super) fn digits_at(&self) -> usize {
        self.address.len()
    }

    /// Prints the number and a blank.
    pub(super) fn print(&self, out: &mut Vec<u8>) {
        out.extend_from_slice(self.address.as_bytes());
        self.counter.print(out);
        out.push(b' ');
    }

    /// Goes on to the next number. Gives its digits, and any bytes behind them, where it has as many as the one before.
    #[inline]
    pub(super) fn advance(&mut self) -> Option<[u8; 8]> {
        self.counter.advance()
    }
}
