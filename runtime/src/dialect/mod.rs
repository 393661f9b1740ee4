//! A controller's dialect as data: what its texts mean, read both ways.

pub mod meaning;
pub mod names;
pub mod pattern;
pub mod table;
