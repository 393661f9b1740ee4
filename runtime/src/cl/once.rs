//! Warnings that are given once a file.

use crate::cl::record::Record;
use crate::diagnostic::{Code, Diagnostic};

/// Text that goes to the control as it is.
pub(super) static INSERTED: Code = Code {
    id: "W1005",
    title: "the text of an INSERT becomes a comment",
    explanation: "\
INSERT hands its text to the control as it is. Such text cannot be checked, so it is written as a comment. Reported once a
file.
",
};

/// Warnings that are given once a file, at its end.
#[derive(Debug, Default)]
pub(super) struct Once {
    pub(super) not_unit: Option<(Diagnostic, u64)>,
    inserted: Option<Diagnostic>,
}

impl Once {
    /// The warnings, with how often there was a cause.
    pub(super) fn take(&mut self) -> Vec<Diagnostic> {
        let not_unit = self.not_unit.take().map(|(first, count)| match count {
            1 => first,
            _ => first.note(format!("{count} records of the file have such a direction")),
        });
        [self.inserted.take(), not_unit].into_iter().flatten().collect()
    }

    /// Remembers the first INSERT.
    pub(super) fn inserted(&mut self, record: &Record) {
        let warning = || Diagnostic::warning(&INSERTED, "the text of an INSERT is written as a comment");
        self.inserted.get_or_insert_with(|| warning().at(record.place(), "not handed to the control"));
    }
}
