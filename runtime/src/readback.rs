//! Read-back: the printed text, read as a control would read it, back into joint values.
//!
//! Nothing here knows what the writer meant to print. Words may stand without blanks between them; an axis word keeps
//! its value until it is given again. What is read is the text of motions: blocks that send an axis elsewhere for once
//! (`G53 Z0.`) are not for this reader, and the writer prints every axis after them.

use crate::decimal::Decimal;
use crate::machine::{Axis, Motion};
use crate::nc::dialect::{Dialect, LengthUnit};
use std::fmt;

/// Reads the motions of one program.
#[derive(Debug)]
pub struct ReadBack {
    axes: Vec<ReadAxis>,
    /// For each byte, the axis whose address is that one letter.
    by_letter: [Option<u8>; 256],
    /// For each byte, whether an axis has that one letter as its name or address.
    named_by_letter: [bool; 256],
    /// The axes with longer addresses, the longest first.
    by_address: Vec<usize>,
    comment: (Vec<u8>, Vec<u8>),
}

/// An axis' word, and what it was last.
#[derive(Debug)]
struct ReadAxis {
    address: Vec<u8>,
    name: Vec<u8>,
    /// Millimetres or degrees in the word's unit.
    scale: f64,
    zero: f64,
    length_share: f64,
    written: Option<f64>,
}

/// Text that is no block of the dialect.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReadError {
    /// Where, in bytes from the start of the text.
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
    /// A reader at the start of a program. `axes` are the machine's, in the order of the dialect's axis words.
    pub fn new(dialect: &Dialect, axes: &[Axis]) -> Self {
        assert_eq!(dialect.axes.len(), axes.len(), "a dialect has one word for each axis of its machine");
        let words = dialect.axes.iter().zip(axes);
        let axes: Vec<ReadAxis> = words
            .map(|(word, axis)| ReadAxis {
                address: word.address.clone().into_bytes(),
                name: word.name.clone().into_bytes(),
                scale: millimetres_or_degrees(axis.motion, dialect.units),
                zero: axis.zero,
                length_share: axis.length_share,
                written: None,
            })
            .collect();
        let mut named_by_letter = [false; 256];
        for name in axes.iter().flat_map(|axis| [&axis.name, &axis.address]).filter(|name| name.len() == 1) {
            named_by_letter[usize::from(name[0])] = true;
        }
        let mut by_letter = [None; 256];
        for (index, axis) in axes.iter().enumerate().filter(|(_, axis)| axis.address.len() == 1) {
            by_letter[usize::from(axis.address[0])] = u8::try_from(index).ok();
        }
        let mut by_address: Vec<usize> = (0..axes.len()).filter(|&index| axes[index].address.len() > 1).collect();
        by_address.sort_by_key(|&index| std::cmp::Reverse(axes[index].address.len()));
        let (open, close) = &dialect.comment;
        let comment = (open.clone().into_bytes(), close.clone().into_bytes());
        Self { axes, by_letter, named_by_letter, by_address, comment }
    }

    /// Reads the blocks of a motion (none of them, when nothing had to be printed), and gives the joints they leave
    /// the machine at: machine coordinates in mm and degrees, in the machine's order. Says how many blocks there were.
    ///
    /// # Errors
    /// When the text is not made of words, or an axis has never been given.
    pub fn read(&mut self, text: &[u8], tool_length_mm: f64, joints: &mut [f64]) -> Result<u64, ReadError> {
        let mut blocks = 0;
        let mut given = 0_u64;
        let mut at = 0;
        while let Some(byte) = text.get(at) {
            at = match byte {
                b'\n' => {
                    given = 0;
                    blocks += 1;
                    at + 1
                }
                b' ' | b'\t' | b'\r' => at + 1,
                _ => self.word(text, at, &mut given).map_err(|mistake| ReadError { offset: at, mistake })?,
            };
        }
        for (index, (axis, joint)) in self.axes.iter().zip(joints).enumerate() {
            let missing = ReadError { offset: text.len(), mistake: Mistake::Missing(index) };
            let written = axis.written.ok_or(missing)?;
            *joint = written * axis.scale + axis.zero + axis.length_share * tool_length_mm;
        }
        Ok(blocks)
    }

    /// Reads one word, and says where it ends.
    fn word(&mut self, text: &[u8], at: usize, given: &mut u64) -> Result<usize, Mistake> {
        if let Some((axis, value, end)) = self.axis_word(text, at) {
            if *given & (1 << axis) != 0 {
                return Err(Mistake::Repeated);
            }
            *given |= 1 << axis;
            self.axes[axis].written = Some(value);
            return Ok(end);
        }
        if self.comment.0.first() == Some(&text[at]) && text[at..].starts_with(&self.comment.0) {
            return comment_end(text, at + self.comment.0.len(), &self.comment.1).ok_or(Mistake::OpenComment);
        }
        self.other_word(text, at).ok_or(Mistake::NoWord)
    }

    /// An axis, its number, and the end of its word.
    #[inline]
    fn axis_word(&self, text: &[u8], at: usize) -> Option<(usize, f64, usize)> {
        let (axis, address_end) = self.address(text, at)?;
        let (value, end) = number(text, address_end)?;
        Some((axis, value, end))
    }

    /// The axis whose address stands here, and the end of the address.
    #[inline]
    fn address(&self, text: &[u8], at: usize) -> Option<(usize, usize)> {
        let long = self.by_address.iter().map(|&axis| (axis, &self.axes[axis].address));
        for (axis, address) in long {
            if text[at..].starts_with(address) {
                return Some((axis, at + address.len()));
            }
        }
        self.by_letter[usize::from(text[at])].map(|axis| (usize::from(axis), at + 1))
    }

    /// The end of a word that moves nothing: `G1`, `F500.`, `S1=3000`, `SUPA`; none for anything else, and none for a
    /// word that looks like an axis' but is not written the dialect's way.
    fn other_word(&self, text: &[u8], at: usize) -> Option<usize> {
        let letters = text[at..].iter().take_while(|byte| byte.is_ascii_uppercase()).count();
        if letters == 0 {
            return None;
        }
        let behind = at + letters;
        let (name_end, end) = match number(text, behind) {
            Some((_, end)) if text.get(end) == Some(&b'=') => (end, number(text, end + 1)?.1),
            Some((_, end)) => (behind, end),
            None if text.get(behind) == Some(&b'=') => (behind, number(text, behind + 1)?.1),
            None if letters > 1 => (behind, behind),
            None => return None,
        };
        let is_axis = match &text[at..name_end] {
            [letter] => self.named_by_letter[usize::from(*letter)],
            name => self.axes.iter().any(|axis| axis.name == name || axis.address == name),
        };
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

/// What a word's unit is in millimetres or degrees.
fn millimetres_or_degrees(motion: Motion, units: LengthUnit) -> f64 {
    match (motion, units) {
        (Motion::Linear, LengthUnit::Inch) => 25.4,
        _ => 1.0,
    }
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
#[inline]
fn number(text: &[u8], at: usize) -> Option<(f64, usize)> {
    let sign = text.get(at).filter(|byte| matches!(byte, b'-' | b'+'));
    let start = at + usize::from(sign.is_some());
    let decimal = Decimal::leading(&text[start..])?;
    Some((decimal.value(sign == Some(&b'-')), start + decimal.length))
}
