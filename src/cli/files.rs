//! Files to read. `-` is standard input.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, stdin};
use std::path::Path;

use machc::compile::Sources;

use super::Failure;

/// Machine files, from the folders they are in.
#[derive(Debug)]
pub(super) struct Folders;

impl Sources for Folders {
    fn read(&self, path: &str) -> Result<String, String> {
        text(path).map_err(|error| reason(&error))
    }
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
