//! `machc build`.

use std::env::consts::EXE_SUFFIX;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use mach_command::files::{cannot_read, cannot_write};
use mach_command::outcome::{Failure, Status};
use mach_command::output::{print, write_file};
use mach_command::report::Report;
use machc::compile::Compiled;
use machc::emit::package::{PackageFile, package, package_name, workspace};

use super::machine::compiled;
use super::post::no_controller;

/// Build posts of their own: commands that need no machc
///
/// A machine's kinematics and its controller's dialect become Rust source, and that becomes the command NAME-post with the
/// arguments, the diagnostics and the output of `machc post`. The source is left in DIR, a Cargo workspace that holds
/// everything it needs; posts in one workspace share what they have in common. Rust's cargo has to be installed.
///
/// Path and size of each command go to standard output.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The machine files
    #[arg(required = true, value_name = "MACHINE")]
    machines: Vec<String>,
    /// The workspace that the source goes to
    #[arg(long, value_name = "DIR", default_value = "posts")]
    workspace: PathBuf,
    /// The folder to copy the commands to; without it, they stay in the workspace's target/release
    #[arg(short, long, value_name = "FOLDER")]
    output: Option<PathBuf>,
}

pub(super) fn run(arguments: Arguments, report: &Report) -> Result<Status, Failure> {
    let Arguments { machines, workspace: folder, output } = arguments;
    let posts = machines.iter().map(|file| postable(file, report)).collect::<Result<Vec<_>, _>>()?;
    let Some(posts) = posts.into_iter().collect::<Option<Vec<_>>>() else { return Ok(Status::Refused) };
    let names: Vec<String> = posts.iter().map(|compiled| package_name(&compiled.model.name)).collect();
    refuse_same_names(&names, &machines)?;
    if let Some(to) = &output {
        create_folder(to)?;
    }
    write_workspace(&folder)?;
    for file in posts.iter().flat_map(package) {
        write_if_changed(&folder, &file)?;
    }
    cargo_build(&folder, &names, report)?;
    for name in names {
        let command = format!("{name}{EXE_SUFFIX}");
        let built = folder.join("target/release").join(&command);
        tell(&output.as_ref().map_or(Ok(built.clone()), |to| copied(&built, &to.join(command)))?, report)?;
    }
    Ok(Status::Done)
}

/// A machine that a post can be made for; nothing when it has errors, which have been told.
fn postable(file: &str, report: &Report) -> Result<Option<Compiled>, Failure> {
    let Some(compiled) = compiled(file, report)? else { return Ok(None) };
    if compiled.model.dialect.is_none() {
        report.tell(&[no_controller(&compiled.origins)]);
        return Ok(None);
    }
    Ok(Some(compiled))
}

/// Two machines of one name would be one post.
fn refuse_same_names(names: &[String], machines: &[String]) -> Result<(), Failure> {
    for (index, name) in names.iter().enumerate() {
        if let Some(before) = names[..index].iter().position(|other| other == name) {
            let (first, second) = (&machines[before], &machines[index]);
            return Err(Failure(format!(
                "`{first}` and `{second}` would both become `{name}`: call one of the machines otherwise"
            )));
        }
    }
    Ok(())
}

fn create_folder(folder: &Path) -> Result<(), Failure> {
    fs::create_dir_all(folder).map_err(|error| cannot_write(&folder.to_string_lossy(), &error))
}

fn copied(built: &Path, to: &Path) -> Result<PathBuf, Failure> {
    fs::copy(built, to).map_err(|error| cannot_write(&to.to_string_lossy(), &error))?;
    Ok(to.to_owned())
}

/// Writes what is shared. The lock file goes with the manifest: Cargo makes it its own.
fn write_workspace(folder: &Path) -> Result<(), Failure> {
    let mut is_new = false;
    for file in workspace() {
        match file.path.to_str() {
            Some("Cargo.toml") => is_new = write_if_changed(folder, &file)?,
            Some("Cargo.lock") if !is_new => {}
            _ => drop(write_if_changed(folder, &file)?),
        }
    }
    Ok(())
}

/// Writes a file and says so, unless it is there already: Cargo builds what is newer than before.
fn write_if_changed(folder: &Path, file: &PackageFile) -> Result<bool, Failure> {
    let path = folder.join(&file.path);
    let differs = fs::read_to_string(&path).map_or(true, |text| text != file.text);
    if differs {
        write_file(&path, &file.text)?;
    }
    Ok(differs)
}

/// Has Cargo build the commands. Cargo shows how far it is.
fn cargo_build(folder: &Path, names: &[String], report: &Report) -> Result<(), Failure> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(&cargo);
    command.args(["build", "--release", "--manifest-path"]).arg(folder.join("Cargo.toml"));
    command.args(names.iter().flat_map(|name| ["--package", name]));
    command.arg("--target-dir").arg(folder.join("target")).stdin(Stdio::null());
    if !report.shows_notes() {
        command.arg("--quiet");
    }
    let status = command.status().map_err(|error| {
        let cargo = cargo.to_string_lossy();
        Failure(format!("cannot run `{cargo}`: {error}; a post is built by Rust's cargo, see https://rustup.rs"))
    })?;
    if !status.success() {
        let folder = folder.display();
        return Err(Failure(format!("cargo could not build what is in `{folder}`; its own messages say why")));
    }
    Ok(())
}

/// Says where the command is, and how large.
fn tell(post: &Path, report: &Report) -> Result<(), Failure> {
    let path = post.to_string_lossy();
    let bytes = fs::metadata(post).map_err(|error| cannot_read(&path, &error))?.len();
    if report.is_json() {
        let told = serde_json::json!({ "type": "post", "path": path, "bytes": bytes });
        print(&format!("{told}\n"))
    } else {
        print(&format!("{path}  {:.2} MB\n", bytes as f64 / 1e6))
    }
}
