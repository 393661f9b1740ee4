//! What the grammar could not take, told as a diagnostic: what was found, and what would have fitted there.

use mach_runtime::diagnostic::{Code, Diagnostic, Place, Suggestion};
use pest::Parser;

use super::expected::{described, furthest_failure, keyword, list, statements};
use super::found::Found;
use super::grammar::{MachParser, Rule};
use crate::syntax::place::place;
use crate::syntax::spelling::nearest;
use crate::syntax::tree::Span;

/// No more errors than this are collected from one file.
pub const MOST_ERRORS: usize = 50;

/// Something stands where something else should.
pub static UNEXPECTED: Code = Code {
    id: "E0107",
    title: "something else was expected here",
    explanation: "\
The statement is all right up to the mark; there something stands that does not fit. The message names what would
have fitted. For example

    linear X along +x travel -355 . 355

lacks a point: a range is written `-355 .. 355`. The reference of the language shows the form of every statement.",
};

/// A statement that does not exist.
pub static UNKNOWN_STATEMENT: Code = Code {
    id: "E0108",
    title: "unknown statement",
    explanation: "\
Every statement begins with its keyword. Which statements there may be depends on where it stands:

- at the top of a file: `use`, `machine`, `controller`
- in a machine: `let`, `chain`, `dh`, `linear`, `rotary`, `error`, `tool`, `zero`, `tolerance`, `records`, `branch`,
  `controller`
- in a `dh` block: `link`, `bed`; in a table of errors: `at`
- in a `branch` block: `start`, `then`, `reposition`, `lock`, `prefer`, `free`
- in a controller: `units`, `extension`, `comment`, `sequence`, `offset`, `retract`, `code`, `format`, `word`, `write`, `modal`,
  `on`
- in an `on` block: a text in quotes, or `bare` and a text",
};

/// Where statements stand.
const CONTEXTS: [(Rule, &str); 7] = [
    (Rule::item, "at the top of a file"),
    (Rule::in_machine, "in a machine"),
    (Rule::in_dh, "in a `dh` block"),
    (Rule::at_statement, "in a table of errors"),
    (Rule::in_branch, "in a `branch` block"),
    (Rule::in_controller, "in a controller"),
    (Rule::line, "in an `on` block"),
];

/// What may go on a statement; misspelt, it looks like the next statement.
const CLAUSES: [&str; 14] = [
    "along",
    "about",
    "through",
    "travel",
    "turns",
    "rapid",
    "at",
    "length",
    "start",
    "step",
    "greatest",
    "inch",
    "zero",
    "revolution",
];

/// Collects what is wrong with a text.
pub(super) struct Failures<'t> {
    file_name: &'t str,
    text: &'t str,
    errors: Vec<Diagnostic>,
}

impl<'t> Failures<'t> {
    pub(super) fn new(file_name: &'t str, text: &'t str) -> Self {
        Self { file_name, text, errors: Vec::new() }
    }

    pub(super) fn into_errors(mut self) -> Vec<Diagnostic> {
        self.errors.sort_by_key(|error| error.labels.first().map(|label| (label.place.line, label.place.column)));
        self.errors
    }

    pub(super) fn place(&self, span: &Span) -> Place {
        place(self.file_name, self.text, span)
    }

    pub(super) fn push(&mut self, diagnostic: Diagnostic) {
        if self.errors.len() < MOST_ERRORS {
            self.errors.push(diagnostic);
        }
    }

    pub(super) fn error(&mut self, code: &'static Code, message: String, span: Span, label: &str) {
        let diagnostic = Diagnostic::error(code, message).at(self.place(&span), label);
        self.push(diagnostic);
    }

    /// Reports why `rule` does not take the text from `start` on. Where it fails only inside `next`, the start of
    /// another broken statement, that one is to blame and will be reported itself.
    pub(super) fn syntax(&mut self, rule: Rule, start: usize, next: Option<usize>) {
        if self.errors.len() >= MOST_ERRORS {
            return;
        }
        let (length, expected) = furthest_failure(rule, &self.text[start..]);
        if next.is_some_and(|next| start + length > next) {
            return;
        }
        let found = Found::at(self.text, start + length);
        let keywords: Vec<String> = expected.iter().filter_map(|rule| keyword(*rule)).collect();
        let clauses = CLAUSES.iter().filter(|_| length == 0).copied();
        let meant = found.word.and_then(|word| nearest(word, keywords.iter().map(String::as_str).chain(clauses)));
        let diagnostic = match meant {
            _ if length == 0 => self.unknown(rule, &found),
            None if !expected.contains(&Rule::statement_word) => {
                self.unexpected(rule, &found.or_line_end(self.text, start), &expected)
            }
            _ => self.unexpected(rule, &found, &expected),
        };
        self.push(match meant {
            Some(meant) => diagnostic.suggest(Suggestion {
                text: format!("did you mean `{meant}`?"),
                place: self.place(&found.span),
                replacement: meant.to_owned(),
            }),
            None => diagnostic,
        });
    }

    fn unknown(&self, rule: Rule, found: &Found<'_>) -> Diagnostic {
        let context = CONTEXTS.iter().find(|(other, _)| *other == rule).map_or("here", |(_, name)| name);
        let message = match found.word {
            Some(word) => format!("there is no statement `{word}` {context}"),
            None => format!("a statement cannot begin with {}", found.description),
        };
        let diagnostic = Diagnostic::error(&UNKNOWN_STATEMENT, message).at(self.place(&found.span), "");
        let elsewhere = found.word.and_then(|word| {
            CONTEXTS.iter().find(|(context, _)| statements(*context).iter().any(|statement| statement == word))
        });
        match elsewhere {
            Some((_, place)) => diagnostic.note(format!("`{}` belongs {place}", found.word.unwrap_or_default())),
            None => {
                diagnostic.note(format!("{context} there may be {}", list(&described(&furthest_failure(rule, "").1))))
            }
        }
    }

    fn unexpected(&self, rule: Rule, found: &Found<'_>, expected: &[Rule]) -> Diagnostic {
        let names = expected.contains(&Rule::name);
        let expected = list(&described(expected));
        let message = format!("expected {expected}, found {}", found.description);
        let diagnostic =
            Diagnostic::error(&UNEXPECTED, message).at(self.place(&found.span), format!("expected {expected}"));
        match (rule, found.word) {
            (Rule::line, _) if matches!(found.description.as_str(), "`{`" | "`}`") => {
                diagnostic.note("a brace that is to be printed is written twice: `{{`, `}}`")
            }
            (_, Some(word)) if !word.is_ascii() => {
                diagnostic.note("names consist of the letters A to Z and a to z, digits and `_`")
            }
            (_, Some(word)) if names && MachParser::parse(Rule::name, word).is_err() => {
                diagnostic.note(format!("`{word}` is a word of the language and cannot be a name"))
            }
            _ => diagnostic,
        }
    }
}
