//! The feed word, and the code of its kind.

use super::dialect::{Dialect, Word};
use super::line_buffer::LineBuffer;
use super::write_error::WriteError;
use crate::toolpath::Feed;

/// Which feed the control is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FeedMode {
    PerMinute,
    PerRevolution,
}

impl FeedMode {
    /// Its code.
    pub(super) fn code(self, dialect: &Dialect) -> &str {
        match self {
            Self::PerMinute => &dialect.codes.per_minute,
            Self::PerRevolution => dialect.codes.per_revolution.as_deref().unwrap_or_default(),
        }
    }

    fn word(self, dialect: &Dialect) -> &Word {
        match self {
            Self::PerMinute => &dialect.feed,
            Self::PerRevolution => &dialect.feed_per_revolution,
        }
    }
}

/// A feed rate, ready to print.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct FeedState {
    pub(super) mode: FeedMode,
    units: i64,
}

impl FeedState {
    /// The feed in units of its word.
    pub(super) fn new(feed: Feed, dialect: &Dialect) -> Result<Self, WriteError> {
        let (mode, value) = match feed {
            Feed::PerMinute(mm_per_min) => (FeedMode::PerMinute, mm_per_min / dialect.feed_unit_mm()),
            Feed::PerRevolution(mm_per_rev) => (FeedMode::PerRevolution, mm_per_rev / dialect.units.mm()),
        };
        if mode == FeedMode::PerRevolution && dialect.codes.per_revolution.is_none() {
            return Err(WriteError::NoFeedPerRevolution);
        }
        let word = mode.word(dialect);
        let units = word.picture.units(value).ok_or_else(|| WriteError::too_large(word, value))?;
        if units <= 0 {
            return Err(WriteError::NoFeed { value });
        }
        Ok(Self { mode, units })
    }

    /// Prints the word.
    pub(super) fn print(self, dialect: &Dialect, line: &mut LineBuffer) {
        let word = self.mode.word(dialect);
        line.print(|bytes| {
            bytes.extend_from_slice(word.address.as_bytes());
            word.picture.print(self.units, bytes);
        });
    }
}
