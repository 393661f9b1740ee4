//! The characters of a file: where its comments are, and whether its texts and braces are closed.
//!
//! What is wrong here would make nonsense of everything after it, so nothing is parsed until it is mended.

use mach_runtime::diagnostic::{Code, Diagnostic, Suggestion};

use super::failure::MOST_ERRORS;
use crate::syntax::place::place;
use crate::syntax::tree::Span;

/// The greatest length of a file in bytes.
pub const MOST_BYTES: usize = 4 << 20;
/// How deep braces and parentheses may be nested.
pub const MOST_NESTED: usize = 64;

/// The file is too large.
pub static TOO_LARGE: Code = Code {
    id: "E0101",
    title: "file too large",
    explanation: "\
A `.mach` file is a data sheet of a few hundred lines; a file of more than 4 MB is something else, perhaps CL data
or an NC program.

Give the machine file first and the CL data second: `machc post MACHINE CL`.",
};

/// A control character.
pub static CONTROL_CHARACTER: Code = Code {
    id: "E0102",
    title: "control character",
    explanation: "\
A `.mach` file is plain text in UTF-8. Besides line ends and tabs it holds no control characters; one of them is
most often a sign that the file is not a text file at all, or that it was copied from a terminal.

Delete the character. A line ends with a line feed (or with carriage return and line feed).",
};

/// A text without its closing quote.
pub static UNTERMINATED_TEXT: Code = Code {
    id: "E0103",
    title: "text without its closing quote",
    explanation: "\
A text begins and ends with a double quote on the same line:

    extension \"nc\"

A quote inside a text is written `\\\"`, a backslash `\\\\`.",
};

/// A backslash that means nothing.
pub static UNKNOWN_ESCAPE: Code = Code {
    id: "E0104",
    title: "backslash that means nothing",
    explanation: "\
In a text a backslash stands before a quote (`\\\"`) or before another backslash (`\\\\`). A single backslash is
written twice:

    on start { \"%_N_{program}_MPF\"  \";$PATH=\\\\DIR\" }

Paths after `use` are written with `/` on every system.",
};

/// Braces that do not match.
pub static UNMATCHED_BRACE: Code = Code {
    id: "E0105",
    title: "brace without its partner",
    explanation: "\
Every `{` has its `}`:

    branch {
        start least |C|
    }

Where a `}` is missing, the braces after it match the wrong partners; a second label points at the first pair whose
indentation differs. A brace that is to be printed by a template stands inside its quotes and is written twice.",
};

/// Braces or parentheses in too many levels.
pub static TOO_DEEP: Code = Code {
    id: "E0106",
    title: "nested too deep",
    explanation: "\
Braces and parentheses may be nested 64 levels deep. Give parts of a deep expression names:

    let radius = sqrt(a ^ 2 + b ^ 2)
    let angle  = atan2(radius, c)",
};

/// What the scan finds.
pub(super) struct Scan {
    /// The comments, each from its `//` to the end of its line.
    pub(super) comments: Vec<Span>,
}

/// Goes over the characters of a text.
pub(super) fn scan(file_name: &str, text: &str) -> Result<Scan, Vec<Diagnostic>> {
    let mut scanner = Scanner {
        file_name,
        text,
        at: 0,
        open: Vec::new(),
        parentheses: 0,
        suspect: None,
        comments: vec![],
        errors: vec![],
    };
    if text.len() > MOST_BYTES {
        let message = format!("the file has {} bytes; a machine file has at most {MOST_BYTES}", text.len());
        return Err(vec![Diagnostic::error(&TOO_LARGE, message).at(place(file_name, text, &(0..0)), "")]);
    }
    scanner.run();
    if scanner.errors.is_empty() { Ok(Scan { comments: scanner.comments }) } else { Err(scanner.errors) }
}

struct Scanner<'t> {
    file_name: &'t str,
    text: &'t str,
    at: usize,
    /// Where the open braces are.
    open: Vec<usize>,
    /// How many parentheses are open inside the innermost brace.
    parentheses: usize,
    /// The first brace whose partner is indented differently.
    suspect: Option<usize>,
    comments: Vec<Span>,
    errors: Vec<Diagnostic>,
}

impl Scanner<'_> {
    fn run(&mut self) {
        while let Some(character) = self.text[self.at..].chars().next() {
            match character {
                '"' => self.quoted(),
                '/' if self.text[self.at..].starts_with("//") => self.comment(),
                '{' => self.opened(),
                '}' => self.closed(),
                '(' => self.parentheses += 1,
                ')' => self.parentheses = self.parentheses.saturating_sub(1),
                '\n' | '\t' => {}
                '\r' if self.text[self.at..].starts_with("\r\n") => {}
                c if c.is_control() => self.control(c),
                _ => {}
            }
            if self.open.len() + self.parentheses > MOST_NESTED {
                let message = format!("more than {MOST_NESTED} braces and parentheses are open here");
                return self.error(&TOO_DEEP, message, self.at..self.at + 1, "");
            }
            self.at += self.text[self.at..].chars().next().map_or(0, char::len_utf8);
        }
        self.unclosed();
    }

    fn error(&mut self, code: &'static Code, message: String, span: Span, label: &str) {
        self.push(Diagnostic::error(code, message).at(place(self.file_name, self.text, &span), label));
    }

    fn push(&mut self, diagnostic: Diagnostic) {
        self.errors.push(diagnostic);
        if self.errors.len() >= MOST_ERRORS {
            self.at = self.text.len();
        }
    }

    fn control(&mut self, character: char) {
        let message = format!("the control character U+{:04X} does not belong in a machine file", character as u32);
        self.error(&CONTROL_CHARACTER, message, self.at..self.at + character.len_utf8(), "");
        self.at = self.text.len();
    }

    /// Up to the end of the line; `at` is left at its last character, since the loop steps on from there.
    fn comment(&mut self) {
        let rest = &self.text[self.at..];
        let line = rest.find('\n').map_or(rest, |end| &rest[..end]).trim_end_matches('\r');
        if let Some((at, control)) = line.char_indices().find(|(_, c)| c.is_control() && *c != '\t') {
            self.at += at;
            return self.control(control);
        }
        self.comments.push(self.at..self.at + line.len());
        self.at += line.char_indices().next_back().map_or(0, |(last, _)| last);
    }

    /// Up to the closing quote, where `at` is left.
    fn quoted(&mut self) {
        let start = self.at;
        let mut characters = self.text[start + 1..].char_indices().map(|(at, c)| (start + 1 + at, c));
        while let Some((at, character)) = characters.next() {
            self.at = at;
            match character {
                '"' => return,
                '\\' => match characters.next() {
                    Some((_, '"' | '\\')) => {}
                    Some((_, '\n' | '\r')) | None => break,
                    Some(_) => self.unknown_escape(at),
                },
                '\n' | '\r' => break,
                '\t' => {}
                c if c.is_control() => return self.control(c),
                _ => {}
            }
        }
        let line = self.text[start..].lines().next().unwrap_or("").trim_end();
        let message = "this text has no closing quote on its line".to_owned();
        self.error(&UNTERMINATED_TEXT, message, start..start + line.len(), "begins here");
        self.at = start + line.char_indices().next_back().map_or(0, |(last, _)| last);
    }

    fn unknown_escape(&mut self, at: usize) {
        let place = place(self.file_name, self.text, &(at..at + 1));
        let suggestion = Suggestion {
            text: "a backslash is written twice".to_owned(),
            place: place.clone(),
            replacement: "\\\\".to_owned(),
        };
        let message = "a backslash stands only before a quote or another backslash";
        self.push(Diagnostic::error(&UNKNOWN_ESCAPE, message).at(place, "").suggest(suggestion));
    }

    fn opened(&mut self) {
        self.open.push(self.at);
        self.parentheses = 0;
    }

    fn closed(&mut self) {
        self.parentheses = 0;
        let Some(open) = self.open.pop() else {
            return self.error(&UNMATCHED_BRACE, "this `}` closes nothing".to_owned(), self.at..self.at + 1, "");
        };
        let (closing, opening) = (self.line_before(self.at), self.line_before(open));
        let indentation = opening.len() - opening.trim_start().len();
        if closing.trim().is_empty() && closing.len() != indentation && self.suspect.is_none() {
            self.suspect = Some(open);
        }
    }

    fn line_before(&self, at: usize) -> &str {
        let before = &self.text[..at];
        before.rfind('\n').map_or(before, |newline| &before[newline + 1..])
    }

    fn unclosed(&mut self) {
        let Some(open) = self.open.pop().filter(|_| self.errors.is_empty()) else { return };
        let place = |at: usize| place(self.file_name, self.text, &(at..at + 1));
        let mut diagnostic = Diagnostic::error(&UNMATCHED_BRACE, "this `{` is never closed").at(place(open), "");
        if let Some(suspect) = self.suspect {
            diagnostic = diagnostic.at(place(suspect), "the `}` that closes this one is indented differently");
        }
        self.push(diagnostic);
    }
}
