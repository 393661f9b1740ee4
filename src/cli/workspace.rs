//! Where things are: machine files, the programs that belong to them, and their snapshots.
//!
//!     machines/tmv710a.mach         or tmv710a.mach
//!     programs/part.cls             for every machine (or `examples/`)
//!     programs/tmv710a/part.cls     for this machine
//!     snapshots/tmv710a@part.snap

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use mach_command::files::cannot_read;
use mach_command::outcome::Failure;
use machc::syntax::parse::parse;
use machc::syntax::tree::Item;

const MACHINES: &str = "machines";
const PROGRAMS: [&str; 2] = ["programs", "examples"];
const SNAPSHOTS: &str = "snapshots";

/// A folder with machines, programs and snapshots.
#[derive(Debug)]
pub(super) struct Workspace {
    /// The folder; empty for the current one.
    pub(super) folder: PathBuf,
    /// Machine files by the machine's name, as seen from the folder, with `/` between folders.
    pub(super) machines: BTreeMap<String, String>,
    /// Whether these are all of the folder's machines.
    whole: bool,
}

impl Workspace {
    /// What a path of the command line stands for: a machine file, or a folder.
    pub(super) fn of(path: &str) -> Result<Self, Failure> {
        let found = fs::metadata(path).and_then(|found| {
            let path = Path::new(path).strip_prefix(".").unwrap_or(Path::new(path));
            if found.is_dir() { Self::of_folder(path) } else { Ok(Self::of_machine(path)) }
        });
        found.map_err(|error| cannot_read(path, &error))
    }

    fn of_machine(file: &Path) -> Self {
        let folder = file.parent().unwrap_or(Path::new(""));
        let (home, prefix) = home(folder);
        let machines = BTreeMap::from([(stem(file), format!("{prefix}{}", name(file)))]);
        Self { folder: home, machines, whole: false }
    }

    fn of_folder(path: &Path) -> io::Result<Self> {
        let inner = path.join(MACHINES);
        let (folder, prefix) = home(if inner.is_dir() { &inner } else { path });
        let files = files(&folder.join(&prefix), "mach")?;
        let machines = files.into_iter().filter(|(_, file)| defines_machine(file));
        let machines = machines.map(|(stem, file)| (stem, format!("{prefix}{}", name(&file)))).collect();
        Ok(Self { folder, machines, whole: true })
    }

    /// The CL files that belong to a machine by the programs' names, as seen from the folder. Of two with one name the
    /// machine's own counts.
    pub(super) fn programs(&self, machine: &str) -> Result<BTreeMap<String, String>, Failure> {
        let Some(programs) = PROGRAMS.into_iter().find(|programs| self.folder.join(programs).is_dir()) else {
            return Ok(BTreeMap::new());
        };
        let mut found = BTreeMap::new();
        for within in [programs.to_owned(), format!("{programs}/{machine}")] {
            let files = self.files(&within, "cls")?;
            found.extend(files.into_iter().map(|(stem, file)| (stem, format!("{within}/{}", name(&file)))));
        }
        Ok(found)
    }

    /// Where the snapshot `MACHINE@PROGRAM` is.
    pub(super) fn snapshot(&self, name: &str) -> PathBuf {
        self.folder.join(SNAPSHOTS).join(format!("{name}.snap"))
    }

    /// The names of the accepted snapshots that belong to the machines.
    pub(super) fn accepted(&self) -> Result<Vec<String>, Failure> {
        let names = self.files(SNAPSHOTS, "snap")?.into_keys();
        Ok(names.filter(|name| name.contains('@') && self.is_concerned(name)).collect())
    }

    /// The snapshots that wait for a review, as the files that they would become.
    pub(super) fn pending(&self) -> Result<Vec<PathBuf>, Failure> {
        let files = self.files(SNAPSHOTS, "new")?.into_values().map(|file| file.with_extension(""));
        let is_snapshot = |file: &PathBuf| file.extension() == Some(OsStr::new("snap"));
        Ok(files.filter(|file| is_snapshot(file) && self.is_concerned(&stem(file))).collect())
    }

    fn is_concerned(&self, snapshot: &str) -> bool {
        self.whole || snapshot.split_once('@').is_some_and(|(machine, _)| self.machines.contains_key(machine))
    }

    /// The files of a folder with this extension; none where there is no such folder.
    fn files(&self, within: &str, extension: &str) -> Result<BTreeMap<String, PathBuf>, Failure> {
        let folder = self.folder.join(within);
        match files(&folder, extension) {
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(BTreeMap::new()),
            found => found.map_err(|error| cannot_read(&folder.to_string_lossy(), &error)),
        }
    }
}

/// The folder that a folder of machine files belongs to, and the way back.
fn home(machines: &Path) -> (PathBuf, String) {
    if machines.file_name() == Some(OsStr::new(MACHINES)) {
        return (machines.parent().unwrap_or(Path::new("")).to_owned(), format!("{MACHINES}/"));
    }
    let current = if machines.as_os_str().is_empty() { Path::new(".") } else { machines };
    match fs::canonicalize(current) {
        Ok(found) if found.file_name() == Some(OsStr::new(MACHINES)) => (machines.join(".."), format!("{MACHINES}/")),
        _ => (machines.to_owned(), String::new()),
    }
}

/// A folder's files with this extension by their names without it.
fn files(folder: &Path, extension: &str) -> io::Result<BTreeMap<String, PathBuf>> {
    let current = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let paths = fs::read_dir(current)?.map(|entry| entry.map(|entry| folder.join(entry.file_name())));
    let is_wanted = |path: &PathBuf| path.extension() == Some(OsStr::new(extension)) && path.is_file();
    let paths = paths.collect::<io::Result<Vec<PathBuf>>>()?;
    Ok(paths.into_iter().filter(is_wanted).map(|path| (stem(&path), path)).collect())
}

/// Whether a file is one of a machine, and not of controllers only. What cannot be read or parsed may be one.
fn defines_machine(file: &Path) -> bool {
    let Ok(text) = fs::read_to_string(file) else { return true };
    let is_machine = |item: &Item| matches!(item, Item::Machine(_));
    parse("", &text).whole().map_or(true, |tree| tree.body.statements.iter().any(|stated| is_machine(&stated.node)))
}

fn name(file: &Path) -> String {
    file.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn stem(file: &Path) -> String {
    file.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
