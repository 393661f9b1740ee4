//! What no statement takes: it is told once, and recorded by its words.

use super::Builder;
use super::expected::statements;
use super::failure::Failure;
use super::grammar::{self, Pair, Rule};
use super::words::{Word, words};
use crate::syntax::spelling::nearest;
use crate::syntax::tree::{Body, Broken, Span};

impl<'t> Builder<'_, 't> {
    /// Records what `rule` does not take. It is told, unless the statement before it is to blame, or what is broken `next`.
    pub(super) fn broken<T>(&mut self, pair: &Pair<'t>, rule: Rule, next: Option<usize>, body: &mut Body<T>) {
        let span = self.without_blanks(pair);
        if self.failures.are_many() {
            return body.broken.push(Broken::anything(span));
        }
        let failure = self.failures.failure(rule, span.start);
        // Where it fails only inside of what is broken next, that one is to blame and will be told itself.
        let blames_next = next.is_some_and(|next| failure.at() > next);
        let is_told = failure.is_unknown() && self.goes_on_a_broken_one(&span, body);
        if failure.is_unknown() && !is_told {
            // With more behind it, what was taken as the statement before is not what was meant.
            let goes_on = |before: &Span| failure.is_clause() || self.goes_on(before, &span);
            let unfinished = body.statements.pop_if(|before| !self.is_block(&before.span) && goes_on(&before.span));
            body.broken.extend(unfinished.map(|before| self.by_its_words(rule, before.span, false)));
        }
        if is_told {
            self.told.end = span.end;
        } else if !blames_next {
            self.failures.tell(&failure, span.end);
            self.told = span.clone();
        }
        let end = self.failures.text().len();
        let is_cut = !blames_next && self.failures.text()[failure.at()..].trim().is_empty();
        let is_nameless = !blames_next && self.is_nameless(&failure, span.start);
        body.broken.push(self.by_its_words(rule, span, is_nameless));
        body.broken.extend(is_cut.then(|| Broken::anything(end..end)));
    }

    /// What a statement says that is one by its form, but was refused.
    pub(super) fn refused(&self, rule: Rule, span: Span) -> Broken {
        self.by_its_words(rule, span, true)
    }

    /// Where a text ends within a block, it may end within its last statement.
    pub(super) fn cut_off<T>(&self, rule: Rule, body: &mut Body<T>) {
        let is_last =
            |span: &Span| words(self.failures.written(), &(span.end..self.failures.written().len()), &[]).is_empty();
        let cut = body.statements.pop_if(|last| !self.is_block(&last.span) && is_last(&last.span));
        body.broken.extend(cut.map(|last| self.by_its_words(rule, last.span, false)));
    }

    fn by_its_words(&self, rule: Rule, span: Span, is_nameless: bool) -> Broken {
        let words = words(self.failures.written(), &span, &self.unpaired.open);
        let names = words.iter().map(|word| word.text.to_owned()).collect();
        // A file's items have names of their own, and those of others.
        let is_nameless = is_nameless || rule == Rule::item;
        Broken { keywords: keywords(rule, &words), names: Some(names).filter(|_| !is_nameless), span }
    }

    /// Whether the name of which the statement was to speak could not be read.
    fn is_nameless(&self, failure: &Failure<'_>, start: usize) -> bool {
        const NAMES: [Rule; 6] = [Rule::name, Rule::axis, Rule::format, Rule::error_name, Rule::event, Rule::word];
        let is_name = failure.expected.iter().any(|rule| NAMES.contains(rule));
        let is_value = failure.expected.contains(&Rule::quantity);
        is_name && !is_value && words(self.failures.written(), &(start..failure.at()), &[]).len() <= 1
    }

    /// Whether what is broken begins on a further line of something broken that has been told.
    fn goes_on_a_broken_one<T>(&self, span: &Span, body: &Body<T>) -> bool {
        let is_behind = |before: &Broken| before.span.end == self.told.end;
        let is_last = body.statements.last().is_none_or(|before| before.span.start < self.told.start);
        body.broken.last().is_some_and(is_behind) && is_last && self.goes_on(&self.told, span)
    }

    /// Whether something stands on the line of what is before it, or on one that is indented more.
    fn goes_on(&self, before: &Span, span: &Span) -> bool {
        let text = self.failures.text();
        let indentation = |at: usize| {
            let line = &text[text[..at].rfind('\n').map_or(0, |newline| newline + 1)..];
            line.len() - line.trim_start_matches([' ', '\t']).len()
        };
        !text[before.end..span.start].contains('\n') || indentation(span.start) > indentation(before.start)
    }

    fn is_block(&self, span: &Span) -> bool {
        self.failures.text()[span.clone()].ends_with('}')
    }

    fn without_blanks(&self, pair: &Pair<'t>) -> Span {
        let Span { start, end } = grammar::extent(pair);
        start..start + self.failures.text()[start..end].trim_end().len()
    }
}

/// The statements that hold others.
const BLOCKS: [&str; 8] = ["machine", "controller", "branch", "dh", "error", "group", "once", "on"];

/// The keywords of the statements that such words may be; `None` where the first of a line is none, nor resembles one, and
/// where a block has none.
fn keywords(rule: Rule, words: &[Word<'_>]) -> Option<Vec<String>> {
    let known = statements(rule);
    let mut meant: Vec<String> = Vec::new();
    for word in words {
        if word.is_inside {
            meant.last().filter(|keyword| BLOCKS.contains(&keyword.as_str()))?;
        } else if known.iter().any(|keyword| keyword == word.text) {
            meant.push(word.text.to_owned());
        } else if word.begins_line {
            meant.push(nearest(word.text, known.iter().map(String::as_str))?.to_owned());
        }
    }
    Some(meant).filter(|meant| !meant.is_empty())
}
