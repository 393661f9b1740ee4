//! What has been told already: neither errors nor warnings go on for ever.

use std::collections::BTreeSet;

use crate::diagnostic::{Code, Diagnostic, Severity};

/// After so many errors, and after so many warnings, no more of them are told.
const MOST_OF_A_KIND: u32 = 20;

/// The end of a long list.
pub(super) static TOO_MANY: Code = Code {
    id: "E1006",
    title: "too many errors",
    explanation: "\
After 20 errors reading stops: more of them would help nobody. Often the first one is the cause of the others.
",
};

/// The end of a long list of warnings.
pub(super) static MANY_WARNINGS: Code = Code {
    id: "W1006",
    title: "more warnings are left out",
    explanation: "\
After 20 warnings about one file no more are told.
",
};

/// How much has been told of a file.
#[derive(Debug, Default)]
pub(super) struct Told {
    errors: u32,
    warnings: u32,
    /// The kinds of warnings, each with the word of the record it is about.
    kinds: BTreeSet<(&'static str, String)>,
}

impl Told {
    /// How many errors.
    pub(super) fn errors(&self) -> u32 {
        self.errors
    }

    /// The diagnostic, if it is to be told: every error, and the first warning of each kind about each word.
    pub(super) fn count(&mut self, diagnostic: Diagnostic, word: impl FnOnce() -> String) -> Option<Diagnostic> {
        if diagnostic.severity == Severity::Error {
            self.errors += 1;
            return Some(diagnostic);
        }
        if self.warnings > MOST_OF_A_KIND || !self.kinds.insert((diagnostic.code.id, word())) {
            return None;
        }
        self.warnings += 1;
        let last = || Diagnostic::warning(&MANY_WARNINGS, "more warnings about this file are left out");
        Some(if self.warnings > MOST_OF_A_KIND { last() } else { diagnostic })
    }

    /// What is to be told after this diagnostic, when it was the last that is worth telling.
    pub(super) fn enough(&self, diagnostic: &Diagnostic) -> Option<Diagnostic> {
        let end = || Diagnostic::error(&TOO_MANY, "too many errors: the rest of the file has not been read");
        let place = diagnostic.labels.first().map(|label| label.place.clone());
        (self.errors >= MOST_OF_A_KIND).then(|| place.into_iter().fold(end(), |end, place| end.at(place, "")))
    }
}
