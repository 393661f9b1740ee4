//! machc compiles a data sheet of a machine tool into a post-processor.

pub mod model;
pub mod syntax;
