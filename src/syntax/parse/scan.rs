//! The characters of a file: where its comments are, and whether its texts and braces are closed.
//!
//! What is wrong here would make nonsense of everything after it: it is reported, and what is parsed is a text in which it is
//! mended.

use std::borrow::Cow;

use mach_runtime::diagnostic::{Code, Diagnostic, Suggestion};

use super::bounds::{MOST_ERRORS, MOST_NESTED};
use super::braces::{Mark, Unpaired, unpaired};
use crate::syntax::place::place;
use crate::syntax::tree::Span;

/// The greatest length of a file in bytes.
pub const MOST_BYTES: usize = 4 << 20;
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

Which one has no partner is told by the indentation: a block holds what is indented more than the line that opens it. A
brace that is to be printed by a template stands inside its quotes and is written twice.",
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
pub(super) struct Scan<'t> {
    /// The comments, each from its `//` to the end of its line.
    pub(super) comments: Vec<Span>,
    /// The text to parse: where nothing is wrong the text itself, and of the same length. Texts are closed, blocks too unless
    /// they end with it, and nothing is nested too deep.
    pub(super) text: Cow<'t, str>,
    /// What is wrong with single characters and with texts.
    pub(super) errors: Vec<Diagnostic>,
    /// Where that is.
    pub(super) wrong: Vec<usize>,
    /// The braces without a partner.
    pub(super) unpaired: Unpaired,
    /// Whether these are a mistake of their own.
    pub(super) tells_unpaired: bool,
}

/// Goes over the characters of a text.
///
/// # Errors
/// Why it is no text that anything could be found in.
pub(super) fn scan<'t>(file_name: &'t str, text: &'t str) -> Result<Scan<'t>, Diagnostic> {
    let mut scanner = Scanner::new(file_name, text);
    if text.len() > MOST_BYTES {
        let message = format!("the file has {} bytes; a machine file has at most {MOST_BYTES}", text.len());
        return Err(Diagnostic::error(&TOO_LARGE, message).at(place(file_name, text, &(0..0)), ""));
    }
    if let Some(nul) = text.find('\0') {
        scanner.control(nul, '\0');
        return Err(scanner.errors.swap_remove(0));
    }
    scanner.run();
    Ok(scanner.finish())
}

struct Scanner<'t> {
    file_name: &'t str,
    text: &'t str,
    at: usize,
    /// Whether the line has had nothing but blanks.
    is_line_new: bool,
    /// Where the line begins.
    line_start: usize,
    /// The end of what stands before, without comments.
    last_end: usize,
    /// How many braces are open, and how many parentheses inside the innermost.
    braces: usize,
    parentheses: usize,
    marks: Vec<Mark>,
    comments: Vec<Span>,
    errors: Vec<Diagnostic>,
    wrong: Vec<usize>,
    /// Spans of the text to parse, each with the character that stands there instead of what it was.
    mended: Vec<(Span, u8)>,
    is_too_deep: bool,
    /// Whether a text without its closing quote has braces in it.
    hides_braces: bool,
}

impl<'t> Scanner<'t> {
    fn new(file_name: &'t str, text: &'t str) -> Self {
        Self {
            file_name,
            text,
            at: 0,
            is_line_new: true,
            line_start: 0,
            last_end: 0,
            braces: 0,
            parentheses: 0,
            marks: Vec::new(),
            comments: Vec::new(),
            errors: Vec::new(),
            wrong: Vec::new(),
            mended: Vec::new(),
            is_too_deep: false,
            hides_braces: false,
        }
    }

    fn run(&mut self) {
        while let Some(character) = self.text[self.at..].chars().next() {
            let rest = &self.text[self.at..];
            let end = self.at + character.len_utf8();
            match character {
                '\n' => (self.is_line_new, self.line_start) = (true, end),
                ' ' | '\t' | '\u{feff}' => {}
                '\r' if rest.starts_with("\r\n") => {}
                '/' if rest.starts_with("//") => {
                    self.comment();
                    continue;
                }
                c if c.is_control() => self.control(self.at, c),
                c => {
                    self.token(c);
                    continue;
                }
            }
            self.at = end;
        }
    }

    /// Anything but blanks and comments.
    fn token(&mut self, first: char) {
        if std::mem::take(&mut self.is_line_new) {
            let indentation = self.text[self.line_start..self.at].chars().count();
            self.marks.push(Mark::Line { indentation, closes: first == '}', gap: self.last_end..self.at });
        }
        match first {
            '"' => self.quoted(),
            '{' => self.opened(),
            '}' => self.closed(),
            '(' => self.parenthesis(self.parentheses + 1),
            ')' => self.parenthesis(self.parentheses.saturating_sub(1)),
            _ => {}
        }
        self.at += if first == '"' { 0 } else { first.len_utf8() };
        self.last_end = self.at;
    }

    fn error(&mut self, code: &'static Code, message: String, span: Span, label: &str) {
        let place = place(self.file_name, self.text, &span);
        self.push(span.start, Diagnostic::error(code, message).at(place, label));
    }

    fn push(&mut self, at: usize, diagnostic: Diagnostic) {
        self.wrong.push(at);
        if self.errors.len() < MOST_ERRORS {
            self.errors.push(diagnostic);
        }
    }

    fn control(&mut self, at: usize, character: char) {
        let message = format!("the control character U+{:04X} does not belong in a machine file", character as u32);
        let span = at..at + character.len_utf8();
        self.error(&CONTROL_CHARACTER, message, span.clone(), "");
        self.mended.push((span, NO_STATEMENT));
    }

    /// Up to the end of the line.
    fn comment(&mut self) {
        let rest = &self.text[self.at..];
        let line = rest.find('\n').map_or(rest, |end| &rest[..end]).trim_end_matches('\r');
        self.controls(self.at, line);
        self.comments.push(self.at..self.at + line.len());
        self.at += line.len();
    }

    /// Control characters in a comment or a text.
    fn controls(&mut self, start: usize, part: &str) {
        for (at, control) in part.char_indices().filter(|(_, c)| c.is_control() && *c != '\t') {
            self.control(start + at, control);
        }
    }

    /// Up to behind the closing quote.
    fn quoted(&mut self) {
        let start = self.at;
        let mut characters = self.text[start + 1..].char_indices().map(|(at, c)| (start + 1 + at, c));
        while let Some((at, character)) = characters.next() {
            match character {
                '"' => return self.ended(start, at + 1),
                '\\' => match characters.next() {
                    Some((_, '"' | '\\')) => {}
                    Some((_, '\n' | '\r')) | None => break,
                    Some(_) => self.unknown_escape(at),
                },
                '\n' | '\r' => break,
                _ => {}
            }
        }
        self.unterminated(start);
    }

    /// A text with its closing quote. With something wrong in it, nobody knows what it says.
    fn ended(&mut self, start: usize, end: usize) {
        self.controls(start, &self.text[start..end]);
        if self.wrong.last().is_some_and(|wrong| *wrong > start) {
            self.mended.push((start..end, NO_STATEMENT));
        }
        self.at = end;
    }

    /// A text up to the end of its line, but for braces there that close what was opened before.
    fn unterminated(&mut self, start: usize) {
        let line = self.text[start..].lines().next().unwrap_or("").trim_end();
        let message = "this text has no closing quote on its line".to_owned();
        self.error(&UNTERMINATED_TEXT, message, start..start + line.len(), "begins here");
        let count = |text: &str, brace: char| text.matches(brace).count();
        let mut text = line;
        while let Some(shorter) = text.strip_suffix('}').filter(|_| count(text, '{') < count(text, '}')) {
            text = shorter.trim_end();
        }
        self.hides_braces |= text.contains(['{', '}']);
        self.at = start + text.len();
        self.mended.push((start..self.at, NO_STATEMENT));
    }

    fn unknown_escape(&mut self, at: usize) {
        let place = place(self.file_name, self.text, &(at..at + 1));
        let suggestion = Suggestion {
            text: "a backslash is written twice".to_owned(),
            place: place.clone(),
            replacement: "\\\\".to_owned(),
        };
        let message = "a backslash stands only before a quote or another backslash";
        self.push(at, Diagnostic::error(&UNKNOWN_ESCAPE, message).at(place, "").suggest(suggestion));
    }

    fn opened(&mut self) {
        self.parentheses = 0;
        self.braces += 1;
        match self.braces > MOST_NESTED {
            true => self.too_deep(),
            false => self.marks.push(Mark::Open(self.at)),
        }
    }

    fn closed(&mut self) {
        self.parentheses = 0;
        match self.braces > MOST_NESTED {
            true => self.mended.push((self.at..self.at + 1, NO_STATEMENT)),
            false => self.marks.push(Mark::Close(self.at)),
        }
        self.braces = self.braces.saturating_sub(1);
    }

    /// Of a parenthesis that makes so many.
    fn parenthesis(&mut self, open: usize) {
        if self.braces + open.max(self.parentheses) > MOST_NESTED {
            self.too_deep();
        }
        self.parentheses = open;
    }

    /// Takes a brace or a parenthesis out; the first is told.
    fn too_deep(&mut self) {
        if !self.is_too_deep {
            let message = format!("more than {MOST_NESTED} braces and parentheses are open here");
            self.error(&TOO_DEEP, message, self.at..self.at + 1, "");
        }
        self.is_too_deep = true;
        self.mended.push((self.at..self.at + 1, NO_STATEMENT));
    }

    fn finish(mut self) -> Scan<'t> {
        let unpaired = unpaired(&self.marks);
        for at in &unpaired.surplus {
            let is_inside = goes_on(&self.text[at + 1..]);
            self.wrong.extend(is_inside.then_some(*at));
            self.mended.push((*at..at + 1, if is_inside { NO_STATEMENT } else { b' ' }));
        }
        for gaps in unpaired.missing.chunk_by(|a, b| a == b) {
            let Span { start, end } = gaps[0];
            self.mended.extend([(start..end, b' '), (end - gaps.len()..end, b'}')]);
        }
        Scan {
            comments: self.comments,
            text: mended(self.text, &self.mended),
            errors: self.errors,
            wrong: self.wrong,
            tells_unpaired: !self.hides_braces && !self.is_too_deep,
            unpaired,
        }
    }
}

/// Whether a line has more than braces, blanks and a comment.
fn goes_on(line: &str) -> bool {
    let rest = line.trim_start_matches([' ', '\t', '\r', '{', '}']);
    !rest.is_empty() && !rest.starts_with('\n') && !rest.starts_with("//")
}

/// A character with which no statement can begin, nor go on.
const NO_STATEMENT: u8 = b'$';

/// The text with other characters in some places.
fn mended<'t>(text: &'t str, places: &[(Span, u8)]) -> Cow<'t, str> {
    if places.is_empty() {
        return Cow::Borrowed(text);
    }
    let mut bytes = text.as_bytes().to_vec();
    for (span, byte) in places {
        bytes[span.clone()].fill(*byte);
    }
    Cow::Owned(String::from_utf8(bytes).expect("whole characters give way to ASCII"))
}
