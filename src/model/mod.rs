//! The machine, with units resolved and names turned into ids.
//!
//! `load` reads the files, `library` and `family` find out what is said of the machine, `describe` evaluates it into a
//! `draft`, and `build` makes a checked draft the model.

pub(crate) mod arithmetic;
pub(crate) mod build;
pub mod controller;
pub(crate) mod describe;
pub(crate) mod dialect;
pub(crate) mod draft;
pub mod errors;
pub(crate) mod evaluate;
pub(crate) mod family;
pub(crate) mod field;
pub(crate) mod function;
pub(crate) mod library;
pub(crate) mod load;
pub mod machine;
pub mod origin;
pub(crate) mod parameter;
pub(crate) mod quantity;
mod scalar;
pub mod source;
mod subject;
