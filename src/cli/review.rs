//! `machc review`.

use std::fs;
use std::io::{BufRead, stdin};
use std::path::Path;

use mach_command::files::{cannot_read, cannot_write};
use mach_command::outcome::{Failure, Status};
use mach_command::output::{print, write_file};
use mach_command::report::Report;
use machc::snapshot::file::Snapshot;

use super::text_diff::Changes;
use super::workspace::Workspace;

/// Look through what machc test (or cargo test) has found to differ
///
/// Each pending snapshot is shown against the accepted one, and then accepted, rejected or left for later. Read what
/// you accept: from then on it is what the machine's programs have to look like.
///
/// Exit status: 0 nothing is pending any more, 1 something is, 2 wrong usage or a file that cannot be read or written.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Accept all of them without asking
    #[arg(long, conflicts_with = "reject")]
    accept: bool,
    /// Reject all of them without asking
    #[arg(long)]
    reject: bool,
    /// Folders and machine files
    #[arg(value_name = "PATH", default_value = ".")]
    paths: Vec<String>,
}

/// What is to become of a pending snapshot, and of those after it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Verdict {
    Accept,
    Reject,
    Skip,
    Quit,
}

pub(super) fn run(arguments: Arguments, report: &Report) -> Result<Status, Failure> {
    let always = match (arguments.accept, arguments.reject) {
        (true, _) => Some(Verdict::Accept),
        (_, true) => Some(Verdict::Reject),
        // For tools: what is pending, and no questions.
        _ => report.is_json().then_some(Verdict::Skip),
    };
    let mut pending = Vec::new();
    for path in &arguments.paths {
        pending.extend(Workspace::of(path)?.pending()?);
    }
    let mut left = pending.len();
    for (index, file) in pending.iter().enumerate() {
        let verdict = match always {
            Some(verdict) => verdict,
            None => ask(file, &format!("{} of {}", index + 1, pending.len()), report)?,
        };
        if verdict == Verdict::Quit {
            break;
        }
        carry_out(verdict, file, report)?;
        left -= usize::from(verdict != Verdict::Skip);
    }
    report.note(&if pending.is_empty() { "nothing is pending".to_owned() } else { format!("{left} still pending") });
    Ok(if left == 0 { Status::Done } else { Status::Refused })
}

/// Shows a pending snapshot, and asks what is to become of it.
fn ask(file: &Path, which: &str, report: &Report) -> Result<Verdict, Failure> {
    let old = if file.exists() { read(file)?.content().to_owned() } else { String::new() };
    let new = read(&file.with_extension("snap.new"))?;
    let changes = Changes::between(&old, new.content(), report.colors_stdout());
    let counted = format!("{} lines removed, {} added", changes.removed, changes.added);
    print(&format!("{}\n{which}: {} - {counted}\n", changes.text, file.display()))?;
    loop {
        print("[a]ccept, [r]eject, [s]kip, [q]uit? ")?;
        let mut answer = String::new();
        let read = stdin().lock().read_line(&mut answer).map_err(|error| cannot_read("-", &error))?;
        match answer.trim() {
            _ if read == 0 => return print("\n").map(|()| Verdict::Quit),
            "a" | "accept" => return Ok(Verdict::Accept),
            "r" | "reject" => return Ok(Verdict::Reject),
            "s" | "skip" => return Ok(Verdict::Skip),
            "q" | "quit" => return Ok(Verdict::Quit),
            _ => {}
        }
    }
}

fn carry_out(verdict: Verdict, file: &Path, report: &Report) -> Result<(), Failure> {
    let pending = file.with_extension("snap.new");
    let (word, removed) = match verdict {
        Verdict::Accept => {
            write_file(file, &read(&pending)?.accepted().to_text())?;
            ("accepted", fs::remove_file(&pending))
        }
        Verdict::Reject => ("rejected", fs::remove_file(&pending)),
        Verdict::Skip | Verdict::Quit => ("pending", Ok(())),
    };
    removed.map_err(|error| cannot_write(&pending.to_string_lossy(), &error))?;
    if report.is_json() {
        let line = serde_json::json!({ "type": "review", "file": file.to_string_lossy(), "outcome": word });
        return print(&format!("{line}\n"));
    }
    report.note(&format!("{word:<10}{}", file.display()));
    Ok(())
}

fn read(file: &Path) -> Result<Snapshot, Failure> {
    let text = fs::read_to_string(file).map_err(|error| cannot_read(&file.to_string_lossy(), &error))?;
    Ok(Snapshot::parse(&text))
}
