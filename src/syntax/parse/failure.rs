//! What the grammar could not take, told as a diagnostic: what was found, and what would have fitted there.

use mach_runtime::diagnostic::{Code, Diagnostic, Place, Suggestion};
use pest::Parser;
use pest::error::{ErrorVariant, InputLocation};

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
- in a machine: `let`, `chain`, `linear`, `rotary`, `tool`, `zero`, `tolerance`, `records`, `branch`, `controller`
- in a `branch` block: `start`, `then`, `reposition`
- in a controller: `units`, `extension`, `comment`, `sequence`, `offset`, `code`, `format`, `word`, `write`, `modal`,
  `on`
- in an `on` block: a text in quotes, or `bare` and a text",
};

/// Where statements stand.
const CONTEXTS: [(Rule, &str); 5] = [
    (Rule::item, "at the top of a file"),
    (Rule::in_machine, "in a machine"),
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
            (_, Some(word)) if names && MachParser::parse(Rule::name, word).is_err() => {
                diagnostic.note(format!("`{word}` is a word of the language and cannot be a name"))
            }
            _ => diagnostic,
        }
    }
}

/// How far `rule` gets in a text, and what would have fitted there.
fn furthest_failure(rule: Rule, text: &str) -> (usize, Vec<Rule>) {
    let Err(error) = MachParser::parse(rule, text) else { return (0, Vec::new()) };
    let at = match error.location {
        InputLocation::Pos(at) | InputLocation::Span((at, _)) => at,
    };
    match error.variant {
        ErrorVariant::ParsingError { positives, .. } => (at, positives),
        ErrorVariant::CustomError { .. } => (at, Vec::new()),
    }
}

/// The keywords of the statements that a context may hold.
fn statements(context: Rule) -> Vec<String> {
    furthest_failure(context, "").1.into_iter().filter_map(keyword).collect()
}

/// The keyword that a rule begins with: the grammar's rules are named after theirs.
fn keyword(rule: Rule) -> Option<String> {
    let name = format!("{rule:?}");
    let suffixes = ["_statement", "_choice", "_clause", "_kind"];
    let keyword = name.strip_prefix("kw_").or_else(|| suffixes.iter().find_map(|suffix| name.strip_suffix(suffix)));
    match rule {
        Rule::line => Some("bare".to_owned()),
        _ => keyword.map(str::to_owned),
    }
}

/// What stands at a place.
#[derive(Clone)]
struct Found<'t> {
    span: Span,
    description: String,
    word: Option<&'t str>,
}

impl<'t> Found<'t> {
    fn at(text: &'t str, at: usize) -> Self {
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
    fn or_line_end(&self, text: &'t str, start: usize) -> Self {
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

/// What would have fitted, in words; that an expression might have gone on is said only when nothing else fits.
fn described(expected: &[Rule]) -> Vec<String> {
    let mut words = unique(expected.iter().filter_map(|rule| description(*rule)));
    if words.is_empty() {
        words = unique(expected.iter().filter_map(|rule| continuation(*rule)));
    }
    if words.iter().any(|word| word == A_VALUE) {
        words.retain(|word| word != A_NAME);
    }
    words.sort_by_key(|word| [NEXT_STATEMENT, "`}`"].contains(&word.as_str()));
    words
}

fn unique(words: impl Iterator<Item = String>) -> Vec<String> {
    words.fold(Vec::new(), |mut unique, word| {
        if !unique.contains(&word) {
            unique.push(word);
        }
        unique
    })
}

const A_NAME: &str = "a name";
const A_VALUE: &str = "a value";
const NEXT_STATEMENT: &str = "the next statement";

fn description(rule: Rule) -> Option<String> {
    let words = match rule {
        Rule::name => A_NAME,
        Rule::axis | Rule::link => "an axis",
        Rule::format => "the name of a format",
        Rule::code => "a code such as `G0`",
        Rule::text => "a text in quotes",
        Rule::line | Rule::template => "a line in quotes",
        Rule::placeholder_name => "the name of a placeholder",
        Rule::picture => "a picture such as `##0.0`",
        Rule::event | Rule::word => "an event",
        Rule::number | Rule::quantity | Rule::call | Rule::parenthesised | Rule::expression => A_VALUE,
        Rule::statement_word => NEXT_STATEMENT,
        Rule::open_brace => "`{`",
        Rule::machine_body | Rule::branch_body | Rule::controller_body | Rule::line_body => "`{`",
        Rule::close_brace => "`}`",
        Rule::close_parenthesis => "`)`",
        Rule::comma => "`,`",
        Rule::colon => "`:`",
        Rule::equals => "`=`",
        Rule::range_dots => "`..`",
        Rule::bar => "`|`",
        Rule::quote => "`\"`",
        rule => return keyword(rule).map(|keyword| format!("`{keyword}`")),
    };
    Some(words.to_owned())
}

/// What may follow an operand.
fn continuation(rule: Rule) -> Option<String> {
    let words = match rule {
        Rule::unit | Rule::unknown_unit => "a unit",
        Rule::add | Rule::subtract | Rule::multiply | Rule::divide | Rule::power => "an operator",
        Rule::open_parenthesis => "`(`",
        _ => "something else",
    };
    Some(words.to_owned())
}

fn list(words: &[String]) -> String {
    match words {
        [] => "something else".to_owned(),
        [only] => only.clone(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    }
}
