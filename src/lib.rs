//! machc compiles a data sheet of a machine tool into a post-processor.
//!
//! A program posts without any command:
//!
//! ```
//! use machc::compile::compile;
//! use std::fs;
//!
//! let read = |path: &str| fs::read_to_string(path).map_err(|error| error.to_string());
//! let compiled = compile("machines/tmv710a.mach", &read).expect("a machine without mistakes");
//! let rig = compiled.rig().expect("it names a controller");
//! let posted = rig.post_text("cone.cls", &fs::read("examples/cone.cls")?);
//! println!("{}", posted.certificate.expect("the machine can go there"));
//! assert!(posted.nc.starts_with(b"%"));
//! # Ok::<(), std::io::Error>(())
//! ```

mod check;
pub mod codes;
pub mod compare;
pub mod compile;
pub mod derive;
pub mod emit;
pub mod model;
pub mod numeric;
pub mod plan;
pub mod prove;
mod rig;
pub mod snapshot;
pub mod sources;
pub mod syntax;

pub use mach_runtime::diagnostic;
