//! machc compiles a data sheet of a machine tool into a post-processor.

pub mod derive;
pub mod emit;
pub mod model;
pub mod plan;
pub mod syntax;
