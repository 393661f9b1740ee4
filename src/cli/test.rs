//! `machc test`.

use std::collections::BTreeSet;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use mach_command::files::cannot_read;
use mach_command::outcome::{Failure, Status};
use mach_command::output::{Lines, print, write_file};
use mach_command::render::plain;
use mach_command::report::Report;
use machc::snapshot::content::{Program, content};
use machc::snapshot::file::Snapshot;
use serde::Serialize;

use super::machine::{Prepared, prepare_in};
use super::post;
use super::text_diff::Changes;
use super::workspace::Workspace;

/// So many lines of a difference are shown; `machc review` shows all of them.
const MOST_LINES: usize = 40;

/// Post each machine's programs, and compare with what was accepted
///
/// Machine files are those of machines/, or of the folder itself. To every machine belong the CL files of programs/ (or
/// examples/), to the machine NAME also those of programs/NAME/. What comes out - the program, its certificate, or the
/// errors - is compared with snapshots/NAME@PROGRAM.snap. What differs or is new is written beside it as .snap.new, and
/// waits for machc review (or cargo insta review).
///
/// Exit status: 0 all is as accepted, 1 something differs, is new, is left over, or is a machine with errors, 2 wrong
/// usage or a file that cannot be read or written.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Folders and machine files
    #[arg(value_name = "PATH", default_value = ".")]
    paths: Vec<String>,
}

/// How a program's output compares with its snapshot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
enum Outcome {
    Accepted,
    Differs,
    New,
    /// A snapshot without a machine or a program.
    LeftOver,
}

/// What `--json` writes of each.
#[derive(Serialize)]
#[serde(tag = "type", rename = "snapshot")]
struct SnapshotMessage<'a> {
    name: &'a str,
    outcome: Outcome,
    file: &'a str,
}

/// A run under way.
struct Test<'a> {
    report: &'a Report,
    counts: [usize; 4],
    broken: usize,
}

pub(super) fn run(arguments: Arguments, report: &Report) -> Result<Status, Failure> {
    let mut test = Test { report, counts: [0; 4], broken: 0 };
    for path in &arguments.paths {
        let workspace = Workspace::of(path)?;
        if workspace.machines.is_empty() {
            return Err(Failure(format!("there are no machine files in `{path}`")));
        }
        test.workspace(&workspace)?;
    }
    report.note(&test.summary());
    let [accepted, rest @ ..] = test.counts;
    if accepted + rest.iter().sum::<usize>() + test.broken == 0 {
        let way_out = "put CL files into `programs/`, beside the machine files or beside `machines/`";
        return Err(Failure(format!("there are no programs to post: {way_out}")));
    }
    Ok(if test.broken == 0 && rest == [0; 3] { Status::Done } else { Status::Refused })
}

impl Test<'_> {
    fn workspace(&mut self, workspace: &Workspace) -> Result<(), Failure> {
        let mut expected = BTreeSet::new();
        for (name, file) in &workspace.machines {
            let programs = workspace.programs(name)?;
            expected.extend(programs.keys().map(|program| format!("{name}@{program}")));
            if programs.is_empty() {
                self.report.note(&format!("no programs belong to {name}"));
                continue;
            }
            match self.machine(workspace, file)? {
                Some(machine) => {
                    for (program, cl_file) in &programs {
                        let description = format!("{program} on {name}");
                        let new = Snapshot::new(file, &description, &posted(workspace, file, &machine, cl_file)?);
                        let name = format!("{name}@{program}");
                        self.compare(&name, &workspace.snapshot(&name), &new)?;
                    }
                }
                None => self.broken += 1,
            }
        }
        for name in workspace.accepted()?.iter().filter(|name| !expected.contains(*name)) {
            let file = workspace.snapshot(name);
            self.tell(name, Outcome::LeftOver, &file, "no machine or no program of this name: delete the file")?;
        }
        Ok(())
    }

    /// The machine, if it has no errors and a controller.
    fn machine(&self, workspace: &Workspace, file: &str) -> Result<Option<Prepared>, Failure> {
        let prepared = prepare_in(&workspace.folder, file, self.report)?;
        if let Some(Prepared { origins, .. }) = prepared.as_ref().filter(|prepared| prepared.model.dialect.is_none()) {
            self.report.tell(&[post::no_controller(origins)]);
            return Ok(None);
        }
        Ok(prepared)
    }

    fn compare(&mut self, name: &str, path: &Path, new: &Snapshot) -> Result<(), Failure> {
        let pending = path.with_extension("snap.new");
        let old = match fs::read_to_string(path) {
            Ok(text) => Some(Snapshot::parse(&text)),
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => return Err(cannot_read(&path.to_string_lossy(), &error)),
        };
        let Some(old) = old else {
            write_file(&pending, &new.to_text())?;
            return self.tell(name, Outcome::New, path, "");
        };
        if old.content() == new.content() {
            // What was pending is so no longer.
            let _ = fs::remove_file(pending);
            return self.tell(name, Outcome::Accepted, path, "");
        }
        write_file(&pending, &new.to_text())?;
        let changes = Changes::between(old.content(), new.content(), self.report.colors_stdout());
        self.tell(name, Outcome::Differs, path, &shortened(&changes))
    }

    fn tell(&mut self, name: &str, outcome: Outcome, path: &Path, more: &str) -> Result<(), Failure> {
        self.counts[outcome as usize] += 1;
        let title = match outcome {
            Outcome::Accepted => "",
            Outcome::Differs => "differs",
            Outcome::New => "new",
            Outcome::LeftOver => "left over",
        };
        let file = path.to_string_lossy();
        match (self.report.is_json(), outcome) {
            (true, _) => {
                let mut lines = Lines::stdout();
                lines.add(&SnapshotMessage { name, outcome, file: &file });
                lines.flush().map(drop)
            }
            (false, Outcome::Accepted) => Ok(()),
            (false, Outcome::LeftOver) => print(&format!("{title:<10}{file}: {more}\n")),
            (false, _) => print(&format!("{title:<10}{file}\n{more}")),
        }
    }

    fn summary(&self) -> String {
        let [accepted, differ, new, left_over] = self.counts;
        let parts = [(differ, "differ"), (new, "new"), (left_over, "left over"), (self.broken, "machines with errors")];
        let parts = parts.into_iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!(", {count} {what}"));
        let way_out = if differ + new > 0 { "; `machc review` shows, accepts and rejects" } else { "" };
        format!("{accepted} as accepted{}{way_out}", parts.collect::<String>())
    }
}

/// What a program gives on a machine. Everything is named as seen from the workspace, wherever that is.
fn posted(workspace: &Workspace, machine_file: &str, machine: &Prepared, cl_file: &str) -> Result<String, Failure> {
    let read = |file: &str| {
        let path = workspace.folder.join(file);
        fs::read(&path).map_err(|error| cannot_read(&path.to_string_lossy(), &error))
    };
    let (machine_text, cl) = (read(machine_file)?, read(cl_file)?);
    let rig = machine.rig().expect("machines without a controller are told");
    Ok(content(&Program {
        machine_file,
        machine_text: &String::from_utf8_lossy(&machine_text),
        rig: &rig,
        cl_file,
        cl: &cl,
        told: plain,
    }))
}

/// The first lines of a difference.
fn shortened(changes: &Changes) -> String {
    let shown: String = changes.text.split_inclusive('\n').take(MOST_LINES).collect();
    let more = changes.text.lines().count().saturating_sub(MOST_LINES);
    if more > 0 { format!("{shown}… and {more} more lines\n") } else { shown }
}
