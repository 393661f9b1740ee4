//! A block understood: its codes with their numbers, and its words.

use super::claim::{Claim, claims};
use super::mistake::Mistake;
use super::token::{Kind, Number, Token, tokens};
use crate::dialect::meaning::{Meaning, Once};
use crate::dialect::pattern::Hole;
use crate::dialect::table::{BlockKind, FormMeaning, Role, Table};
use std::ops::Range;

/// A block understood.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Block {
    /// Its codes.
    pub codes: Vec<Code>,
    /// Where the axes are sent.
    pub axes: Vec<AxisWord>,
    /// The words of an arc's centre, along X, Y, Z.
    pub centre: [Option<f64>; 3],
    /// The radius of an arc.
    pub radius: Option<f64>,
    /// The feed word.
    pub feed: Option<f64>,
    /// The spindle's speed.
    pub speed: Option<f64>,
    /// The tool's number.
    pub tool: Option<f64>,
}

/// A code, and the number of the hole that it has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Code {
    /// What it means.
    pub meaning: Meaning,
    /// Its index among the table's patterns.
    pub pattern: usize,
    /// The number of a tool, a register, an offset, a time in seconds.
    pub number: Option<f64>,
}

/// An axis word. Its number is as it is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisWord {
    /// The axis.
    pub axis: usize,
    /// Its index among the table's words.
    pub word: usize,
    /// The number.
    pub number: f64,
    /// How the number is meant, if the word says so.
    pub form: Option<FormMeaning>,
}

impl Block {
    /// Takes everything out of it.
    pub(super) fn clear(&mut self) {
        let Self { codes, axes, .. } = std::mem::take(self);
        *self = Self { codes, axes, ..Self::default() };
        self.codes.clear();
        self.axes.clear();
    }

    /// The block of a text in capitals, without number and comments.
    ///
    /// # Errors
    /// What is wrong with it, and where.
    pub(super) fn read(text: &str, table: &Table, order: &[usize]) -> Result<Self, (Mistake, Range<usize>)> {
        let tokens = tokens(text, table)?;
        let (claims, taken) = claims(&tokens, table, order);
        if let (BlockKind::Statements, [first, ..], [None, ..]) = (table.blocks, &tokens[..], &taken[..]) {
            // What a statement is, its first word says.
            return Err((Mistake::Unknown(text[first.span.clone()].to_owned()), first.span.clone()));
        }
        let codes = claims.iter().flat_map(|claim| Code::of(claim, table)).collect();
        let mut block = Self { codes, ..Self::default() };
        for (token, taken) in tokens.iter().zip(taken) {
            if taken.is_none() {
                block.word(token, text, table).map_err(|mistake| (mistake, token.span.clone()))?;
            }
        }
        block.refuse_two_of_a_group().map_err(|mistake| (mistake, 0..text.len()))?;
        Ok(block)
    }

    /// Whether a code with this meaning is in the block.
    pub fn has(&self, meaning: Meaning) -> bool {
        self.codes.iter().any(|code| code.meaning == meaning)
    }

    /// The code of something that happens once.
    pub(super) fn once(&self, once: Once) -> Option<&Code> {
        self.codes.iter().find(|code| code.meaning == Meaning::Once(once))
    }

    /// A word with a number of its own.
    fn word(&mut self, token: &Token<'_>, text: &str, table: &Table) -> Result<(), Mistake> {
        let written = || text[token.span.clone()].to_owned();
        let unknown = || Mistake::Unknown(written());
        let Kind::Word { address, number, form } = &token.kind else { return Err(unknown()) };
        let plain = address.trim_end_matches('=');
        let is_it = |declared: &str| declared == *address || declared == plain;
        let index = table.words.iter().position(|word| is_it(&word.address)).ok_or_else(unknown)?;
        let word = &table.words[index];
        let value = value(*number, word.pointless).ok_or_else(|| Mistake::Pointless(written()))?;
        let form = form.map(|form| table.forms[form].meaning);
        let place = match word.role {
            Role::Axis(axis) if self.axes.iter().any(|word| word.axis == axis) => {
                return Err(Mistake::Repeated(written()));
            }
            Role::Axis(axis) => {
                self.axes.push(AxisWord { axis, word: index, number: value, form });
                return Ok(());
            }
            Role::Centre(along) => &mut self.centre[along],
            Role::Radius => &mut self.radius,
            Role::Feed => &mut self.feed,
            Role::Speed => &mut self.speed,
            Role::Tool => &mut self.tool,
        };
        place.replace(value).map_or(Ok(()), |_| Err(Mistake::Repeated(written())))
    }

    fn refuse_two_of_a_group(&self) -> Result<(), Mistake> {
        for (index, code) in self.codes.iter().enumerate() {
            let excludes = |other: &&Code| other.meaning.excludes(code.meaning);
            if let Some(other) = self.codes[..index].iter().find(excludes) {
                return Err(Mistake::TwoOfAGroup(other.meaning, code.meaning));
            }
        }
        Ok(())
    }
}

impl Code {
    /// The codes of a claim: one for each meaning of its pattern.
    fn of(claim: &Claim, table: &Table) -> Vec<Self> {
        let pattern = &table.patterns[claim.pattern];
        let number = claim.holes.iter().find_map(|(hole, value)| match hole {
            Hole::Milliseconds => Some(value / 1000.0),
            Hole::Tool | Hole::Register | Hole::Seconds => Some(*value),
            Hole::Program | Hole::Text | Hole::Any => None,
        });
        let number = number.or(pattern.number.map(f64::from));
        let code = |&meaning| Self { meaning, pattern: claim.pattern, number };
        pattern.meanings.iter().map(code).collect()
    }
}

/// The value of a number, without a point as the dialect takes it.
fn value(number: Number, pointless: Option<f64>) -> Option<f64> {
    match (number.has_point, number.value == 0.0) {
        (true, _) | (_, true) => Some(number.value),
        (false, false) => pointless.map(|factor| factor * number.value),
    }
}
