//! Where machine files come from.

use std::fs;
use std::io::ErrorKind;
use std::path::{Component, Path};

use mach_command::files::{reason, text};
use machc::compile::Sources;

use super::builtin;

/// Machine files, from the folders they are in. A controller that is not there is the one that machc brings along.
#[derive(Debug)]
pub(super) struct Folders<'a> {
    /// Where paths start from; empty for the current folder.
    pub(super) base: &'a Path,
    /// The file that the user names: nothing stands in for it.
    pub(super) entry: &'a str,
}

impl Sources for Folders<'_> {
    fn read(&self, path: &str) -> Result<String, String> {
        let file = self.base.join(path);
        let found = if path == "-" { text(path) } else { fs::read_to_string(file) };
        let stand_in = || builtin::stand_in(path).filter(|_| !is_same(path, self.entry)).map(str::to_owned);
        match found {
            Err(error) if error.kind() == ErrorKind::NotFound => stand_in().ok_or_else(|| reason(&error)),
            found => found.map_err(|error| reason(&error)),
        }
    }
}

/// Whether two paths are one but for `.` parts.
fn is_same(a: &str, b: &str) -> bool {
    let parts = |path| Path::new(path).components().filter(|part| *part != Component::CurDir);
    parts(a).eq(parts(b))
}
