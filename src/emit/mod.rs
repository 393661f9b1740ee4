//! What is made of a machine: equations for people, and source code.

pub mod c;
pub mod comment;
pub mod data_sheet;
pub mod equations;
pub mod expression;
pub mod function;
pub mod json;
pub mod latex;
pub mod listing;
mod measured;
pub mod names;
pub mod package;
pub mod rust;
pub mod spelling;
mod transformation;
