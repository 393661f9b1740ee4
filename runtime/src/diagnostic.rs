//! What a diagnostic is: a code, a place, what was found, and the way out.
//!
//! A diagnostic carries the source line it speaks of, so that it can be rendered when the source (a CL file of
//! any size, read as a stream) is long gone.

/// One kind of diagnostic: what `machc explain` prints.
#[derive(Debug, PartialEq, Eq)]
pub struct Code {
    /// Such as `E0204`. `E0…` machine files, `E1…` CL data and posting, `W…` warnings.
    pub id: &'static str,
    /// One line, without a full stop.
    pub title: &'static str,
    /// The long text in Markdown: what is wrong, an example, and how to mend it.
    pub explanation: &'static str,
}

/// Whether the diagnostic stops the work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Severity {
    /// The input is refused.
    Error,
    /// The input is taken, and the user should look at it.
    Warning,
}

/// A place in a source text, with the text around it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The file as the user named it.
    pub file: String,
    /// The line of the excerpt's first character, from 1.
    pub line: u64,
    /// The column of the marked text, in characters from 1.
    pub column: u64,
    /// The source line (for a long line, the part around the mark; for a span of lines, all of them).
    pub excerpt: String,
    /// Where the marked text starts in `excerpt`, in bytes.
    pub start: usize,
    /// Where the marked text ends in `excerpt`, in bytes.
    pub end: usize,
}

impl Place {
    /// A whole line, known by its number only: whoever has the file may fill in the text.
    pub fn line(file: &str, line: u64) -> Self {
        Self { file: file.to_owned(), line, column: 1, excerpt: String::new(), start: 0, end: 0 }
    }
}

/// A place and what is to be said of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// Where.
    pub place: Place,
    /// What; may be empty.
    pub text: String,
}

/// A change that would mend the input.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Suggestion {
    /// Such as "did you mean `X`?".
    pub text: String,
    /// The text to be replaced.
    pub place: Place,
    /// What to write instead.
    pub replacement: String,
}

/// A user's mistake (or something a user should look at).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Its kind.
    pub code: &'static Code,
    /// Whether it stops the work.
    pub severity: Severity,
    /// What is wrong in this very input, in one sentence without a full stop.
    pub message: String,
    /// The cause first; further places after it.
    pub labels: Vec<Label>,
    /// Facts that help to understand.
    pub notes: Vec<String>,
    /// A change that would mend it, where one is known.
    pub suggestion: Option<Box<Suggestion>>,
}

impl Diagnostic {
    /// An error of this kind.
    pub fn error(code: &'static Code, message: impl Into<String>) -> Self {
        Self::new(code, Severity::Error, message.into())
    }

    /// A warning of this kind.
    pub fn warning(code: &'static Code, message: impl Into<String>) -> Self {
        Self::new(code, Severity::Warning, message.into())
    }

    fn new(code: &'static Code, severity: Severity, message: String) -> Self {
        Self { code, severity, message, labels: Vec::new(), notes: Vec::new(), suggestion: None }
    }

    /// Adds a place; the first one added is the cause.
    #[must_use]
    pub fn at(mut self, place: Place, text: impl Into<String>) -> Self {
        self.labels.push(Label { place, text: text.into() });
        self
    }

    /// Adds a fact.
    #[must_use]
    pub fn note(mut self, text: impl Into<String>) -> Self {
        self.notes.push(text.into());
        self
    }

    /// Adds the way out.
    #[must_use]
    pub fn suggest(mut self, suggestion: Suggestion) -> Self {
        self.suggestion = Some(Box::new(suggestion));
        self
    }
}
