//! The lines of an NC program as it is read.

use std::borrow::Cow;
use std::io::{BufRead, BufReader, Read};

use mach_command::files::{cannot_read, open};
use mach_command::outcome::Failure;
use mach_command::progress::watched;
use mach_command::report::Report;

/// A program that has been opened.
pub(super) struct ProgramLines<'a> {
    file: &'a str,
    input: BufReader<Box<dyn Read>>,
    line: Vec<u8>,
    number: u64,
}

impl<'a> ProgramLines<'a> {
    /// Opens it.
    pub(super) fn open(file: &'a str, report: &Report) -> Result<Self, Failure> {
        let (input, bytes) = open(file)?;
        Ok(Self { file, input: BufReader::new(watched(input, bytes, report)), line: Vec::new(), number: 0 })
    }

    /// The next line without its end, and its number from 1. What is no UTF-8 becomes a sign that no control knows.
    pub(super) fn next(&mut self) -> Result<Option<(Cow<'_, str>, u64)>, Failure> {
        let Self { file, input, line, number } = self;
        line.clear();
        if input.read_until(b'\n', line).map_err(|error| cannot_read(file, &error))? == 0 {
            return Ok(None);
        }
        *number += 1;
        let end = line.iter().rposition(|byte| !b"\n\r".contains(byte)).map_or(0, |last| last + 1);
        Ok(Some((String::from_utf8_lossy(&line[..end]), *number)))
    }
}
