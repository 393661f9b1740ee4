//! What a block switches off beside what it is for: most tool changes stop the spindle and the coolant.
//!
//! A dialect does not say so. It is found by the words of the blocks that do nothing else: a block with all the words of a line
//! of `on spindle off` in one of its lines switches the spindle off, and so it is with the coolant.

use super::dialect::{Block, Dialect, Line, Piece, Trigger};
use std::mem;

/// What stands behind a block, whatever the CL has in force.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct SwitchesOff {
    /// The spindle.
    pub spindle: bool,
    /// The coolant.
    pub coolant: bool,
}

impl SwitchesOff {
    /// What the block of a command switches off. One that is about the spindle says all that there is to say of it, as one
    /// about the coolant does.
    pub(super) fn of(trigger: Trigger, dialect: &Dialect) -> Self {
        use Trigger::{CoolantFlood, CoolantMist, CoolantOff, CoolantThrough};
        use Trigger::{SpindleClockwise, SpindleCounterclockwise, SpindleOff};
        let has_words_of = |off| match (dialect.block(trigger), dialect.block(off)) {
            (Some(block), Some(off)) => has_words_of(block, off, dialect),
            _ => false,
        };
        let is_of_spindle = matches!(trigger, SpindleClockwise | SpindleCounterclockwise | SpindleOff);
        let is_of_coolant = matches!(trigger, CoolantFlood | CoolantMist | CoolantThrough | CoolantOff);
        Self {
            spindle: !is_of_spindle && has_words_of(SpindleOff),
            coolant: !is_of_coolant && has_words_of(CoolantOff),
        }
    }
}

/// Whether all words of some line of one block are in one line of the other.
fn has_words_of(block: &Block, off: &Block, dialect: &Dialect) -> bool {
    let lines: Vec<_> = block.lines.iter().map(|line| words(line, dialect)).collect();
    let mut off = off.lines.iter().map(|line| words(line, dialect)).filter(|words| !words.is_empty());
    off.any(|off| lines.iter().any(|line| off.iter().all(|word| line.contains(word))))
}

/// The words of a line, without comments. They may stand without blanks between them, and `M05` is `M5`.
fn words(line: &Line, dialect: &Dialect) -> Vec<String> {
    let mut words = Vec::new();
    let mut word = String::new();
    for c in without_comments(&text(line, dialect), &dialect.comment).chars() {
        let begins_here = c.is_ascii_alphabetic() && word.ends_with(|last: char| !last.is_ascii_alphabetic());
        if c == ' ' || begins_here {
            words.push(mem::take(&mut word));
        }
        if c.is_ascii_digit() && word.trim_start_matches(|c: char| c.is_ascii_alphabetic()) == "0" {
            word.pop();
        }
        word.extend((c != ' ').then_some(c));
    }
    words.push(word);
    words.retain(|word| !word.is_empty());
    words
}

/// The text of a line; what a program fills in is the same wherever it is the same placeholder.
fn text(line: &Line, dialect: &Dialect) -> String {
    let piece = |piece: &Piece| match piece {
        Piece::Text(text) => text.clone(),
        Piece::Modal { group, code } => dialect.modal_groups[*group][*code].clone(),
        Piece::Value(value, _) => format!("{{{value:?}}}"),
        Piece::Axes(_) | Piece::Feed => String::new(), // in motions only
    };
    line.pieces.iter().map(piece).collect()
}

fn without_comments(text: &str, (open, close): &(String, String)) -> String {
    let mut kept = String::new();
    let mut rest = text;
    while !open.is_empty()
        && let Some((before, comment)) = rest.split_once(open)
    {
        kept += before;
        let behind = if close.is_empty() { None } else { comment.split_once(close) };
        rest = behind.map_or("", |(_, behind)| behind);
    }
    kept + rest
}
