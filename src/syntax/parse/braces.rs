//! Braces and their partners. Where one is missing or too many, the indentation of the lines tells which.

use super::bounds::MOST_NESTED;
use crate::syntax::tree::Span;

/// What a text has of braces and lines, in its order.
#[derive(Clone)]
pub(super) enum Mark {
    /// A line with more than comments.
    Line {
        /// How far its first character is from the line's beginning, in characters.
        indentation: usize,
        /// Whether it begins with a `}`.
        closes: bool,
        /// From the end of what stands before it to its first character.
        gap: Span,
    },
    /// A `{`.
    Open(usize),
    /// A `}`.
    Close(usize),
}

/// The braces without a partner.
#[derive(Default)]
pub(super) struct Unpaired {
    /// Each `{` that is never closed.
    pub(super) open: Vec<usize>,
    /// Each `}` that closes nothing.
    pub(super) surplus: Vec<usize>,
    /// The gap between two lines in which a `}` is missing, and has room. Blocks that end with the text have none.
    pub(super) missing: Vec<Span>,
    /// Whether it is known which braces these are, so that all the others match the right partners.
    pub(super) is_certain: bool,
}

impl Unpaired {
    pub(super) fn is_none(&self) -> bool {
        self.open.is_empty() && self.surplus.is_empty()
    }
}

/// Finds the braces without a partner: as the indentation has it, if that explains the text with as few of them as there
/// are at least.
pub(super) fn unpaired(marks: &[Mark]) -> Unpaired {
    let least = in_turn(marks);
    if least.is_none() {
        return least;
    }
    let is_as_good =
        |other: &Unpaired| (other.open.len(), other.surplus.len()) == (least.open.len(), least.surplus.len());
    by_layout(marks).filter(is_as_good).unwrap_or(Unpaired { is_certain: false, ..least })
}

/// Every `}` closes the last open `{`.
fn in_turn(marks: &[Mark]) -> Unpaired {
    let mut unpaired = Unpaired { is_certain: true, ..Unpaired::default() };
    for mark in marks {
        match mark {
            Mark::Line { .. } => {}
            Mark::Open(at) => unpaired.open.push(*at),
            Mark::Close(at) if unpaired.open.is_empty() => unpaired.surplus.push(*at),
            Mark::Close(_) => drop(unpaired.open.pop()),
        }
    }
    unpaired
}

/// A block holds what is indented more than the line on which it is opened. `None` for a text that is laid out otherwise.
fn by_layout(marks: &[Mark]) -> Option<Unpaired> {
    let mut layout = Layout::default();
    for mark in marks {
        match mark {
            Mark::Line { indentation, closes, gap } => layout.line(*indentation, *closes, gap),
            Mark::Open(at) => layout.open.push(Block { at: *at, indentation: layout.indentation }),
            Mark::Close(at) => layout.close(*at),
        }
        if layout.open.len() > MOST_NESTED {
            return None;
        }
    }
    let mut unpaired = layout.unpaired;
    let have_room = unpaired.missing.chunk_by(|a, b| a == b).all(|same| same.len() <= same[0].len());
    unpaired.open.extend(layout.open.iter().map(|block| block.at));
    have_room.then_some(Unpaired { is_certain: true, ..unpaired })
}

struct Block {
    at: usize,
    /// Of the line on which it is opened.
    indentation: usize,
}

#[derive(Default)]
struct Layout {
    open: Vec<Block>,
    /// The blocks that were closed on the line before, and where.
    closed: Vec<(Block, usize)>,
    /// Of the current line.
    indentation: usize,
    unpaired: Unpaired,
}

impl Layout {
    fn line(&mut self, indentation: usize, closes: bool, gap: &Span) {
        self.reopen(indentation, closes);
        self.end(indentation, closes, gap);
        self.closed.clear();
        self.indentation = indentation;
    }

    /// A block that this line still stands in, or closes, was closed too early.
    fn reopen(&mut self, indentation: usize, closes: bool) {
        let is_meant = |block: &Block| match closes {
            true => block.indentation == indentation && !self.is_open(indentation),
            false => block.indentation < indentation,
        };
        let Some(first) = self.closed.iter().position(|(block, _)| is_meant(block)) else { return };
        for (block, closed_at) in self.closed.drain(first..) {
            let outside = self.open.iter().take_while(|outer| outer.at < block.at).count();
            self.open.insert(outside, block);
            self.unpaired.surplus.push(closed_at);
        }
    }

    /// A block that this line does not stand in any more, nor closes, has ended before it.
    fn end(&mut self, indentation: usize, closes: bool, gap: &Span) {
        if closes && !self.is_open(indentation) {
            return;
        }
        let has_ended = |block: &mut Block| match closes {
            true => block.indentation != indentation,
            false => block.indentation >= indentation,
        };
        while let Some(block) = self.open.pop_if(has_ended) {
            self.unpaired.open.push(block.at);
            self.unpaired.missing.push(gap.clone());
        }
    }

    fn is_open(&self, indentation: usize) -> bool {
        self.open.iter().any(|block| block.indentation == indentation)
    }

    fn close(&mut self, at: usize) {
        match self.open.pop() {
            Some(block) => self.closed.push((block, at)),
            None => self.unpaired.surplus.push(at),
        }
    }
}
