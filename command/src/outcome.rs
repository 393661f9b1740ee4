//! What a command came to, and its exit status: 0 done, 1 the input has errors, 2 wrong usage or a file that cannot be
//! read or written.

/// What a command came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// It did what it was asked for.
    Done,
    /// The input has errors, and they have been told.
    Refused,
}

/// Wrong usage, or a file that cannot be read or written: what is to be said of it.
#[derive(Debug)]
pub struct Failure(pub String);
