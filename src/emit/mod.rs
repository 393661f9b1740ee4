//! What is made of a machine: the runtime's tables, and equations for people.

pub mod comment;
pub mod data_sheet;
pub mod equations;
pub mod expression;
pub mod function;
pub mod listing;
mod measured;
pub mod names;
pub mod package;
pub mod rust;
pub mod tables;
