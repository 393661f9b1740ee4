//! Which file a span belongs to: a machine is put together from several.

use crate::syntax::tree::Span;
use mach_runtime::diagnostic::Place;

/// A file that has been read: an index into its [`SourceMap`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct SourceId(usize);

/// A span and its file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Location {
    /// The file.
    pub source: SourceId,
    /// The bytes.
    pub span: Span,
}

impl Location {
    /// Another span of the same file.
    pub fn with(&self, span: &Span) -> Self {
        Self { source: self.source, span: span.clone() }
    }
}

/// Something and where it was said.
#[derive(Debug, Clone, PartialEq)]
pub struct Located<T> {
    /// What.
    pub value: T,
    /// Where.
    pub at: Location,
}

/// Every file that was read, in the order of reading: the entry first.
#[derive(Debug, Default)]
pub struct SourceMap {
    files: Vec<(String, String)>,
}

impl SourceMap {
    /// Keeps a file's name and text.
    pub fn add(&mut self, name: String, text: String) -> SourceId {
        self.files.push((name, text));
        SourceId(self.files.len() - 1)
    }

    /// The file of this name, if it has been read.
    pub fn find(&self, name: &str) -> Option<SourceId> {
        self.files.iter().position(|(known, _)| known == name).map(SourceId)
    }

    /// Every file, in the order of reading.
    pub fn ids(&self) -> impl Iterator<Item = SourceId> + use<> {
        (0..self.files.len()).map(SourceId)
    }

    /// A file's name, as the user or the using file says it.
    pub fn name(&self, source: SourceId) -> &str {
        &self.files[source.0].0
    }

    /// A file's text.
    pub fn text(&self, source: SourceId) -> &str {
        &self.files[source.0].1
    }

    /// A location as a diagnostic shows it.
    pub fn place(&self, at: &Location) -> Place {
        crate::syntax::place::place(self.name(at.source), self.text(at.source), &at.span)
    }
}
