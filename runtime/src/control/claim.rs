//! Which meaning takes which tokens: each token is taken once, by the pattern that asks for most.

use super::token::{Kind, Number, Token};
use crate::dialect::meaning::Meaning;
use crate::dialect::pattern::{Argument, Hole, Pattern, PatternWord};
use crate::dialect::table::{BlockKind, Table};

/// Holes and their numbers.
type Filled = Vec<(Hole, f64)>;

/// A pattern that a block has.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Claim {
    /// Its index in the table.
    pub(super) pattern: usize,
    /// The numbers of its holes.
    pub(super) holes: Filled,
}

/// The patterns in the order in which they are looked for: those that ask for most first, and of these those with the fewest
/// holes.
pub(super) fn order(table: &Table) -> Vec<usize> {
    let mut order: Vec<usize> = (0..table.patterns.len()).collect();
    order.sort_by_key(|&index| {
        let words = &table.patterns[index].words;
        let holes = words.iter().filter(|word| !is_literal(word)).count();
        (std::cmp::Reverse(words.len()), holes)
    });
    order
}

fn is_literal(word: &PatternWord) -> bool {
    matches!(word, PatternWord::Code { .. } | PatternWord::Name(_) | PatternWord::Number { .. })
}

/// The claims on the tokens of a block, and for each token the claim that has it.
pub(super) fn claims(tokens: &[Token<'_>], table: &Table, order: &[usize]) -> (Vec<Claim>, Vec<Option<usize>>) {
    let (mut claims, mut taken) = (Vec::new(), vec![None; tokens.len()]);
    for &pattern in order {
        let pattern_words = &table.patterns[pattern];
        let found = match table.blocks {
            BlockKind::Words => matched(pattern_words, tokens, &taken),
            BlockKind::Statements => stated(pattern_words, tokens, &taken),
        };
        if let Some((holes, its)) = found {
            its.into_iter().for_each(|token| taken[token] = Some(claims.len()));
            claims.push(Claim { pattern, holes });
        }
    }
    (claims, taken)
}

/// The holes of a pattern and the tokens it takes, if the block has all that it asks for.
fn matched(pattern: &Pattern, tokens: &[Token<'_>], taken: &[Option<usize>]) -> Option<(Filled, Vec<usize>)> {
    let (mut holes, mut its) = (Vec::new(), Vec::new());
    for word in &pattern.words {
        let free = |token: &usize| taken[*token].is_none() && !its.contains(token);
        let found = (0..tokens.len()).filter(free).find_map(|token| {
            let hole = fits(word, &tokens[token].kind)?;
            Some((token, hole))
        });
        match found {
            Some((token, hole)) => {
                its.push(token);
                holes.extend(hole);
            }
            None => return None,
        }
    }
    (!its.is_empty()).then_some((holes, its))
}

/// The same in a statement: the words stand in their order. A text of several words, and every motion, begins the block; one
/// of one word may stand anywhere in it.
fn stated(pattern: &Pattern, tokens: &[Token<'_>], taken: &[Option<usize>]) -> Option<(Filled, Vec<usize>)> {
    let is_motion = pattern.meanings.iter().any(|meaning| matches!(meaning, Meaning::Motion(_)));
    let begins = is_motion || pattern.words.len() > 1;
    let (mut holes, mut its) = (Vec::new(), Vec::new());
    for word in &pattern.words {
        let from = its.last().map_or(0, |last| last + 1);
        let to = if begins && its.is_empty() { tokens.len().min(1) } else { tokens.len() };
        let mut free = (from..to).filter(|token| taken[*token].is_none());
        let (token, hole) = free.find_map(|token| Some((token, fits_statement(word, &tokens[token].kind)?)))?;
        its.push(token);
        holes.extend(hole);
    }
    (!its.is_empty()).then_some((holes, its))
}

/// As [`fits`]; the name of a program is whatever stands there.
fn fits_statement(word: &PatternWord, token: &Kind<'_>) -> Option<Option<(Hole, f64)>> {
    match word {
        PatternWord::Hole { address, hole: Hole::Program } if address.is_empty() => Some(None),
        _ => fits(word, token),
    }
}

/// The hole's number where the token is what the word asks for.
fn fits(word: &PatternWord, token: &Kind<'_>) -> Option<Option<(Hole, f64)>> {
    match (word, token) {
        (PatternWord::Code { address, thousandths }, Kind::Word { address: found, number, form: None }) => {
            (address == found && number.thousandths() == Some(*thousandths)).then_some(None)
        }
        (PatternWord::Hole { address, hole }, Kind::Word { address: found, number, form: None }) => {
            (address == found).then(|| hole_value(*hole, *number)).flatten().map(Some)
        }
        (PatternWord::Hole { address, hole }, Kind::Number(number)) if address.is_empty() => {
            hole_value(*hole, *number).map(Some)
        }
        (PatternWord::Number { thousandths }, Kind::Number(number)) => {
            (number.thousandths() == Some(*thousandths)).then_some(None)
        }
        (PatternWord::Name(name), Kind::Name(found)) => (name == found).then_some(None),
        // The name of a program behind its address: `OFACING`, `<FACING>`.
        (PatternWord::Hole { address, hole: Hole::Program }, Kind::Name(found)) => {
            found.starts_with(address.as_str()).then_some(None)
        }
        (PatternWord::Call { name, arguments }, Kind::Call { name: found, arguments: given }) => {
            (name == found && are_arguments(arguments, given)).then_some(None)
        }
        _ => None,
    }
}

/// The number of a hole; that of a tool or a register is whole.
fn hole_value(hole: Hole, Number { value, .. }: Number) -> Option<(Hole, f64)> {
    let is_whole = !matches!(hole, Hole::Tool | Hole::Register) || value.fract() == 0.0 && value >= 0.0;
    is_whole.then_some((hole, value))
}

/// Whether what stands in the parentheses is what the pattern has there.
fn are_arguments(arguments: &[Argument], given: &str) -> bool {
    let given = split(given);
    arguments.len() == given.len() && arguments.iter().zip(given).all(|(argument, given)| is_argument(argument, given))
}

fn is_argument(argument: &Argument, given: &str) -> bool {
    let number = |text: &str| super::token::number(text).filter(|(_, length)| *length == text.len());
    match argument {
        Argument::Literal(text) => {
            text == given || matches!((number(text), number(given)), (Some((a, _)), Some((b, _))) if a.value == b.value)
        }
        Argument::Text(_) => given.len() >= 2 && given.starts_with('"') && given.ends_with('"'),
    }
}

/// The arguments between commas that stand in no quotes.
fn split(given: &str) -> Vec<&str> {
    let mut is_quoted = false;
    given
        .split(|c| {
            is_quoted ^= c == '"';
            c == ',' && !is_quoted
        })
        .map(str::trim)
        .collect()
}
