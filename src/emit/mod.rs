//! What is made of a machine: the runtime's tables, equations for people, and source code.

pub mod c;
pub mod comment;
pub mod data_sheet;
pub mod equations;
pub mod expression;
pub mod function;
pub mod listing;
pub mod names;
pub mod package;
pub mod rust;
pub mod tables;
