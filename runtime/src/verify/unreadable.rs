//! Lines that the control does not understand.

use crate::control::Fault;
use crate::diagnostic::{Code, Diagnostic, Place};

/// So many of them are told.
const MOST: u32 = 20;

/// E1201.
pub static UNREADABLE: Code = Code {
    id: "E1201",
    title: "the control would not understand this block",
    explanation: "\
The program is read by the table of the machine's controller: its words, and the groups and codes that it declares. What stands
here is in none of them, or not in this way, and nothing of a program is skipped.

If it is a code of the machine's builder that moves nothing, declare it in the machine's own `controller` block:

    plain \"M11\" \"the C axis is unclamped\"

A code that means something is declared in its group. `docs/language.md` lists the groups.",
};

/// Those of a program.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unreadable {
    met: u32,
}

impl Unreadable {
    /// Notes one, and tells of the first ones.
    pub fn meet(
        &mut self,
        file: &str,
        (text, number): (&str, u64),
        (mistake, span): Fault,
        tell: &mut dyn FnMut(Diagnostic),
    ) {
        self.met += 1;
        if self.met <= MOST {
            let place = place(file, number, text, span);
            tell(Diagnostic::error(&UNREADABLE, mistake.to_string()).at(place, ""));
        }
    }
}

/// A place in a line that is at hand.
fn place(file: &str, number: u64, text: &str, span: std::ops::Range<usize>) -> Place {
    let start = span.start.min(text.len());
    let end = span.end.clamp(start, text.len());
    let column = text[..start].chars().count() as u64 + 1;
    Place { file: file.to_owned(), line: number, column, excerpt: text.to_owned(), start, end }
}
