//! Files to read. `-` is standard input.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, stdin};
use std::path::{Component, Path};

use machc::compile::Sources;

use super::{Failure, builtin};

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

/// The text of a file.
pub(super) fn text(path: &str) -> io::Result<String> {
    if path == "-" { io::read_to_string(stdin()) } else { fs::read_to_string(path) }
}

/// A file, opened, and its size where it is known.
pub(super) fn open(path: &str) -> Result<(Box<dyn Read>, Option<u64>), Failure> {
    if path == "-" {
        return Ok((Box::new(stdin().lock()), None));
    }
    let opened = File::open(path).and_then(|file| {
        let metadata = file.metadata()?;
        if metadata.is_dir() { Err(ErrorKind::IsADirectory.into()) } else { Ok((file, metadata)) }
    });
    let (file, metadata) = opened.map_err(|error| cannot_read(path, &error))?;
    Ok((Box::new(file), metadata.is_file().then_some(metadata.len())))
}

/// A file for a second look; nothing where there is none to be had. To open a pipe, or standard input while its reader is
/// still there, would be to wait for ever.
pub(super) fn reopened(path: &str) -> Option<File> {
    if path != "-" && Path::new(path).is_file() { File::open(path).ok() } else { None }
}

/// The name that a file has in diagnostics.
pub(super) fn shown(path: &str) -> &str {
    if path == "-" { "<stdin>" } else { path }
}

/// The file's name without folder and extension; nothing for standard input.
pub(super) fn stem(path: &str) -> Option<&str> {
    Path::new(path).file_stem()?.to_str().filter(|_| path != "-")
}

pub(super) fn cannot_read(path: &str, error: &io::Error) -> Failure {
    Failure(format!("cannot read `{}`: {}", shown(path), reason(error)))
}

pub(super) fn cannot_write(path: &str, error: &io::Error) -> Failure {
    Failure(format!("cannot write `{path}`: {}", reason(error)))
}

/// In words for people.
fn reason(error: &io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => "no such file".to_owned(),
        ErrorKind::IsADirectory => "it is a folder".to_owned(),
        ErrorKind::PermissionDenied => "not allowed".to_owned(),
        ErrorKind::InvalidData => "it is not UTF-8 text".to_owned(),
        _ => error.to_string(),
    }
}
