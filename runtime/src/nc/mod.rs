//! NC text: the dialect's tables, and the writer that prints by them.

pub mod axis_word;
pub mod dialect;
mod line;
pub mod picture;
pub mod text;
pub mod write_error;
pub mod writer;
