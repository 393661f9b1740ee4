//! What the grammar could not take, told as a diagnostic: what was found, and what would have fitted there.

use mach_runtime::diagnostic::{Code, Diagnostic, Place, Suggestion};
use pest::Parser;

use super::bounds::MOST_ERRORS;
use super::expected::{described, furthest_failure, keyword, list, statements};
use super::found::Found;
use super::grammar::{MachParser, Rule};
use super::scan::{Scan, UNMATCHED_BRACE};
use crate::syntax::place::place;
use crate::syntax::spelling::nearest;
use crate::syntax::tree::Span;

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
- in a controller: `units`, `blocks`, `extension`, `comment`, `sequence`, `offset`, `retract`, `format`, `word`, `form`, `write`,
  `group`, `once`, `plain`, `on`
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
    scan: &'t Scan<'t>,
    errors: Vec<Diagnostic>,
    /// Whether a block without its `{` has been told: that its `}` closes nothing then goes without saying.
    lacks_opening: bool,
}

/// Why a statement is none.
pub(super) struct Failure<'t> {
    /// What a statement would be there.
    rule: Rule,
    start: usize,
    /// How far the grammar gets.
    length: usize,
    /// What would fit there.
    pub(super) expected: Vec<Rule>,
    /// What stands there instead.
    found: Found<'t>,
    /// What was probably meant.
    pub(super) meant: Option<String>,
}

impl Failure<'_> {
    /// Whether no statement begins so.
    pub(super) fn is_unknown(&self) -> bool {
        self.length == 0
    }

    /// Where the grammar does not go on.
    pub(super) fn at(&self) -> usize {
        self.start + self.length
    }

    /// Whether what stands there was probably meant to go on the statement before it.
    pub(super) fn is_clause(&self) -> bool {
        let word = self.meant.as_deref().or(self.found.word);
        self.is_unknown() && word.is_some_and(|word| CLAUSES.contains(&word))
    }
}

impl<'t> Failures<'t> {
    pub(super) fn new(file_name: &'t str, text: &'t str, scan: &'t Scan<'t>) -> Self {
        Self { file_name, text, scan, errors: Vec::new(), lacks_opening: false }
    }

    /// Everything that is wrong, in the order of the text.
    pub(super) fn into_errors(mut self) -> Vec<Diagnostic> {
        let unpaired = &self.scan.unpaired;
        let open = unpaired.open.iter().map(|at| (at, "this `{` is never closed"));
        let surplus = unpaired.surplus.iter().map(|at| (at, "this `}` closes nothing"));
        let braces = open.chain(surplus.filter(|_| !self.lacks_opening)).filter(|_| self.scan.tells_unpaired);
        let place = |at: usize| place(self.file_name, self.text, &(at..at + 1));
        let braces = braces.map(|(at, message)| Diagnostic::error(&UNMATCHED_BRACE, message).at(place(*at), ""));
        let mut errors: Vec<Diagnostic> = self.scan.errors.iter().cloned().chain(braces).collect();
        errors.append(&mut self.errors);
        errors.sort_by_key(|error| error.labels.first().map(|label| (label.place.line, label.place.column)));
        errors.truncate(MOST_ERRORS);
        errors
    }

    /// The text that is parsed.
    pub(super) fn text(&self) -> &'t str {
        &self.scan.text
    }

    /// The text as it was written.
    pub(super) fn written(&self) -> &'t str {
        self.text
    }

    pub(super) fn place(&self, span: &Span) -> Place {
        place(self.file_name, self.text, span)
    }

    pub(super) fn push(&mut self, diagnostic: Diagnostic) {
        if !self.are_many() {
            self.errors.push(diagnostic);
        }
    }

    /// Whether nothing more is told.
    pub(super) fn are_many(&self) -> bool {
        self.errors.len() >= MOST_ERRORS
    }

    pub(super) fn error(&mut self, code: &'static Code, message: String, span: Span, label: &str) {
        let diagnostic = Diagnostic::error(code, message).at(self.place(&span), label);
        self.push(diagnostic);
    }

    /// Why `rule` does not take the text from `start` on.
    pub(super) fn failure(&self, rule: Rule, start: usize) -> Failure<'t> {
        let (length, expected) = furthest_failure(rule, &self.text()[start..]);
        let found = Found::at(self.text, start + length);
        let keywords: Vec<String> = expected.iter().filter_map(|rule| keyword(*rule)).collect();
        let clauses = CLAUSES.iter().filter(|_| length == 0).copied();
        let meant = found.word.and_then(|word| nearest(word, keywords.iter().map(String::as_str).chain(clauses)));
        let meant = meant.map(str::to_owned);
        Failure { rule, start, length, expected, found, meant }
    }

    /// Tells a failure of what ends at `end`, unless it is the consequence of something that the scan has told.
    pub(super) fn tell(&mut self, failure: &Failure<'t>, end: usize) {
        let is_told =
            self.scan.wrong.iter().any(|at| (failure.start..end).contains(at)) || self.is_behind_open(failure);
        // Behind a brace too many or too few, statements stand in the wrong block.
        let is_misplaced = failure.is_unknown() && !self.scan.unpaired.is_none() && elsewhere(&failure.found).is_some();
        if is_told || is_misplaced {
            return;
        }
        self.lacks_opening |= failure.expected.iter().any(|rule| is_opening(*rule));
        let diagnostic = self.diagnostic(failure);
        self.push(diagnostic);
    }

    /// Whether a `{` that is never closed, and what it opens, is to blame.
    fn is_behind_open(&self, failure: &Failure<'t>) -> bool {
        let at = failure.found.span.start;
        let is_before = |open: &usize| *open <= at && self.text[*open..at].trim_start_matches('{').trim().is_empty();
        self.scan.unpaired.open.iter().any(is_before)
    }

    fn diagnostic(&self, failure: &Failure<'t>) -> Diagnostic {
        let Failure { rule, start, expected, found, meant, .. } = failure;
        let diagnostic = match meant {
            _ if failure.is_unknown() => self.unknown(*rule, found),
            None if !expected.contains(&Rule::statement_word) => {
                self.unexpected(*rule, &found.or_line_end(self.text, *start), expected)
            }
            _ => self.unexpected(*rule, found, expected),
        };
        match meant {
            Some(meant) => diagnostic.suggest(Suggestion {
                text: format!("did you mean `{meant}`?"),
                place: self.place(&found.span),
                replacement: meant.clone(),
            }),
            None => diagnostic,
        }
    }

    fn unknown(&self, rule: Rule, found: &Found<'_>) -> Diagnostic {
        let context = CONTEXTS.iter().find(|(other, _)| *other == rule).map_or("here", |(_, name)| name);
        let message = match found.word {
            Some(word) => format!("there is no statement `{word}` {context}"),
            None => format!("a statement cannot begin with {}", found.description),
        };
        let diagnostic = Diagnostic::error(&UNKNOWN_STATEMENT, message).at(self.place(&found.span), "");
        match elsewhere(found) {
            Some(place) => diagnostic.note(format!("`{}` belongs {place}", found.word.unwrap_or_default())),
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

/// Where a statement belongs that begins with what was found.
fn elsewhere(found: &Found<'_>) -> Option<&'static str> {
    let word = found.word?;
    let begins_so = |context: Rule| statements(context).iter().any(|statement| statement == word);
    CONTEXTS.iter().find(|(context, _)| begins_so(*context)).map(|(_, place)| *place)
}

fn is_opening(rule: Rule) -> bool {
    let bodies = [Rule::machine_body, Rule::controller_body, Rule::branch_body, Rule::dh_body, Rule::line_body];
    rule == Rule::open_brace || bodies.contains(&rule)
}
