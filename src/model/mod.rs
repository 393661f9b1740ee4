//! The machine, with units resolved and names turned into ids.

pub mod machine;
