//! What to do with input that asks for a decision.

/// Which of the two.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Strictness {
    /// Refuse it.
    Error,
    /// Take it and say so.
    Warn,
}
