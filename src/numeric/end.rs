//! How an iteration ended.

/// Which of the three.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    /// The pose is within the bounds.
    There,
    /// No step brings it nearer.
    Nearest,
    /// It came to no end.
    Lost,
}
