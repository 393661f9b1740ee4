//! Files to read. `-` is standard input.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, stdin};
use std::path::Path;

use crate::outcome::Failure;

/// The text of a file.
pub fn text(path: &str) -> io::Result<String> {
    if path == "-" { io::read_to_string(stdin()) } else { fs::read_to_string(path) }
}

/// A file, opened, and its size where it is known.
pub fn open(path: &str) -> Result<(Box<dyn Read>, Option<u64>), Failure> {
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
pub fn reopened(path: &str) -> Option<File> {
    if path != "-" && Path::new(path).is_file() { File::open(path).ok() } else { None }
}

/// The name that a file has in diagnostics.
pub fn shown(path: &str) -> &str {
    if path == "-" { "<stdin>" } else { path }
}

/// The file's name without folder and extension; nothing for standard input.
pub fn stem(path: &str) -> Option<&str> {
    Path::new(path).file_stem()?.to_str().filter(|_| path != "-")
}

/// A file that cannot be read.
pub fn cannot_read(path: &str, error: &io::Error) -> Failure {
    Failure(format!("cannot read `{}`: {}", shown(path), reason(error)))
}

/// A file that cannot be written.
pub fn cannot_write(path: &str, error: &io::Error) -> Failure {
    let folder = Path::new(path).parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.is_dir());
    let why = match (error.kind(), folder) {
        (ErrorKind::NotFound | ErrorKind::NotADirectory, Some(folder)) => {
            format!("there is no folder `{}`", folder.display())
        }
        _ => reason(error),
    };
    Failure(format!("cannot write `{path}`: {why}"))
}

/// Why, in words for people.
pub fn reason(error: &io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => "no such file".to_owned(),
        ErrorKind::IsADirectory => "it is a folder".to_owned(),
        ErrorKind::PermissionDenied => "not allowed".to_owned(),
        ErrorKind::InvalidData => "it is not UTF-8 text".to_owned(),
        _ => error.to_string(),
    }
}
