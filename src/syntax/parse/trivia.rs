//! Comments and blank lines, handed to the statements they belong to.

use crate::syntax::tree::{Comment, Span};

/// The comments of a text, taken in order.
pub(super) struct Comments<'t> {
    text: &'t str,
    spans: std::iter::Peekable<std::vec::IntoIter<Span>>,
    /// The end of what was seen last.
    seen: usize,
}

impl<'t> Comments<'t> {
    pub(super) fn new(text: &'t str, spans: Vec<Span>) -> Self {
        Self { text, spans: spans.into_iter().peekable(), seen: 0 }
    }

    /// The comments that start before `end`.
    pub(super) fn until(&mut self, end: usize) -> Vec<Comment> {
        let mut comments = Vec::new();
        while let Some(span) = self.spans.next_if(|span| span.start < end) {
            let blank_before = self.blank_line_until(span.start);
            comments.push(Comment { text: self.content(&span), blank_before });
            self.seen = span.end;
        }
        comments
    }

    /// The comments inside a statement that ends at `end`.
    pub(super) fn inside(&mut self, end: usize) -> Vec<Comment> {
        let mut comments = self.until(end);
        comments.iter_mut().for_each(|comment| comment.blank_before = false);
        self.pass(end);
        comments
    }

    /// The comment on the same line as `end`, with nothing but blanks between them.
    pub(super) fn behind(&mut self, end: usize) -> Option<String> {
        let span = self
            .spans
            .next_if(|span| span.start >= end && self.text[end..span.start].chars().all(|c| matches!(c, ' ' | '\t')))?;
        self.seen = span.end;
        Some(self.content(&span))
    }

    /// Everything up to `end` has been seen.
    pub(super) fn pass(&mut self, end: usize) {
        self.seen = self.seen.max(end);
    }

    /// Whether a blank line stands between what was seen last and `start`. There is none before the first thing.
    pub(super) fn blank_line_until(&self, start: usize) -> bool {
        let seen = self.seen.min(start);
        seen > 0 && self.text[seen..start].matches('\n').count() > 1
    }

    /// Whether there is no line break between two places.
    pub(super) fn is_one_line(&self, start: usize, end: usize) -> bool {
        !self.text[start..end].contains('\n')
    }

    fn content(&self, span: &Span) -> String {
        let text = self.text[span.start + "//".len()..span.end].trim_end();
        text.strip_prefix(' ').unwrap_or(text).to_owned()
    }
}
