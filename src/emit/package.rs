//! A machine as a Cargo package of its own, in a workspace that holds all it needs of machc.
//!
//!     Cargo.toml, Cargo.lock
//!     runtime/, command/             as in machc itself
//!     NAME-post/Cargo.toml
//!     NAME-post/src/main.rs          the command
//!     NAME-post/src/machine.rs       what was generated
//!
//! A second machine in the same workspace adds a package and builds nothing anew but itself.

use std::path::{Path, PathBuf};

use include_dir::{Dir, File, include_dir};

use super::rust::rust;
use crate::compile::Compiled;

static RUNTIME: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/runtime/src");
static COMMAND: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/command/src");
const RUNTIME_MANIFEST: &str = include_str!("../../runtime/Cargo.toml");
const COMMAND_MANIFEST: &str = include_str!("../../command/Cargo.toml");
/// The versions that machc itself was built and tested with.
const LOCK: &str = include_str!("../../Cargo.lock");

const WORKSPACE_MANIFEST: &str = include_str!("package/workspace.toml");
const MANIFEST: &str = include_str!("package/manifest.toml");
const MAIN: &str = include_str!("package/main.rs.txt");

/// A file of the workspace, its path as seen from there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PackageFile {
    /// Where it goes.
    pub path: PathBuf,
    /// What is in it.
    pub text: String,
}

impl PackageFile {
    fn new(path: impl Into<PathBuf>, text: impl Into<String>) -> Self {
        Self { path: path.into(), text: text.into() }
    }
}

/// The name of a machine's package and of its command.
pub fn package_name(machine: &str) -> String {
    format!("{machine}-post")
}

/// What all posts of a workspace share. The lock file belongs to the manifest before it: Cargo takes out of it what is not
/// used.
pub fn workspace() -> Vec<PackageFile> {
    let version = env!("CARGO_PKG_VERSION");
    let mut files = vec![
        PackageFile::new("Cargo.toml", WORKSPACE_MANIFEST.replace("VERSION", version)),
        PackageFile::new("Cargo.lock", LOCK),
        PackageFile::new(".gitignore", "/target\n"),
        PackageFile::new("runtime/Cargo.toml", RUNTIME_MANIFEST),
        PackageFile::new("command/Cargo.toml", COMMAND_MANIFEST),
    ];
    files.extend(sources(&RUNTIME, Path::new("runtime/src")));
    files.extend(sources(&COMMAND, Path::new("command/src")));
    files
}

/// The package of one machine. The machine names a controller.
pub fn package(compiled: &Compiled) -> Vec<PackageFile> {
    assert!(compiled.model.dialect.is_some(), "a post is made for a machine with a controller");
    let (version, machine) = (env!("CARGO_PKG_VERSION"), &compiled.model.name);
    let name = package_name(machine);
    let fill = |text: &str| text.replace("VERSION", version).replace("NAME", &name).replace("MACHINE", machine);
    vec![
        PackageFile::new(format!("{name}/Cargo.toml"), fill(MANIFEST)),
        PackageFile::new(format!("{name}/src/main.rs"), fill(MAIN)),
        PackageFile::new(format!("{name}/src/machine.rs"), rust(compiled)),
    ]
}

fn sources<'d>(folder: &'d Dir<'static>, to: &'d Path) -> impl Iterator<Item = PackageFile> + 'd {
    all_files(folder).into_iter().map(|file| {
        let text = file.contents_utf8().expect("sources are text");
        PackageFile::new(to.join(file.path()), text)
    })
}

fn all_files<'d>(folder: &'d Dir<'static>) -> Vec<&'d File<'static>> {
    folder.files().chain(folder.dirs().flat_map(all_files)).collect()
}
