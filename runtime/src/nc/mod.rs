//! NC text: the dialect's tables, and the writer that prints by them.

pub mod dialect;
