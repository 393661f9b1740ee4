//! Lines to records: a word, its arguments, and the places they stand at.
//!
//! A record is kept twice, byte for byte in step: as it was read, and in capitals with comments and continuation marks
//! blanked. So an offset into the one is an offset into the other, and a mark in the file is found without a table.

use std::io::{self, Read};
use std::ops::Range;

use crate::cl::free_text::is_free_text;
use crate::cl::source::{LONGEST_LINE_BYTES, Source, SourceLine};
use crate::diagnostic::{Code, Diagnostic};

/// What some editors put before UTF-8 text.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";
/// What old programs put after the last line.
const DOS_END: u8 = 0x1a;

/// The input is no text.
pub(super) static NOT_TEXT: Code = Code {
    id: "E1001",
    title: "the file is not CL text",
    explanation: "\
The file holds bytes that no CL text has: NUL bytes, many control characters, or carriage returns where no line ends. It
may be a part file, an archive, a binary CL file, text in UTF-16, or text whose lines end in carriage returns alone.

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
    pub(super) file: String,
    pub(super) raw: Vec<u8>,
    pub(super) text: Vec<u8>,
    pub(super) first_line: u64,
    pub(super) word: Range<usize>,
    pub(super) arguments: Vec<Range<usize>>,
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
                SourceLine::Text(text) => (text, self.raw.len() + text.len() < LONGEST_LINE_BYTES),
                SourceLine::TooLong(head) => (head, false),
            };
            let is_text = is_text(bytes);
            let ends = whole && self.append(bytes);
            if !whole || !is_text {
                if !(continued && is_text) {
                    self.raw = bytes.to_vec();
                    self.first_line = source.line();
                }
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
        self.word = 0..0;
        self.arguments.clear();
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

    fn cut_record(&self) -> Diagnostic {
        let mark = memchr::memrchr(b'$', &self.raw).unwrap_or(0);
        let place = self.place_at(mark..mark + 1);
        Diagnostic::error(&CUT_RECORD, "the file ends where the record should go on").at(place, "goes on after this")
    }

    fn too_long(&self) -> Diagnostic {
        Diagnostic::error(&TOO_LONG, "this record has more than 64 kB").at(self.place_at(0..0), "starts here")
    }

    fn not_text(&self) -> Diagnostic {
        let lone_return = lone_return(&self.raw);
        let odd = lone_return.or_else(|| self.raw.iter().position(|byte| is_odd(*byte))).unwrap_or(0);
        let place = self.place_at(odd..odd + 1);
        let error = Diagnostic::error(&NOT_TEXT, "this is not CL text").at(place, "a byte that no CL text has");
        match self.raw.as_slice() {
            [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => error.note("it looks like text in UTF-16: save it as UTF-8"),
            _ if lone_return.is_some() => error.note("a carriage return alone ends no line: convert the line ends"),
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

pub(super) fn line_feeds(bytes: &[u8]) -> u64 {
    memchr::memchr_iter(b'\n', bytes).count() as u64
}

/// A control character that has no business in a text. (0x0C starts a page.)
fn is_odd(byte: u8) -> bool {
    byte < 0x20 && !matches!(byte, b'\t' | b'\r' | b'\n' | 0x0c | DOS_END) || byte == 0x7f
}

/// Whether the bytes can be a line of text: no NUL, few control characters, no other line in it.
fn is_text(line: &[u8]) -> bool {
    let odd = line.iter().filter(|byte| is_odd(**byte)).count();
    let is_utf16 = line.starts_with(&[0xff, 0xfe]);
    let holds = |byte| memchr::memchr(byte, line).is_some();
    !is_utf16 && !holds(0) && (odd < 4 || odd * 20 < line.len()) && !(holds(b'\r') && lone_return(line).is_some())
}

/// A carriage return with text behind it, as if another line began there.
fn lone_return(line: &[u8]) -> Option<usize> {
    line.trim_ascii_end().iter().position(|byte| *byte == b'\r')
}
