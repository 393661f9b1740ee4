//! What no statement takes: it is told once, and recorded by its words.

use super::Builder;
use super::expected::statements;
use super::failure::Failure;
use super::grammar::{self, Pair, Rule};
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
        if failure.is_unknown() {
            if self.goes_on_a_broken_one(&span, body) {
                return;
            }
            // With more behind it, what was taken as the statement before is not what was meant.
            let goes_on = |before: &Span| failure.is_clause() || self.goes_on(before, &span);
            let unfinished = body.statements.pop_if(|before| !self.is_block(&before.span) && goes_on(&before.span));
            body.broken.extend(unfinished.map(|before| self.by_its_words(rule, before.span, false)));
        }
        // Where it fails only inside of what is broken next, that one is to blame and will be told itself.
        let blames_next = next.is_some_and(|next| span.start + failure.length > next);
        if !blames_next {
            self.failures.tell(&failure, span.end);
            self.told_until = span.end;
        }
        let is_nameless = !blames_next && self.is_nameless(&failure, span.start);
        body.broken.push(self.by_its_words(rule, span, is_nameless));
    }

    /// What a statement says that is one by its form, but was refused.
    pub(super) fn refused(&self, rule: Rule, span: Span) -> Broken {
        self.by_its_words(rule, span, true)
    }

    fn by_its_words(&self, rule: Rule, span: Span, is_nameless: bool) -> Broken {
        let words = words(&self.failures.text()[span.clone()]);
        let names = words.iter().map(|word| word.text.to_owned()).collect();
        Broken { keywords: keywords(rule, &words), names: Some(names).filter(|_| !is_nameless), span }
    }

    /// Whether the name of which the statement was to speak could not be read.
    fn is_nameless(&self, failure: &Failure<'_>, start: usize) -> bool {
        const NAMES: [Rule; 6] = [Rule::name, Rule::axis, Rule::format, Rule::error_name, Rule::event, Rule::word];
        let is_name = failure.expected.iter().any(|rule| NAMES.contains(rule));
        let is_value = failure.expected.contains(&Rule::quantity);
        let before = &self.failures.text()[start..start + failure.length];
        is_name && !is_value && words(before).len() <= 1
    }

    /// Whether what is broken begins on a further line of something broken that has been told.
    fn goes_on_a_broken_one<T>(&mut self, span: &Span, body: &mut Body<T>) -> bool {
        let is_last = |before: &Broken| body.statements.last().is_none_or(|it| it.span.start < before.span.start);
        let before = body.broken.last().filter(|before| is_last(before) && self.told_until == before.span.end);
        if !before.is_some_and(|before| self.goes_on(&before.span, span)) {
            return false;
        }
        let before = body.broken.last_mut().expect("it was there a line ago");
        let words = words(&self.failures.text()[span.clone()]);
        before.names.iter_mut().for_each(|names| names.extend(words.iter().map(|word| word.text.to_owned())));
        before.span.end = span.end;
        self.told_until = span.end;
        true
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

struct Word<'t> {
    text: &'t str,
    /// Whether it stands in a block.
    is_inside: bool,
}

/// The words of a text, without those of its comments and quoted texts.
fn words(text: &str) -> Vec<Word<'_>> {
    let mut words = Vec::new();
    let (mut at, mut depth) = (0, 0_usize);
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let is_in_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let length = match first {
            '"' => rest[1..].find(['"', '\n']).map_or(rest.len(), |end| end + 2),
            '/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            c if is_in_word(c) => rest.find(|c| !is_in_word(c)).unwrap_or(rest.len()),
            c => c.len_utf8(),
        };
        match first {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            c if is_in_word(c) => words.push(Word { text: &rest[..length], is_inside: depth > 0 }),
            _ => {}
        }
        at += length;
    }
    words
}

/// The keywords of the statements that such words may be; `None` where the first of them is none, nor resembles one.
fn keywords(rule: Rule, words: &[Word<'_>]) -> Option<Vec<String>> {
    let known = statements(rule);
    let is_known = |word: &str| known.iter().any(|keyword| keyword == word);
    let mut meant: Vec<String> = Vec::new();
    let (first, others) = words.split_first()?;
    match is_known(first.text) {
        true => meant.push(first.text.to_owned()),
        false => meant.push(nearest(first.text, known.iter().map(String::as_str))?.to_owned()),
    }
    meant.extend(others.iter().filter(|word| !word.is_inside && is_known(word.text)).map(|word| word.text.to_owned()));
    Some(meant)
}
