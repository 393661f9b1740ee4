//! Every shipped machine with every example: the program, the certificate and the diagnostics, locked in `snapshots/`.
//!
//! A snapshot is `snapshots/MACHINE@PROGRAM.snap`: the machine file's text, what was told, the certificate, the NC text.
//! `INSTA_UPDATE=always cargo test --test snapshots` writes them anew. Read what you accept.

use machc::compile::Sources;
use machc::diagnostic::{Style, render};
use std::collections::BTreeSet;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};

#[path = "common/machine.rs"]
mod machine;
#[path = "common/program.rs"]
mod program;

/// The names, without the extension, of the folder's files with this extension.
fn stems(folder: &str, extension: &str) -> BTreeSet<String> {
    let entries = fs::read_dir(machine::root().join(folder)).expect("the folder is there");
    let paths = entries.map(|entry| entry.expect("readable").path());
    let wanted = paths.filter(|path| path.extension().is_some_and(|found| found == extension));
    wanted.map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned()).collect()
}

/// Every machine with every program.
fn pairs() -> impl Iterator<Item = (String, String)> {
    let programs = stems("examples", "cls");
    let pair = move |machine: String| programs.clone().into_iter().map(move |program| (machine.clone(), program));
    stems("machines", "mach").into_iter().flat_map(pair)
}

/// FNV-1a: tells line ends apart, which the comparison of snapshots does not.
fn fingerprint(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}

/// What a snapshot holds below its head.
fn content(machine: &str, program: &str) -> String {
    let (machine, cl) = (format!("machines/{machine}.mach"), format!("examples/{program}.cls"));
    let source = machine::Files.read(&machine).expect("readable");
    let posted = program::posted(&machine::compiled(&machine, &machine::Files), &cl);
    let told = render(&posted.diagnostics, Style::PLAIN);
    let mut text = format!("==== {machine}\n{source}\n==== {cl}\n{told}");
    if let Some(certificate) = &posted.certificate {
        let (bytes, fingerprint) = (posted.nc.len(), fingerprint(&posted.nc));
        let nc = String::from_utf8_lossy(&posted.nc);
        text += &format!("{certificate}\n==== NC, {bytes} bytes, FNV-1a {fingerprint:016x}\n{nc}");
    }
    text
}

#[test]
fn every_program_on_every_machine_is_as_locked() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(machine::root().join("snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let mut wrong = Vec::new();
    for (machine, program) in pairs() {
        settings.set_description(format!("{program} on {machine}"));
        let (name, content) = (format!("{machine}@{program}"), content(&machine, &program));
        let compare = || settings.bind(|| insta::assert_snapshot!(name.clone(), content));
        if catch_unwind(AssertUnwindSafe(compare)).is_err() {
            wrong.push(name);
        }
    }
    assert!(wrong.is_empty(), "not as locked: {wrong:?}");
}

#[test]
fn no_snapshot_is_left_over() {
    let expected: BTreeSet<String> = pairs().map(|(machine, program)| format!("{machine}@{program}")).collect();
    assert_eq!(stems("snapshots", "snap"), expected);
}
