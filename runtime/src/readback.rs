//! Read-back: the printed text, read as a control would read it, back into joint values.
//!
//! Nothing here knows what the writer meant to print. Words may stand without blanks between them; an axis word keeps
//! its value until it is given again. What is read is the text of motions: blocks that send an axis elsewhere for once
//! (`G53 Z0.`) are not for this reader, and the writer prints every axis after them.

use crate::coordinates::{AxisOffset, word_unit};
use crate::dialect::table::BlockKind;
use crate::machine::Axis;
use crate::nc::dialect::Dialect;
use crate::number::{Decimal, usual_decimal};
use std::cmp::Reverse;
use std::fmt;
use std::ops::Range;

/// Reads the motions of one program.
#[derive(Debug)]
pub struct ReadBack {
    /// What each byte begins.
    begins: [Begins; 256],
    /// What the axes' words mean, in the machine's order.
    meanings: Vec<Meaning>,
    tool_length_mm: f64,
    /// Where the axes are.
    joints: Vec<f64>,
    /// The axes that have never been given, the first one in the lowest bit.
    missing: u64,
    /// What the axes' words look like, in the same order.
    words: Vec<AxisAddress>,
    /// The axes by their addresses, the longest first.
    by_address: Vec<usize>,
    comment: (Vec<u8>, Vec<u8>),
    /// Whether a name may be one letter, and a number without an address begins the block.
    is_of_statements: bool,
}

/// What a byte begins, where one word or block is over.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Begins {
    /// The next block: the line feed.
    Block,
    Blank,
    /// The word of the axis with this index: the letter is its address, and begins no longer one.
    AxisWord(u8),
    /// A word that moves nothing, if any: the letter begins no axis' word, and no comment.
    OtherWord,
    /// Only what follows will tell.
    Unsure,
}

/// What the number of an axis' word means.
#[derive(Debug)]
struct Meaning {
    /// Millimetres or degrees in the word's unit.
    unit: f64,
    offset: AxisOffset,
}

/// How an axis' word begins, and how it might be taken to begin.
#[derive(Debug)]
struct AxisAddress {
    address: Vec<u8>,
    name: Vec<u8>,
}

/// Text that is no block of the dialect.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReadError {
    /// Where, in bytes from the start of the motion.
    pub offset: usize,
    /// What is wrong there.
    pub mistake: Mistake,
}

/// What can be wrong with printed text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mistake {
    /// No word begins here.
    NoWord,
    /// A comment without its end.
    OpenComment,
    /// An axis twice in one block.
    Repeated,
    /// The text is over, and this axis (an index) has never been given.
    Missing(usize),
}

impl ReadBack {
    /// A reader at the start of a program, with a tool of this length. `axes` are the machine's, in the order of the
    /// dialect's axis words.
    pub fn new(dialect: &Dialect, axes: &[Axis], tool_length_mm: f64) -> Self {
        assert_eq!(dialect.axes.len(), axes.len(), "a dialect has one word for each axis of its machine");
        let bytes = |text: &String| text.clone().into_bytes();
        let comment = (bytes(&dialect.comment.0), bytes(&dialect.comment.1));
        let words =
            dialect.axes.iter().map(|word| AxisAddress { address: bytes(&word.address), name: bytes(&word.name) });
        let words: Vec<AxisAddress> = words.collect();
        let mut by_address: Vec<usize> = (0..words.len()).collect();
        by_address.sort_by_key(|&axis| Reverse(words[axis].address.len()));
        let meaning =
            |axis: &Axis| Meaning { unit: word_unit(axis.motion, dialect.units), offset: AxisOffset::of(axis) };
        Self {
            begins: std::array::from_fn(|byte| begins(byte as u8, &words, &comment.0)),
            meanings: axes.iter().map(meaning).collect(),
            tool_length_mm,
            joints: vec![0.0; axes.len()],
            missing: (0..axes.len()).map(|axis| 1 << axis).sum(),
            words,
            by_address,
            comment,
            is_of_statements: dialect.block_kind == BlockKind::Statements,
        }
    }

    /// Reads a motion: whole blocks in this range of the text (none of them, when nothing had to be printed). Says how many
    /// blocks there were, and what joints they leave the machine at: machine coordinates in mm and degrees, in the
    /// machine's order.
    ///
    /// # Errors
    /// When the text is not made of words, or an axis has never been given.
    pub fn read(&mut self, text: &[u8], motion: Range<usize>) -> Result<(u64, &[f64]), ReadError> {
        let behind_motion = text.len() - motion.end;
        let mut rest = &text[motion.start..];
        let mut blocks = 0;
        let mut given = 0;
        while rest.len() > behind_motion
            && let [byte, behind @ ..] = rest
        {
            rest = match self.begins[usize::from(*byte)] {
                Begins::Blank => behind,
                Begins::Block => {
                    self.missing &= !given;
                    given = 0;
                    blocks += 1;
                    behind
                }
                begins => match self.usual_word(begins, behind, &mut given) {
                    Some(behind) => behind.strip_prefix(b" ").unwrap_or(behind),
                    None => {
                        let at = text.len() - rest.len();
                        let end = self.any_word(text, at, &mut given);
                        &text[end.map_err(|mistake| ReadError { offset: at - motion.start, mistake })?..]
                    }
                },
            };
        }
        self.missing &= !given;
        match self.missing {
            0 => Ok((blocks, &self.joints)),
            missing => {
                let mistake = Mistake::Missing(missing.trailing_zeros() as usize);
                Err(ReadError { offset: motion.len(), mistake })
            }
        }
    }

    /// Reads a word of the usual kind behind its first letter, and says what stands behind it: an axis' word with a plain
    /// number, or a sequence number or the like. `None` for all others, which need not be wrong.
    #[inline]
    fn usual_word<'a>(&mut self, begins: Begins, text: &'a [u8], given: &mut u64) -> Option<&'a [u8]> {
        match begins {
            Begins::AxisWord(axis) => {
                let (value, behind) = usual_decimal(text)?;
                self.give(usize::from(axis), value, given).then_some(behind)
            }
            Begins::OtherWord => behind_whole_number(text),
            _ => None,
        }
    }

    /// Reads a word, whatever it is, and says where it ends.
    #[cold]
    fn any_word(&mut self, text: &[u8], at: usize, given: &mut u64) -> Result<usize, Mistake> {
        if let Some((axis, value, end)) = self.axis_word(text, at) {
            self.give(axis, value, given).then_some(end).ok_or(Mistake::Repeated)
        } else if text[at..].starts_with(&self.comment.0) && !self.comment.0.is_empty() {
            comment_end(text, at + self.comment.0.len(), &self.comment.1).ok_or(Mistake::OpenComment)
        } else {
            self.other_word(text, at).ok_or(Mistake::NoWord)
        }
    }

    /// Moves an axis to what its word says. False when the block has done so before.
    #[inline]
    fn give(&mut self, axis: usize, value: f64, given: &mut u64) -> bool {
        let bit = 1 << axis;
        let first = *given & bit == 0;
        if first {
            *given |= bit;
            let word = &self.meanings[axis];
            self.joints[axis] = word.offset.joint(value * word.unit, self.tool_length_mm);
        }
        first
    }

    /// An axis, its number, and the end of its word.
    fn axis_word(&self, text: &[u8], at: usize) -> Option<(usize, f64, usize)> {
        let begins_here = |axis: &&usize| text[at..].starts_with(&self.words[**axis].address);
        let axis = *self.by_address.iter().find(begins_here)?;
        let (value, end) = number(text, at + self.words[axis].address.len())?;
        Some((axis, value, end))
    }

    /// The end of a word that moves nothing: `G1`, `F500.`, `S1=3000`, `SUPA`; none for anything else, and none for a
    /// word that looks like an axis' but is not written the dialect's way.
    fn other_word(&self, text: &[u8], at: usize) -> Option<usize> {
        let letters = text[at..].iter().take_while(|byte| byte.is_ascii_uppercase()).count();
        if letters == 0 {
            let begins_line = at == 0 || text[at - 1] == b'\n';
            let digits = text[at..].iter().take_while(|byte| byte.is_ascii_digit()).count();
            return (self.is_of_statements && begins_line && digits > 0).then_some(at + digits);
        }
        let behind = at + letters;
        let (name_end, end) = match number(text, behind) {
            Some((_, end)) if text.get(end) == Some(&b'=') => (end, number(text, end + 1)?.1),
            Some((_, end)) => (behind, end),
            None if text.get(behind) == Some(&b'=') => (behind, number(text, behind + 1)?.1),
            None if letters > 1 || self.is_of_statements => (behind, behind),
            None => return None,
        };
        let name = &text[at..name_end];
        let is_axis = self.words.iter().any(|axis| axis.name == name || axis.address == name);
        (!is_axis).then_some(end)
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.mistake {
            Mistake::NoWord => write!(f, "no word begins at byte {}", self.offset),
            Mistake::OpenComment => write!(f, "the comment at byte {} has no end", self.offset),
            Mistake::Repeated => write!(f, "the axis word at byte {} stands twice in its block", self.offset),
            Mistake::Missing(axis) => write!(f, "axis number {axis} has no value yet"),
        }
    }
}

impl std::error::Error for ReadError {}

/// What a byte begins, between words.
fn begins(byte: u8, axes: &[AxisAddress], comment: &[u8]) -> Begins {
    let addressed = |axis: &AxisAddress| axis.address.first() == Some(&byte);
    let named = |axis: &AxisAddress| axis.name.first() == Some(&byte);
    let unsure = axes.iter().any(|axis| addressed(axis) && axis.address.len() > 1);
    match axes.iter().position(addressed).map(u8::try_from) {
        _ if byte == b'\n' => Begins::Block,
        _ if matches!(byte, b' ' | b'\t' | b'\r') => Begins::Blank,
        Some(Ok(axis)) if !unsure => Begins::AxisWord(axis),
        None if byte.is_ascii_uppercase() && !axes.iter().any(named) && comment.first() != Some(&byte) => {
            Begins::OtherWord
        }
        _ => Begins::Unsure,
    }
}

/// What stands behind a whole number without a sign, if that is a blank or the end of the block.
#[inline]
fn behind_whole_number(text: &[u8]) -> Option<&[u8]> {
    let digits = text.iter().position(|byte| !byte.is_ascii_digit())?;
    let whole = (1..=Decimal::MOST_DIGITS).contains(&digits) && matches!(text[digits], b' ' | b'\n');
    whole.then(|| &text[digits..])
}

/// Where a comment ends: behind its closing delimiter, or at the end of the line.
fn comment_end(text: &[u8], at: usize, close: &[u8]) -> Option<usize> {
    let line = at + memchr::memchr(b'\n', &text[at..]).unwrap_or(text.len() - at);
    if close.is_empty() {
        return Some(line);
    }
    memchr::memmem::find(&text[at..line], close).map(|found| at + found + close.len())
}

/// The number that begins here (`-12.5`, `25.`, `.5`), and its end.
fn number(text: &[u8], at: usize) -> Option<(f64, usize)> {
    let sign = text.get(at).filter(|byte| matches!(byte, b'-' | b'+'));
    let start = at + usize::from(sign.is_some());
    let decimal = Decimal::leading(&text[start..])?;
    Some((decimal.value(sign == Some(&b'-')), start + decimal.length))
}
