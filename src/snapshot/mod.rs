//! Locked output: what a post of a program gives, as a text to be compared with the one that was accepted.

pub mod content;
pub mod file;
