//! What stands where the grammar did not go on.

use crate::syntax::tree::Span;

/// What stands at a place.
#[derive(Clone)]
pub(super) struct Found<'t> {
    pub(super) span: Span,
    pub(super) description: String,
    pub(super) word: Option<&'t str>,
}

impl<'t> Found<'t> {
    pub(super) fn at(text: &'t str, at: usize) -> Self {
        let rest = &text[at..];
        let is_in_word = |c: char| c.is_alphanumeric() || c == '_';
        let Some(first) = rest.chars().next() else {
            let end = text.trim_end().len();
            return Self { span: end..end, description: "the end of the file".to_owned(), word: None };
        };
        let length = match first {
            c if is_in_word(c) => rest.find(|c| !is_in_word(c)).unwrap_or(rest.len()),
            c => c.len_utf8(),
        };
        let found = &rest[..length];
        let word = (is_in_word(first) && !first.is_numeric()).then_some(found);
        Self { span: at..at + length, description: describe_found(found), word }
    }

    /// What is missing at the end of a line is told there, not at the next line's beginning.
    pub(super) fn or_line_end(&self, text: &'t str, start: usize) -> Self {
        let before = text[start..self.span.start].trim_end();
        let end = start + before.len();
        let last_line = before.rfind('\n').map_or(before, |newline| &before[newline..]);
        let is_next_line = text[end..self.span.start].contains('\n') && !last_line.contains("//");
        match is_next_line {
            true => Self { span: end..end, description: END_OF_LINE.to_owned(), word: None },
            false => self.clone(),
        }
    }
}

fn describe_found(found: &str) -> String {
    match found {
        "\n" | "\r" => END_OF_LINE.to_owned(),
        long if long.chars().count() > 40 => format!("`{}…`", long.chars().take(40).collect::<String>()),
        short => format!("`{short}`"),
    }
}

const END_OF_LINE: &str = "the end of the line";
