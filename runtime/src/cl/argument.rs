//! What a record holds: its word, its arguments, and their places.

use std::ops::Range;

use crate::cl::number::number;
use crate::cl::record::{Record, decoded, line_feeds};
use crate::diagnostic::{Code, Diagnostic, Place};

/// An argument is missing.
pub(super) static MISSING_ARGUMENT: Code = Code {
    id: "E1012",
    title: "a record has too few or too many arguments",
    explanation: "\
The record needs other arguments than it has. A GOTO takes three numbers (the tip) or six (the tip and the tool axis):

    GOTO/10.0,20.0,30.0
    GOTO/10.0,20.0,30.0,0.0,0.0,1.0

An MSYS takes nine: the origin, the direction of X, the direction of Y. With another number of them nobody knows which one is
missing, and where the points behind it are.
",
};

/// An argument that should be a number.
pub(super) static NOT_A_NUMBER: Code = Code {
    id: "E1013",
    title: "an argument is not a number",
    explanation: "\
A number is written with digits, at most one decimal point, a sign and an exponent: `25.`, `-.5`, `1.5E-3`. There are no
blanks and no decimal commas in it.
",
};

impl Record {
    /// The word in capitals, blanks squeezed: `TOOL PATH`.
    pub(super) fn word(&self) -> String {
        let word = String::from_utf8_lossy(&self.text[self.word.clone()]);
        word.split_ascii_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// How many arguments there are.
    pub(super) fn len(&self) -> usize {
        self.arguments.len()
    }

    /// The argument in capitals; empty when there is none.
    pub(super) fn argument(&self, index: usize) -> &str {
        let bytes = self.arguments.get(index).map_or(&[][..], |range| &self.text[range.clone()]);
        str::from_utf8(bytes).unwrap_or("")
    }

    /// The arguments of these indices with the commas between them, as they were written.
    pub(super) fn name(&self, indices: Range<usize>) -> String {
        let ends = self.arguments.get(indices.start).zip(self.arguments.get(indices.end.wrapping_sub(1)));
        ends.map_or(String::new(), |(first, last)| decoded(&self.raw[first.start..last.end.max(first.start)]))
    }

    /// The argument as a finite number.
    pub(super) fn number(&self, index: usize) -> Result<f64, Diagnostic> {
        let Some(range) = self.arguments.get(index) else {
            return Err(self.missing(index, "a number is missing here"));
        };
        match number(&self.text[range.clone()]) {
            Some(value) if value.is_finite() => Ok(value),
            _ => {
                let found = decoded(&self.raw[range.clone()]);
                let message = match found.is_empty() {
                    true => format!("{} has an empty argument where a number belongs", self.word()),
                    false => format!("`{}` is not a number", shortened(&found)),
                };
                Err(Diagnostic::error(&NOT_A_NUMBER, message).at(self.place_of(index), "expected a number"))
            }
        }
    }

    /// As many numbers from this argument on.
    pub(super) fn numbers<const N: usize>(&self, from: usize) -> Result<[f64; N], Diagnostic> {
        let mut values = [0.0; N];
        for (offset, value) in values.iter_mut().enumerate() {
            *value = self.number(from + offset)?;
        }
        Ok(values)
    }

    /// An error about an argument that is not there.
    pub(super) fn missing(&self, index: usize, text: &str) -> Diagnostic {
        let given = if self.len() == 1 && self.argument(0).is_empty() { 0 } else { self.len() };
        let message = format!("{} has {}", self.word(), counted(given));
        Diagnostic::error(&MISSING_ARGUMENT, message).at(self.place_of(index), text)
    }

    /// The place of the word.
    pub(super) fn place(&self) -> Place {
        self.place_at(self.word.clone())
    }

    /// The place of an argument; behind the last one where there is none of this index.
    pub(super) fn place_of(&self, index: usize) -> Place {
        let end = self.arguments.last().map_or(self.word.end, |range| range.end);
        self.place_at(self.arguments.get(index).cloned().unwrap_or(end..end))
    }

    /// The place of all arguments that stand in the line of the first.
    pub(super) fn place_of_all(&self) -> Place {
        let start = self.arguments.first().map_or(self.word.start, |range| range.start);
        let end = self.arguments.last().map_or(self.word.end, |range| range.end);
        self.place_at(start..end)
    }

    /// A place in the record's first marked line.
    pub(super) fn place_at(&self, mark: Range<usize>) -> Place {
        let before = &self.raw[..mark.start];
        let line_start = memchr::memrchr(b'\n', before).map_or(0, |feed| feed + 1);
        let line_end = memchr::memchr(b'\n', &self.raw[mark.start..]).map_or(self.raw.len(), |feed| mark.start + feed);
        let mark_end = mark.end.min(line_end);
        let head = decoded(&self.raw[line_start..mark.start]);
        let marked = decoded(&self.raw[mark.start..mark_end]);
        Place {
            file: self.file.clone(),
            line: self.first_line + line_feeds(before),
            column: head.chars().count() as u64 + 1,
            start: head.len(),
            end: head.len() + marked.len(),
            excerpt: head + &marked + &decoded(&self.raw[mark_end..line_end]),
        }
    }
}

/// At most 40 characters of a text, for a message.
pub(super) fn shortened(text: &str) -> String {
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

/// "no arguments", "1 argument", "2 arguments".
fn counted(count: usize) -> String {
    match count {
        0 => "no arguments".to_owned(),
        1 => "1 argument".to_owned(),
        _ => format!("{count} arguments"),
    }
}
