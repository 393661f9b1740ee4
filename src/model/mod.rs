//! The machine, with units resolved and names turned into ids.

pub mod controller;
pub mod machine;
