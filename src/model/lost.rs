//! What was said and not understood. It has been reported; what may only follow from it is not.

use super::source::{Located, Location, SourceId};
use crate::syntax::tree::{Broken, Span};

/// What of a machine or of a controller was not understood.
#[derive(Debug, Clone, Default)]
pub struct Lost(Vec<Located<Broken>>);

impl Lost {
    /// What is broken in a file.
    pub(crate) fn of(source: SourceId, broken: impl IntoIterator<Item = Broken>) -> Self {
        let located = |broken: Broken| Located { at: Location { source, span: broken.span.clone() }, value: broken };
        Self(broken.into_iter().map(located).collect())
    }

    /// A part of a file of which nothing is known.
    pub(crate) fn anything(source: SourceId, span: Span) -> Self {
        Self::of(source, [Broken::anything(span)])
    }

    /// With what else was not understood.
    pub(crate) fn extend(&mut self, other: Self) {
        self.0.extend(other.0);
    }

    /// Whether everything was understood.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether there is something of this kind among it.
    pub(crate) fn any(&self, is_so: impl Fn(&Broken) -> bool) -> bool {
        self.0.iter().any(|lost| is_so(&lost.value))
    }

    /// Whether a statement with one of these keywords may be among it.
    pub(crate) fn may_be(&self, keywords: &[&str]) -> bool {
        self.any(|broken| broken.may_be(keywords))
    }

    /// Whether such a statement about something of this name may be among it.
    pub(crate) fn may_say(&self, keywords: &[&str], name: &str) -> bool {
        self.any(|broken| broken.may_be(keywords) && broken.may_speak_of(name))
    }

    /// Takes out what is meant.
    pub(crate) fn take<T>(&mut self, meant: impl Fn(&Located<Broken>) -> Option<T>) -> Vec<T> {
        let mut taken = Vec::new();
        self.0.retain(|lost| {
            let found = meant(lost);
            let stays = found.is_none();
            taken.extend(found);
            stays
        });
        taken
    }
}
