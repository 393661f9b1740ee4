//! Lines to records: a word, its arguments, and the places they stand at.
//!
//! A record is kept twice, byte for byte in step: as it was read, and in capitals with comments and continuation marks
//! blanked. So an offset into the one is an offset into the other, and a mark in the file is found without a table.

use std::io::{self, Read};
use std::ops::Range;

use crate::cl::number::number;
use crate::cl::source::{LONGEST_LINE_BYTES, Line, Source};
use crate::cl::words::is_free_text;
use crate::diagnostic::{Code, Diagnostic, Place};

/// What some editors put before UTF-8 text.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";
/// What old programs put after the last line.
const DOS_END: u8 = 0x1a;

/// The input is no text.
pub(super) static NOT_TEXT: Code = Code {
    id: "E1001",
    title: "the file is not CL text",
    explanation: "\
The file holds bytes that no CL text has: NUL bytes or many control characters. It may be a part file, an archive, a
binary CL file or text in UTF-16.

Export the toolpath as CLSF text (in NX: *Output CLSF*, format `CLSF_STANDARD`), in plain ASCII or UTF-8.
",
};

/// A line or record beyond the bound.
pub(super) static TOO_LONG: Code = Code {
    id: "E1002",
    title: "a record is too long",
    explanation: "\
A record, together with the lines that continue it, may have 64 kB. Longer ones are no CL data: the file is damaged, or
its line ends are lost.
",
};

/// The file ends after a continuation mark.
pub(super) static CUT_RECORD: Code = Code {
    id: "E1003",
    title: "the file ends in the middle of a record",
    explanation: "\
A `$` at the end of a line says that the record goes on in the next line, and there is none:

    CIRCLE/0.0,0.0,0.0,0.0,0.0,1.0, $

The file was cut off, perhaps while it was being written or copied. Export it again.
",
};

/// An argument is missing.
pub(super) static MISSING_ARGUMENT: Code = Code {
    id: "E1012",
    title: "a record has too few or too many arguments",
    explanation: "\
The record needs other arguments than it has. A GOTO takes three numbers (the tip) or six (the tip and the tool axis):

    GOTO/10.0,20.0,30.0
    GOTO/10.0,20.0,30.0,0.0,0.0,1.0
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

/// What reading a record came to.
#[derive(Debug)]
pub(super) enum Outcome {
    /// There is one.
    Record,
    /// There is none any more.
    End,
    /// A mistake; reading can go on after it.
    Fault(Diagnostic),
    /// A mistake that makes the rest meaningless.
    Stop(Diagnostic),
}

/// One record. It is read over and over into the same buffers.
#[derive(Debug)]
pub(super) struct Record {
    file: String,
    raw: Vec<u8>,
    text: Vec<u8>,
    first_line: u64,
    word: Range<usize>,
    arguments: Vec<Range<usize>>,
}

impl Record {
    /// An empty record of the file that the user named so.
    pub(super) fn new(file: &str) -> Self {
        let file = file.to_owned();
        Self { file, raw: Vec::new(), text: Vec::new(), first_line: 1, word: 0..0, arguments: Vec::new() }
    }

    /// Reads the next record that is not blank.
    pub(super) fn read<R: Read>(&mut self, source: &mut Source<R>) -> io::Result<Outcome> {
        self.clear();
        loop {
            let continued = !self.raw.is_empty();
            let Some(line) = source.next_line()? else {
                return Ok(if continued { Outcome::Fault(self.cut_record()) } else { Outcome::End });
            };
            let (bytes, whole) = match line {
                Line::Text(text) => (text, self.raw.len() + text.len() < LONGEST_LINE_BYTES),
                Line::TooLong(head) => (head, false),
            };
            let is_text = is_text(bytes);
            let ends = whole && self.append(bytes);
            if !whole || !is_text {
                self.raw = bytes.to_vec();
                self.first_line = source.line();
                return Ok(if is_text { Outcome::Fault(self.too_long()) } else { Outcome::Stop(self.not_text()) });
            }
            if !continued {
                self.first_line = source.line();
            }
            if ends && self.split() {
                return Ok(Outcome::Record);
            }
            if ends {
                self.clear();
            }
        }
    }

    fn clear(&mut self) {
        self.raw.clear();
        self.text.clear();
    }

    /// Adds a line, blanks what is not part of the record, and says whether the record ends here.
    fn append(&mut self, line: &[u8]) -> bool {
        let continued = !self.raw.is_empty();
        if continued {
            self.raw.push(b'\n');
            self.text.push(b' ');
        }
        let from = self.text.len();
        let mark = if from == 0 && is_free_text(line) { None } else { memchr::memchr(b'$', line) };
        let used = mark.unwrap_or(line.len());
        self.raw.extend_from_slice(line);
        self.text
            .extend(line[..used].iter().map(|byte| if *byte == DOS_END { b' ' } else { byte.to_ascii_uppercase() }));
        if line.starts_with(BYTE_ORDER_MARK) {
            self.text[from..from + BYTE_ORDER_MARK.len()].fill(b' ');
        }
        self.text.resize(from + line.len(), b' ');
        match mark {
            None => true,
            Some(at) if line.get(at + 1) == Some(&b'$') => !(continued && line[..at].trim_ascii().is_empty()),
            Some(_) => false,
        }
    }

    /// Finds the word and the arguments; false when the record is blank.
    fn split(&mut self) -> bool {
        let all = trimmed(&self.text, 0..self.text.len());
        let free = is_free_text(&self.text);
        let slash = match free {
            true => self.text[all.clone()].iter().position(|byte| !byte.is_ascii_alphanumeric()),
            false => memchr::memchr(b'/', &self.text[all.clone()]),
        };
        let head = slash.map_or(all.end, |slash| all.start + slash);
        self.word = trimmed(&self.text, all.start..head);
        self.arguments.clear();
        if head < all.end && free {
            self.arguments.push(trimmed(&self.text, head + 1..all.end));
        } else if head < all.end {
            let mut from = head + 1;
            for comma in memchr::memchr_iter(b',', &self.text[head + 1..all.end]) {
                self.arguments.push(trimmed(&self.text, from..head + 1 + comma));
                from = head + 1 + comma + 1;
            }
            self.arguments.push(trimmed(&self.text, from..all.end));
        }
        !all.is_empty()
    }

    /// The line of the record's end.
    pub(super) fn last_line(&self) -> u64 {
        self.first_line + line_feeds(&self.raw)
    }

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
        let message = format!("{} has {}", self.word(), counted(self.len()));
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

    fn place_at(&self, mark: Range<usize>) -> Place {
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

    fn cut_record(&self) -> Diagnostic {
        let mark = memchr::memrchr(b'$', &self.raw).unwrap_or(0);
        let place = self.place_at(mark..mark + 1);
        Diagnostic::error(&CUT_RECORD, "the file ends where the record should go on").at(place, "goes on after this")
    }

    fn too_long(&self) -> Diagnostic {
        Diagnostic::error(&TOO_LONG, "this record has more than 64 kB").at(self.place_at(0..0), "starts here")
    }

    fn not_text(&self) -> Diagnostic {
        let odd = self.raw.iter().position(|byte| is_odd(*byte)).unwrap_or(0);
        let place = self.place_at(odd..odd + 1);
        let error = Diagnostic::error(&NOT_TEXT, "this is not CL text").at(place, "a byte that no CL text has");
        match self.raw.as_slice() {
            [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => error.note("it looks like text in UTF-16: save it as UTF-8"),
            _ => error,
        }
    }
}

/// The range without blanks at its ends.
fn trimmed(text: &[u8], range: Range<usize>) -> Range<usize> {
    let is_blank = |byte: &u8| byte.is_ascii_whitespace();
    let Some(first) = text[range.clone()].iter().position(|byte| !is_blank(byte)) else {
        return range.start..range.start;
    };
    let last = text[range.clone()].iter().rposition(|byte| !is_blank(byte)).unwrap_or(first);
    range.start + first..range.start + last + 1
}

/// UTF-8, or else Latin-1, in which every byte is a character.
pub(super) fn decoded(bytes: &[u8]) -> String {
    str::from_utf8(bytes).map_or_else(|_| bytes.iter().map(|byte| char::from(*byte)).collect(), str::to_owned)
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

fn line_feeds(bytes: &[u8]) -> u64 {
    memchr::memchr_iter(b'\n', bytes).count() as u64
}

/// A control character that has no business in a text. (0x0C starts a page.)
fn is_odd(byte: u8) -> bool {
    byte < 0x20 && !matches!(byte, b'\t' | b'\r' | b'\n' | 0x0c | DOS_END) || byte == 0x7f
}

/// Whether the bytes can be a line of text: no NUL, few control characters.
fn is_text(line: &[u8]) -> bool {
    let odd = line.iter().filter(|byte| is_odd(**byte)).count();
    !line.starts_with(&[0xff, 0xfe]) && memchr::memchr(0, line).is_none() && (odd < 4 || odd * 20 < line.len())
}
