//! machc compiles a data sheet of a machine tool into a post-processor.

mod check;
pub mod compare;
pub mod compile;
pub mod derive;
pub mod diagnostic;
pub mod emit;
pub mod model;
pub mod numeric;
pub mod plan;
pub mod snapshot;
pub mod syntax;
