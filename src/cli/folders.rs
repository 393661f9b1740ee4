//! Where machine files come from.

use std::env;
use std::fs;
use std::io::ErrorKind;
use std::path::{Component, Path, PathBuf};

use mach_command::files::{reason, text};
use machc::sources::Sources;

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

/// What generated text calls a file: its path as seen from the current folder, and of a file elsewhere its name alone. Where
/// somebody keeps their files is nobody else's business, and would make the text differ from place to place.
pub(super) fn generated_name(path: &str) -> String {
    name_seen_from(&env::current_dir().unwrap_or_default(), path)
}

fn name_seen_from(here: &Path, path: &str) -> String {
    let full = here.join(path).components().fold(PathBuf::new(), |folder, part| match part {
        Component::ParentDir => folder.parent().map(Path::to_owned).unwrap_or_default(),
        part => folder.join(part),
    });
    let inside = full.strip_prefix(here).ok().or_else(|| full.file_name().map(Path::new)).unwrap_or(&full);
    inside.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}

#[cfg(test)]
mod tests {
    use super::name_seen_from;
    use std::path::Path;

    #[test]
    fn generated_text_names_no_folder_outside() {
        for (path, name) in [
            ("machines/a.mach", "machines/a.mach"),
            ("/home/me/mill/machines/a.mach", "machines/a.mach"),
            ("../mill/machines/a.mach", "machines/a.mach"),
            ("/home/me/a.mach", "a.mach"),
            ("../turn/machines/a.mach", "a.mach"),
            ("-", "-"),
        ] {
            assert_eq!(name_seen_from(Path::new("/home/me/mill"), path), name);
        }
    }
}
