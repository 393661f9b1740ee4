//! `machc new`.

use std::ffi::OsStr;
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::Path;

use mach_command::files::cannot_write;
use mach_command::outcome::{Failure, Status};
use mach_command::output::print;
use mach_command::report::Report;
use machc::syntax::parse::parse;
use machc::syntax::spelling::nearest;
use machc::syntax::tree::{File, Item};

use super::builtin;

/// The controller in the families' texts.
const DEFAULT_CONTROLLER: &str = "syntec";

/// What a new machine file is copied from; there the machine is called `NAME`.
#[derive(Debug, Clone, Copy)]
struct Family {
    name: &'static str,
    what: &'static str,
    text: &'static str,
}

const FAMILIES: [Family; 10] = [
    Family { name: "three-axis", what: "X, Y and Z", text: include_str!("families/three-axis.mach") },
    Family { name: "four-axis", what: "X, Y, Z and a rotary table A", text: include_str!("families/four-axis.mach") },
    Family {
        name: "turning-centre",
        what: "X, Z and the spindle C",
        text: include_str!("families/turning-centre.mach"),
    },
    Family { name: "trunnion", what: "table C on a cradle A", text: include_str!("families/trunnion.mach") },
    Family {
        name: "trunnion-measured",
        what: "table C on a cradle A, with measured errors",
        text: include_str!("families/trunnion-measured.mach"),
    },
    Family { name: "trunnion-bc", what: "table C on a cradle B", text: include_str!("families/trunnion-bc.mach") },
    Family {
        name: "nutating-table",
        what: "table C on an inclined axis B",
        text: include_str!("families/nutating-table.mach"),
    },
    Family { name: "head-table", what: "swivel head B, table C", text: include_str!("families/head-table.mach") },
    Family { name: "head-head", what: "fork head: A in C", text: include_str!("families/head-head.mach") },
    Family { name: "six-axis", what: "fork head on a quill W", text: include_str!("families/six-axis.mach") },
];

/// Write a machine file to begin with
///
/// NAME.mach holds a machine of a family: complete, with comments, and with example values to be replaced by those of
/// the machine's data sheet. A file that is there already is left alone.
#[derive(Debug, clap::Args)]
#[command(override_usage = "machc new <NAME> --like <FAMILY> [OPTIONS]\n       machc new --list")]
pub(super) struct Arguments {
    /// The machine's name, perhaps with a folder before it
    #[arg(required_unless_present = "list")]
    name: Option<String>,
    /// The family it belongs to
    #[arg(long, value_name = "FAMILY", required_unless_present = "list")]
    like: Option<String>,
    /// Its controller
    #[arg(long, value_name = "CONTROLLER", default_value = DEFAULT_CONTROLLER)]
    controller: String,
    /// List the families and the controllers
    #[arg(long, conflicts_with_all = ["name", "like", "controller"])]
    list: bool,
}

pub(super) fn run(arguments: Arguments, report: &Report) -> Result<Status, Failure> {
    let Arguments { name: Some(name), like: Some(like), controller, .. } = arguments else {
        return print(&list()).map(|()| Status::Done);
    };
    let families = FAMILIES.iter().map(|family| family.name);
    let family = FAMILIES.iter().find(|family| family.name == like);
    let family = family.ok_or_else(|| unknown("family", &like, families))?;
    if !builtin::names().any(|known| known == controller) {
        return Err(unknown("controller", &controller, builtin::names()));
    }
    let file = format!("{}.mach", name.strip_suffix(".mach").unwrap_or(&name));
    let text = named(family, &file)?.replace(DEFAULT_CONTROLLER, &controller);
    create(&file, &text)?;
    report.note(&format!("wrote {file}; `machc show {file}` shows what is derived from it"));
    Ok(Status::Done)
}

fn list() -> String {
    let families = FAMILIES.iter().map(|Family { name, what, .. }| format!("  {name:<19}{what}\n"));
    let controllers = builtin::names().map(|name| format!("  {name}\n"));
    format!("families:\n{}controllers:\n{}", families.collect::<String>(), controllers.collect::<String>())
}

fn unknown(kind: &str, name: &str, known: impl Iterator<Item = &'static str>) -> Failure {
    let meant = nearest(name, known)
        .map_or_else(|| "`machc new --list` lists all of them".to_owned(), |meant| format!("did you mean `{meant}`?"));
    Failure(format!("there is no {kind} `{name}`; {meant}"))
}

/// The family's text with the machine named after the file.
fn named(family: &Family, file: &str) -> Result<String, Failure> {
    let name = Path::new(file).file_stem().and_then(OsStr::to_str).unwrap_or_default();
    let text = family.text.replace("NAME", name);
    let is_so_named = |item: &Item| matches!(item, Item::Machine(machine) if machine.name.value == name);
    let is_said = |tree: File| tree.body.statements.iter().any(|stated| is_so_named(&stated.node));
    let is_sound = parse(file, &text).whole().is_ok_and(is_said);
    let no_name =
        "cannot be a machine's name: take a letter, then letters, digits and `_`, and no word of the language";
    if is_sound { Ok(text) } else { Err(Failure(format!("`{name}` {no_name}"))) }
}

/// Writes a file that is not there yet.
fn create(file: &str, text: &str) -> Result<(), Failure> {
    let created = OpenOptions::new().write(true).create_new(true).open(file);
    created.and_then(|mut created| created.write_all(text.as_bytes())).map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists => Failure(format!("`{file}` is there already, and stays as it is")),
        _ => cannot_write(file, &error),
    })
}
