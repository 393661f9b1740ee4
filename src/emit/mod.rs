//! What is made of a machine: the runtime's tables, and equations for people.

pub mod data_sheet;
pub mod equations;
pub mod tables;
