//! How much is taken of one file.

/// How deep braces and parentheses may be nested.
pub const MOST_NESTED: usize = 64;
/// No more errors than this are collected from one file.
pub const MOST_ERRORS: usize = 50;
