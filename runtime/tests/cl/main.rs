//! The CL reader from outside.

mod bad;
mod good;
mod read;
