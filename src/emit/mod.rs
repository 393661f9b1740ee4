//! What is made of a machine: the runtime's tables, and equations for people.

pub mod data_sheet;
pub mod equations;
mod measured;
pub mod tables;
