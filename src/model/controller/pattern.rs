//! From the text of a meaning to its pattern: codes, words with holes, calls.

use crate::syntax::tree::{Spanned, TemplatePiece};
use mach_runtime::dialect::pattern::{Argument, Hole, PatternWord};

/// In place of a hole while the text is taken apart: no control reads it.
const MARK: char = '\u{1}';

/// What a placeholder of a pattern stands for.
pub(super) const HOLES: [(&str, Hole); 7] = [
    ("tool", Hole::Tool),
    ("register", Hole::Register),
    ("seconds", Hole::Seconds),
    ("milliseconds", Hole::Milliseconds),
    ("program", Hole::Program),
    ("text", Hole::Text),
    ("any", Hole::Any),
];

/// The words of a pattern; a line may go on in the next one behind a mark.
///
/// # Errors
/// What is wrong with the text, in a few words.
pub(super) fn words(pieces: &[Spanned<TemplatePiece>], continued: Option<&str>) -> Result<Vec<PatternWord>, String> {
    let (mut text, mut holes) = (String::new(), Vec::new());
    for piece in pieces {
        match &piece.value {
            TemplatePiece::Text(plain) => match continued {
                Some(mark) => text += &plain.replace(mark, " "),
                None => text += plain,
            },
            TemplatePiece::Placeholder { name, .. } => {
                let hole = HOLES.iter().find(|(known, _)| known == name).map(|(_, hole)| *hole);
                holes.push(hole.ok_or_else(|| format!("`{{{name}}}` is no hole of a pattern"))?);
                text.push(MARK);
            }
        }
    }
    let (mut rest, mut holes, mut words) = (text.as_str(), holes.into_iter(), Vec::new());
    while let Some(c) = rest.chars().next() {
        if c == ' ' {
            rest = &rest[1..];
            continue;
        }
        let (word, length) =
            word(rest, &mut holes).ok_or_else(|| format!("`{}` begins no word", rest.replace(MARK, "…")))?;
        words.push(word);
        rest = &rest[length..];
    }
    if words.is_empty() { Err("a pattern has a word at least".to_owned()) } else { Ok(words) }
}

/// The word that the text begins with, and its length.
fn word(text: &str, holes: &mut impl Iterator<Item = Hole>) -> Option<(PatternWord, usize)> {
    if text.starts_with(MARK) {
        return Some((PatternWord::Hole { address: String::new(), hole: holes.next()? }, 1));
    }
    if text.strip_prefix('<').is_some_and(|rest| rest.starts_with([MARK]) && rest[1..].starts_with('>')) {
        return Some((PatternWord::Hole { address: "<".to_owned(), hole: holes.next()? }, 3));
    }
    if let Some((thousandths, length)) = thousandths(text) {
        return Some((PatternWord::Number { thousandths }, length));
    }
    let letters = text.bytes().take_while(u8::is_ascii_uppercase).count();
    let digits = text[letters..].bytes().take_while(u8::is_ascii_digit).count();
    let address = if text[letters + digits..].starts_with('=') { letters + digits + 1 } else { letters };
    let (name, behind) = text.split_at(address);
    if letters == 0 {
        return None;
    }
    if letters > 1 && text[letters + digits..].starts_with('(') {
        return call(text, letters + digits, holes);
    }
    if behind.starts_with(MARK) {
        return Some((PatternWord::Hole { address: name.to_owned(), hole: holes.next()? }, address + 1));
    }
    if let Some((thousandths, length)) = thousandths(behind) {
        return Some((PatternWord::Code { address: name.to_owned(), thousandths }, address + length));
    }
    let signed = address + usize::from(behind.starts_with(['+', '-']));
    Some((PatternWord::Name(text[..signed].to_owned()), signed))
}

/// The call of this name, which is so long.
fn call(text: &str, name: usize, holes: &mut impl Iterator<Item = Hole>) -> Option<(PatternWord, usize)> {
    let inside = &text[name + 1..];
    let end = inside.find(')')?;
    let arguments = inside[..end].split(',').map(|argument| self::argument(argument.trim(), holes));
    let arguments = arguments.collect::<Option<_>>()?;
    Some((PatternWord::Call { name: text[..name].to_owned(), arguments }, name + end + 2))
}

fn argument(text: &str, holes: &mut impl Iterator<Item = Hole>) -> Option<Argument> {
    if text == format!("\"{MARK}\"") {
        return holes.next().map(Argument::Text);
    }
    (!text.contains(MARK)).then(|| Argument::Literal(text.to_owned()))
}

/// The number that the text begins with in thousandths, and its length.
fn thousandths(text: &str) -> Option<(i64, usize)> {
    let is_number = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-');
    let length = text.find(|c| !is_number(c)).unwrap_or(text.len());
    let value: f64 = text[..length].parse().ok()?;
    Some(((1000.0 * value).round() as i64, length))
}
