//! Plain blocks, which are nearly all of a program: a number, rapid or line, axis words and a feed, in capitals and without
//! comments. They are read byte by byte, without tokens and claims, into the same block; any other line is left to those.

use super::block::{AxisWord, Block, Code};
use super::token::number;
use crate::dialect::meaning::{Meaning, MotionCode};
use crate::dialect::pattern::{Pattern, PatternWord};
use crate::dialect::table::{BlockKind, Form, Role, Table};
use crate::number::usual_decimal;

/// What the bytes of a plain block begin, by a dialect's table.
#[derive(Debug, Clone)]
pub(super) struct Plain {
    begins: [Begins; 256],
    words: Vec<PlainWord>,
    codes: Vec<PlainCode>,
    /// The address of block numbers.
    sequence: Option<Vec<u8>>,
}

/// What a byte begins, where one word is over.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Begins {
    Blank,
    /// The word with this index among the plain ones.
    Word(u8),
    /// A code, whose number tells which.
    Code,
    /// Something else, or one of several things.
    Unsure,
}

#[derive(Debug, Clone)]
struct PlainWord {
    /// Its index in the table.
    word: usize,
    role: Role,
    /// What stands behind its first byte, before the number.
    rest: Vec<u8>,
    pointless: Option<f64>,
}

#[derive(Debug, Clone, Copy)]
struct PlainCode {
    letter: u8,
    number: u64,
    code: Code,
}

impl Plain {
    /// The plain blocks of a dialect.
    pub(super) fn of(table: &Table) -> Self {
        let mut plain =
            Self { begins: [Begins::Unsure; 256], words: Vec::new(), codes: codes(table), sequence: sequence(table) };
        if table.blocks == BlockKind::Statements {
            return plain;
        }
        for blank in [b' ', b'\t', b'\r'] {
            plain.begins[usize::from(blank)] = Begins::Blank;
        }
        for code in &plain.codes {
            plain.begins[usize::from(code.letter)] = Begins::Code;
        }
        for (index, word) in table.words.iter().enumerate().filter(|(_, word)| is_axis_or_feed(word.role)) {
            let address = word.address.as_bytes();
            let is_alone = table.words.iter().enumerate().all(|(other, it)| {
                let is_same = it.address == word.address && other > index;
                other == index || is_same || it.address.as_bytes().first() != address.first()
            });
            if let Some((&first, rest)) = address.split_first()
                && is_alone
                && !is_used_otherwise(first, table)
            {
                plain.begins[usize::from(first)] = Begins::Word(plain.words.len() as u8);
                let (role, pointless) = (word.role, word.pointless);
                plain.words.push(PlainWord { word: index, role, rest: rest.to_vec(), pointless });
            }
        }
        plain
    }

    /// Reads a line into an empty block; false where it is no plain one, or there is something wrong with it.
    pub(super) fn read(&self, line: &[u8], block: &mut Block) -> bool {
        let mut rest = self.behind_number(line);
        let mut given = 0;
        while let [byte, behind @ ..] = rest {
            let next = match self.begins[usize::from(*byte)] {
                Begins::Blank => Some(behind),
                Begins::Word(index) => self.word(&self.words[usize::from(index)], behind, block, &mut given),
                Begins::Code => self.code(*byte, behind, block),
                Begins::Unsure => None,
            };
            match next {
                Some(next) => rest = next,
                None => return false,
            }
        }
        given != 0 || !block.codes.is_empty()
    }

    /// What stands behind the block's number.
    fn behind_number<'t>(&self, line: &'t [u8]) -> &'t [u8] {
        let Some(behind) = self.sequence.as_ref().and_then(|address| line.strip_prefix(address.as_slice())) else {
            return line;
        };
        match behind.iter().position(|byte| !byte.is_ascii_digit()) {
            Some(0) | None => line,
            Some(digits) => &behind[digits..],
        }
    }

    /// A word; `given` are those that the block has had.
    #[inline]
    fn word<'t>(&self, word: &PlainWord, behind: &'t [u8], block: &mut Block, given: &mut u64) -> Option<&'t [u8]> {
        let behind = behind.strip_prefix(word.rest.as_slice())?;
        let (value, behind) = match usual_decimal(behind).or_else(|| last_decimal(behind)) {
            Some(read) => read,
            None => any_decimal(behind, word.pointless)?,
        };
        let bit = 1 << word.word;
        if *given & bit != 0 {
            return None;
        }
        *given |= bit;
        match word.role {
            Role::Axis(axis) => block.axes.push(AxisWord { axis, word: word.word, number: value, form: None }),
            _ => block.feed = Some(value),
        }
        Some(behind)
    }

    /// A code; a block with two of them is not plain.
    #[inline]
    fn code<'t>(&self, letter: u8, behind: &'t [u8], block: &mut Block) -> Option<&'t [u8]> {
        let digits = behind.iter().take_while(|byte| byte.is_ascii_digit()).count();
        if !(1..=4).contains(&digits) || behind.get(digits) == Some(&b'.') || behind.get(digits) == Some(&b'=') {
            return None;
        }
        let number = behind[..digits].iter().fold(0, |number, digit| 10 * number + u64::from(digit - b'0'));
        let found = self.codes.iter().find(|code| (code.letter, code.number) == (letter, number))?;
        if !block.codes.is_empty() {
            return None;
        }
        block.codes.push(found.code);
        Some(&behind[digits..])
    }
}

/// So much is looked at of a usual number and behind it.
const LAST_BYTES: usize = 12;

/// A usual number with hardly anything behind it.
#[inline]
fn last_decimal(text: &[u8]) -> Option<(f64, &[u8])> {
    let mut padded = [b' '; LAST_BYTES];
    padded.get_mut(..text.len())?.copy_from_slice(text);
    let (value, behind) = usual_decimal(&padded)?;
    Some((value, &text[LAST_BYTES - behind.len()..]))
}

/// A number that is not of the usual kind.
#[cold]
fn any_decimal(text: &[u8], pointless: Option<f64>) -> Option<(f64, &[u8])> {
    let ascii = text.iter().take_while(|byte| byte.is_ascii()).count();
    let (read, length) = number(std::str::from_utf8(&text[..ascii]).ok()?)?;
    let factor = if read.has_point || read.value == 0.0 { 1.0 } else { pointless? };
    Some((factor * read.value, &text[length..]))
}

fn is_axis_or_feed(role: Role) -> bool {
    matches!(role, Role::Axis(_) | Role::Feed)
}

/// Rapid and line, where they are one letter with a whole number.
fn codes(table: &Table) -> Vec<PlainCode> {
    let plain = |(index, pattern): (usize, &Pattern)| match (pattern.words.as_slice(), pattern.meanings.as_slice()) {
        (
            [PatternWord::Code { address, thousandths }],
            [meaning @ Meaning::Motion(MotionCode::Rapid | MotionCode::Line)],
        ) if address.len() == 1 && *thousandths >= 0 && thousandths % 1000 == 0 => {
            let code = Code { meaning: *meaning, pattern: index, number: pattern.number.map(f64::from) };
            let letter = address.as_bytes()[0];
            let number = *thousandths as u64 / 1000;
            (!is_word(letter, table)).then_some(PlainCode { letter, number, code })
        }
        _ => None,
    };
    table.patterns.iter().enumerate().filter_map(plain).collect()
}

/// Whether a word begins with this letter.
fn is_word(letter: u8, table: &Table) -> bool {
    table.words.iter().any(|word| word.address.as_bytes().first() == Some(&letter))
}

/// Block numbers whose address begins nothing else.
fn sequence(table: &Table) -> Option<Vec<u8>> {
    let address = table.sequence.as_ref()?.as_bytes();
    let is_word = address.first().is_some_and(|first| is_word(*first, table));
    (!is_word).then(|| address.to_vec())
}

/// Whether a pattern that needs none but plain words claims words that begin with this letter, or a form does.
fn is_used_otherwise(letter: u8, table: &Table) -> bool {
    let begins = |address: &str| address.as_bytes().first() == Some(&letter);
    let is_claimed = table.patterns.iter().any(|pattern| {
        let is_plain = |word: &PatternWord| match word {
            PatternWord::Code { address, .. } | PatternWord::Hole { address, .. } => {
                table.words.iter().any(|word| word.address == *address)
            }
            _ => false,
        };
        let claims = |word: &PatternWord| match word {
            PatternWord::Code { address, .. } | PatternWord::Hole { address, .. } => begins(address),
            _ => false,
        };
        pattern.words.iter().any(claims) && pattern.words.iter().all(is_plain)
    });
    let is_formed = |form: &Form| begins(&form.before) || (form.before.is_empty() && form.between.is_empty());
    is_claimed || begins(&table.comment.0) || table.forms.iter().any(is_formed)
}
