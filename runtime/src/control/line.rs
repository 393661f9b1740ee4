//! A line without its number, its comments and its block skip.

use super::Fault;
use super::mistake::Mistake;
use crate::dialect::table::{BlockKind, Table};

/// What is left of a line.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stripped {
    /// Comments are blanks, so that places in it are places in the line.
    pub(super) text: String,
    /// Where it begins in the line, in bytes.
    pub(super) at: usize,
}

/// The block of a line.
///
/// # Errors
/// A comment that is not closed.
pub(super) fn block(line: &str, table: &Table) -> Result<Stripped, Fault> {
    let text = without_comments(line, table)?;
    let mut at = text.len() - text.trim_start().len();
    // The tape's mark, which is a block of its own.
    if table.blocks == BlockKind::Words && text[at..].starts_with('%') {
        at = text.len();
    }
    if text[at..].starts_with('/') {
        at += 1 + text[at + 1..].bytes().take_while(u8::is_ascii_digit).count();
    }
    at += number_length(&text[at..], table);
    Ok(Stripped { text: text[at..].to_owned(), at })
}

/// How long the number of the block is.
fn number_length(text: &str, table: &Table) -> usize {
    let Some(address) = &table.sequence else { return 0 };
    let blanks = text.len() - text.trim_start().len();
    let is_named = text[blanks..].get(..address.len()).is_some_and(|start| start.eq_ignore_ascii_case(address));
    let digits =
        if is_named { text[blanks + address.len()..].bytes().take_while(u8::is_ascii_digit).count() } else { 0 };
    let length = blanks + address.len() + digits;
    // A number without an address stands alone.
    let is_alone =
        !address.is_empty() || text[length..].starts_with(|c: char| c.is_ascii_whitespace()) || text.len() == length;
    if digits == 0 || !is_alone { 0 } else { length }
}

/// The line with blanks in place of its comments.
fn without_comments(line: &str, table: &Table) -> Result<String, Fault> {
    let (open, close) = &table.comment;
    let mut text = line.to_owned();
    let mut from = 0;
    while let Some(start) = comment_start(&text[from..], open) {
        let start = from + start;
        let behind = start + open.len();
        let end = if close.is_empty() {
            text.len()
        } else {
            behind + text[behind..].find(close.as_str()).ok_or((Mistake::OpenComment, start..line.len()))? + close.len()
        };
        text.replace_range(start..end, &" ".repeat(end - start));
        from = end;
    }
    Ok(text)
}

/// Where a comment begins, not in quotes.
fn comment_start(text: &str, open: &str) -> Option<usize> {
    let mut is_quoted = false;
    text.char_indices().find_map(|(at, c)| {
        is_quoted ^= c == '"';
        // An open parenthesis behind a letter belongs to a call.
        let is_call = open == "(" && text[..at].ends_with(|c: char| c.is_ascii_alphabetic());
        (!open.is_empty() && !is_quoted && !is_call && text[at..].starts_with(open)).then_some(at)
    })
}
