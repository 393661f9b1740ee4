//! The words of a piece of text, whatever it is.

use crate::syntax::tree::Span;

/// A word.
pub(super) struct Word<'t> {
    pub(super) text: &'t str,
    /// Whether it stands in a block.
    pub(super) is_inside: bool,
    /// Whether it is the first of its line.
    pub(super) begins_line: bool,
}

/// The words of a part of a text, without those of its comments and quoted texts. A brace without a partner opens no block.
pub(super) fn words<'t>(text: &'t str, part: &Span, unpaired: &[usize]) -> Vec<Word<'t>> {
    let mut words = Vec::new();
    let (mut at, mut depth, mut begins_line) = (part.start, 0_usize, true);
    while let Some(first) = text[at..part.end].chars().next() {
        let rest = &text[at..part.end];
        let is_in_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let length = match first {
            '"' => rest[1..].find(['"', '\n']).map_or(rest.len(), |end| end + 2),
            '/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            c if is_in_word(c) => rest.find(|c| !is_in_word(c)).unwrap_or(rest.len()),
            c => c.len_utf8(),
        };
        match first {
            '{' if !unpaired.contains(&at) => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            c if is_in_word(c) => words.push(Word { text: &rest[..length], is_inside: depth > 0, begins_line }),
            _ => {}
        }
        begins_line = first == '\n' || begins_line && first.is_whitespace();
        at += length;
    }
    words
}
