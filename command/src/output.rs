//! Output that appears whole or not at all.
//!
//! Everything goes to a temporary file first: one beside the target, which takes the target's name at the end; or one
//! that is copied at the end, when the target is standard output or no ordinary file.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, ErrorKind, Seek, Write, stdout};
use std::path::{Path, PathBuf};

use serde::Serialize;
use tempfile::{Builder, NamedTempFile, tempfile};

use crate::files::cannot_write;
use crate::outcome::Failure;

/// Output under way; dropped without [`Output::commit`], it leaves nothing behind.
#[derive(Debug)]
pub struct Output {
    spool: BufWriter<Spool>,
    name: String,
    error: Option<Failure>,
}

#[derive(Debug)]
enum Spool {
    /// Takes the place of this path.
    Beside(NamedTempFile, PathBuf),
    /// Is copied to this path, or to standard output.
    Apart(File, Option<PathBuf>),
}

impl Output {
    /// Begins output to a file; to standard output without a path, or with the path `-`.
    pub fn begin(path: Option<&str>) -> Result<Self, Failure> {
        let path = path.filter(|path| *path != "-");
        let name = path.unwrap_or("<stdout>").to_owned();
        let spool = Spool::begin(path).map_err(|error| cannot_write(&name, &error))?;
        Ok(Self { spool: BufWriter::with_capacity(1 << 18, spool), name, error: None })
    }

    /// Lets the output appear.
    pub fn commit(self) -> Result<(), Failure> {
        let Self { spool, name, .. } = self;
        let spool = spool.into_inner().map_err(io::IntoInnerError::into_error);
        spool.and_then(Spool::commit).map_err(|error| cannot_write(&name, &error))
    }

    /// Why writing did not succeed, if it did not.
    pub fn into_failure(self) -> Option<Failure> {
        self.error
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.spool.write(bytes).inspect_err(|error| self.error = Some(cannot_write(&self.name, error)))
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Spool {
    fn begin(path: Option<&str>) -> io::Result<Self> {
        let Some(path) = path else { return Ok(Self::Apart(tempfile()?, None)) };
        // Through a symbolic link to what it points to: the link stays.
        let target = fs::canonicalize(path).unwrap_or_else(|_| PathBuf::from(path));
        match fs::metadata(&target) {
            Ok(found) if found.is_dir() => return Err(ErrorKind::IsADirectory.into()),
            Ok(found) if !found.is_file() => return Ok(Self::Apart(tempfile()?, Some(target))),
            Ok(found) if found.permissions().readonly() => return Err(ErrorKind::PermissionDenied.into()),
            _ => {}
        }
        let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Ok(Self::Beside(usual_permissions(&mut Builder::new()).prefix(".machc-").tempfile_in(folder)?, target))
    }

    fn commit(self) -> io::Result<()> {
        match self {
            Self::Beside(file, target) => {
                if let Ok(found) = fs::metadata(&target) {
                    file.as_file().set_permissions(found.permissions())?;
                }
                file.persist(target).map(drop).map_err(|error| error.error)
            }
            Self::Apart(mut file, target) => {
                file.rewind()?;
                let copied = match target {
                    Some(target) => io::copy(&mut file, &mut OpenOptions::new().write(true).open(target)?),
                    None => {
                        io::copy(&mut file, &mut stdout().lock()).and_then(|bytes| stdout().flush().map(|()| bytes))
                    }
                };
                quiet_when_nobody_listens(copied.map(drop))
            }
        }
    }
}

impl Write for Spool {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Beside(file, _) => file.write(bytes),
            Self::Apart(file, _) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Writes a whole file, and the folder it is in where that is missing.
pub fn write_file(path: &Path, text: &str) -> Result<(), Failure> {
    let name = path.to_string_lossy();
    let folder = path.parent().unwrap_or(Path::new(""));
    fs::create_dir_all(folder).map_err(|error| cannot_write(&folder.to_string_lossy(), &error))?;
    let mut output = Output::begin(Some(&name))?;
    output.write_all(text.as_bytes()).map_err(|error| cannot_write(&name, &error))?;
    output.commit()
}

/// Writes to standard output.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = stdout().lock();
    let written = stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush());
    quiet_when_nobody_listens(written).map_err(|error| cannot_write("<stdout>", &error))
}

/// Lines for standard output, as they come.
#[derive(Debug)]
pub struct Lines {
    text: Vec<u8>,
}

impl Lines {
    /// Nothing written yet.
    pub fn stdout() -> Self {
        Self { text: Vec::new() }
    }

    /// Adds a line of text; it appears with the next [`Lines::flush`].
    pub fn add_text(&mut self, line: &str) {
        self.text.extend_from_slice(line.as_bytes());
        self.text.push(b'\n');
    }

    /// Writes the lines once they are many, and says whether anybody reads them.
    pub fn flush_many(&mut self) -> Result<bool, Failure> {
        if self.text.len() < MANY { Ok(true) } else { self.flush() }
    }

    /// Adds a line of JSON; it appears with the next [`Lines::flush`].
    pub fn add(&mut self, line: &impl Serialize) {
        serde_json::to_writer(&mut self.text, line).expect("lines are plain data");
        self.text.push(b'\n');
    }

    /// Writes the lines, and says whether anybody reads them.
    pub fn flush(&mut self) -> Result<bool, Failure> {
        let mut stdout = stdout().lock();
        let written = stdout.write_all(&self.text).and_then(|()| stdout.flush());
        self.text.clear();
        match written {
            Ok(()) => Ok(true),
            Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(false),
            Err(error) => Err(cannot_write("<stdout>", &error)),
        }
    }
}

/// So many bytes are worth a call of the system.
const MANY: usize = 1 << 16;

/// A reader that has seen enough (`… | head`) is no failure.
fn quiet_when_nobody_listens(written: io::Result<()>) -> io::Result<()> {
    match written {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        written => written,
    }
}

/// Temporary files are made for their owner only; this one is to become an ordinary file.
#[cfg(unix)]
fn usual_permissions<'a>(builder: &'a mut Builder<'static, 'static>) -> &'a mut Builder<'static, 'static> {
    use std::os::unix::fs::PermissionsExt;
    builder.permissions(fs::Permissions::from_mode(0o666))
}

#[cfg(not(unix))]
fn usual_permissions<'a>(builder: &'a mut Builder<'static, 'static>) -> &'a mut Builder<'static, 'static> {
    builder
}
