//! A block cut into tokens: words with numbers, names, calls.

use super::mistake::Mistake;
use crate::dialect::pattern::{Hole, Pattern, PatternWord};
use crate::dialect::table::{BlockKind, Role, Table};
use crate::number::Decimal;
use std::ops::Range;

/// A piece of a block.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Token<'t> {
    /// Where it stands, in bytes of the line.
    pub(super) span: Range<usize>,
    pub(super) kind: Kind<'t>,
}

/// What a token is.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Kind<'t> {
    /// An address and its number: `X10.`, `CR=5`; with the index of the form that it is written in, if it has one.
    Word { address: &'t str, number: Number, form: Option<usize> },
    /// A number alone.
    Number(Number),
    /// Letters alone: `SUPA`, `FMAX`, `DR+`; or a name in angle brackets: `<FACING>`.
    Name(&'t str),
    /// Letters and what stands in parentheses behind them.
    Call { name: &'t str, arguments: &'t str },
    /// Text in quotes.
    Text(&'t str),
}

/// A number as it is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Number {
    pub(super) value: f64,
    pub(super) has_point: bool,
}

impl Number {
    /// In thousandths, if it is a whole number of them.
    pub(super) fn thousandths(self) -> Option<i64> {
        let thousandths = 1000.0 * self.value;
        let is_whole = thousandths == thousandths.round() && thousandths.abs() < 1e15;
        is_whole.then_some(thousandths as i64)
    }
}

/// The tokens of a block, in capitals and without comments.
///
/// # Errors
/// What stands there that is none, and where.
pub(super) fn tokens<'t>(block: &'t str, table: &Table) -> Result<Vec<Token<'t>>, (Mistake, Range<usize>)> {
    let mut tokens: Vec<Token<'t>> = program_name(block, table).into_iter().collect();
    let mut at = tokens.last().map_or(0, |name| name.span.end);
    while let Some(byte) = block.as_bytes().get(at) {
        if byte.is_ascii_whitespace() {
            at += 1;
            continue;
        }
        let found = match table.blocks {
            BlockKind::Words => token(&block[at..], table),
            BlockKind::Statements => statement_token(&block[at..], table),
        };
        let (kind, length) = found.ok_or((Mistake::NoWord, at..at + 1))?;
        tokens.push(Token { span: at..at + length, kind });
        at += length;
    }
    Ok(tokens)
}

/// A block that is nothing but the name of a program behind its address: `OPART1_SETUP_3`.
fn program_name<'t>(block: &'t str, table: &Table) -> Option<Token<'t>> {
    let text = block.trim();
    let is_name = |pattern: &Pattern| match pattern.words.as_slice() {
        [PatternWord::Hole { address, hole: Hole::Program }] if !address.is_empty() => {
            let name = text.strip_prefix(address.as_str()).unwrap_or_default();
            name.starts_with(|c: char| !c.is_ascii_digit())
                && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')
        }
        _ => false,
    };
    let start = block.len() - block.trim_start().len();
    let token = || Token { span: start..start + text.len(), kind: Kind::Name(text) };
    table.patterns.iter().any(is_name).then(token)
}

/// The token that the text begins with, and its length.
fn token<'t>(text: &'t str, table: &Table) -> Option<(Kind<'t>, usize)> {
    if let Some(found) = formed(text, table) {
        return Some(found);
    }
    if let Some((number, length)) = number(text) {
        return Some((Kind::Number(number), length));
    }
    if let Some(quoted) = text.strip_prefix('"') {
        let end = quoted.find('"')?;
        return Some((Kind::Text(&quoted[..end]), end + 2));
    }
    if text.starts_with('<') {
        let end = 1 + text.find('>')?;
        return Some((Kind::Name(&text[..end]), end));
    }
    let letters = text.bytes().take_while(|byte| byte.is_ascii_alphabetic() || *byte == b'_').count();
    if letters == 0 {
        return None;
    }
    call(text, letters).or_else(|| addressed(text, letters, table)).or_else(|| Some(named(text, letters)))
}

/// The token of a statement that the text begins with: all that stands before the next blank, or a text in quotes.
fn statement_token<'t>(text: &'t str, table: &Table) -> Option<(Kind<'t>, usize)> {
    if text.starts_with('"') {
        return token(text, table);
    }
    let length = text.find(|c: char| c.is_ascii_whitespace()).unwrap_or(text.len());
    let word = &text[..length];
    let is_whole = |(_, its): &(Kind<'t>, usize)| *its == length;
    let found = token(word, table).filter(is_whole).map_or(Kind::Name(word), |(kind, _)| kind);
    Some((found, length))
}

/// Letters, perhaps with digits behind them, and what stands in parentheses.
fn call(text: &str, letters: usize) -> Option<(Kind<'_>, usize)> {
    let digits = text[letters..].bytes().take_while(u8::is_ascii_digit).count();
    let name = letters + if letters > 1 { digits } else { 0 };
    let inside = text[name..].strip_prefix('(')?;
    let end = closing(inside)?;
    Some((Kind::Call { name: &text[..name], arguments: &inside[..end] }, name + end + 2))
}

/// An axis word in another form: `X=IC(10)`, `IX+10`.
fn formed<'t>(text: &'t str, table: &Table) -> Option<(Kind<'t>, usize)> {
    table.forms.iter().enumerate().find_map(|(index, form)| {
        let name = text.strip_prefix(form.before.as_str())?;
        let letters = name.bytes().take_while(u8::is_ascii_alphanumeric).count();
        // The shortest name that leaves a number behind it.
        (1..=letters).find_map(|length| {
            let (number, digits) = number(name[length..].strip_prefix(form.between.as_str())?)?;
            let is_axis = table.words.iter().any(|word| {
                matches!(word.role, Role::Axis(_)) && word.address.trim_end_matches('=') == &name[..length]
            });
            let behind = length + form.between.len() + digits;
            let is_closed = name[behind..].starts_with(form.behind.as_str());
            let word = Kind::Word { address: &name[..length], number, form: Some(index) };
            (is_axis && is_closed).then_some((word, form.before.len() + behind + form.behind.len()))
        })
    })
}

/// A word of an address and a number.
fn addressed<'t>(text: &'t str, letters: usize, table: &Table) -> Option<(Kind<'t>, usize)> {
    let digits = text[letters..].bytes().take_while(u8::is_ascii_digit).count();
    let with_digits = letters + digits;
    let (address, gap) = if text[with_digits..].starts_with('=') {
        (with_digits + 1, 0)
    } else if letters == 1 && table.blocks == BlockKind::Words {
        (1, text[1..].bytes().take_while(u8::is_ascii_whitespace).count())
    } else {
        (letters, 0)
    };
    let (number, length) = number(&text[address + gap..])?;
    Some((Kind::Word { address: &text[..address], number, form: None }, address + gap + length))
}

/// A name, with its sign.
fn named(text: &str, letters: usize) -> (Kind<'_>, usize) {
    let signed = letters + usize::from(text[letters..].starts_with(['+', '-']));
    (Kind::Name(&text[..signed]), signed)
}

/// Where the parenthesis closes that is open in front of the text.
fn closing(text: &str) -> Option<usize> {
    let (mut depth, mut is_quoted) = (0, false);
    text.bytes().position(|byte| {
        match byte {
            b'"' => is_quoted = !is_quoted,
            b'(' if !is_quoted => depth += 1,
            b')' if !is_quoted => depth -= 1,
            _ => {}
        }
        depth < 0
    })
}

/// The number that the text begins with, and its length.
pub(super) fn number(text: &str) -> Option<(Number, usize)> {
    let sign = text.starts_with(['+', '-']);
    let digits = &text.as_bytes()[usize::from(sign)..];
    let decimal = Decimal::leading(digits)?;
    let has_point = digits[..decimal.length].contains(&b'.');
    let value = decimal.value(text.starts_with('-'));
    Some((Number { value, has_point }, usize::from(sign) + decimal.length))
}
