//! Text to tree and tree to text.

pub mod parse;
pub mod place;
pub mod print;
pub mod spelling;
pub mod tree;
pub mod unit;
