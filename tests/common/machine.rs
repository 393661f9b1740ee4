//! Machine files, compiled.

use mach_command::render::plain;
use machc::compile::{Compiled, compile};
use machc::sources::Sources;
use std::fs;
use std::path::{Path, PathBuf};

/// The package's folder.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_owned()
}

/// Files below the package's folder.
pub(crate) struct Files;

impl Sources for Files {
    fn read(&self, path: &str) -> Result<String, String> {
        fs::read_to_string(root().join(path)).map_err(|error| error.to_string())
    }
}

/// The machine of a file without mistakes and warnings.
pub(crate) fn compiled(path: &str, sources: &dyn Sources) -> Compiled {
    let compiled = compile(path, sources).unwrap_or_else(|errors| panic!("{}", plain(&errors)));
    assert!(compiled.warnings.is_empty(), "{}", plain(&compiled.warnings));
    compiled
}
