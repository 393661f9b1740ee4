//! The machine, with units resolved and names turned into ids.
//!
//! `load` reads the files, `library` and `family` find out what is said of the machine, `describe` evaluates it into a
//! `draft`, `build` makes a checked draft the model, and `tables` are what the runtime has of it.

pub mod axis_line;
pub(crate) mod build;
pub mod class;
pub mod controller;
pub(crate) mod describe;
pub(crate) mod dh;
pub(crate) mod dialect;
pub(crate) mod directions;
pub(crate) mod draft;
pub(crate) mod error_name;
pub mod errors;
pub(crate) mod evaluate;
pub(crate) mod family;
pub(crate) mod field;
pub(crate) mod library;
pub(crate) mod load;
pub mod lost;
pub mod machine;
pub(crate) mod measured;
pub mod number;
pub mod origin;
pub(crate) mod parameter;
pub(crate) mod quantity;
pub mod source;
pub(crate) mod subject;
pub mod tables;
