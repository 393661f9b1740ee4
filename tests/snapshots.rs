//! Every shipped machine with every example: the program, the certificate and the diagnostics, locked in `snapshots/`.
//!
//! A snapshot is `snapshots/MACHINE@PROGRAM.snap`: the machine file's text, what was told, the certificate, the NC text.
//! `machc test` compares the same. `machc review` accepts, and so does `cargo insta review`. Read what you accept.

use mach_command::render::plain;
use machc::snapshot::content::{Program, content};
use machc::sources::Sources;
use std::collections::BTreeSet;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};

#[path = "common/machine.rs"]
mod machine;
#[path = "common/stems.rs"]
mod stems;

use stems::stems;

/// Every machine with every program.
fn pairs() -> impl Iterator<Item = (String, String)> {
    let programs = stems("examples", "cls");
    let pair = move |machine: String| programs.clone().into_iter().map(move |program| (machine.clone(), program));
    stems("machines", "mach").into_iter().flat_map(pair)
}

/// What a snapshot holds below its head.
fn locked(machine: &str, program: &str) -> String {
    let (machine_file, cl_file) = (format!("machines/{machine}.mach"), format!("examples/{program}.cls"));
    let compiled = machine::compiled(&machine_file, &machine::Files);
    content(&Program {
        machine_file: &machine_file,
        machine_text: &machine::Files.read(&machine_file).expect("readable"),
        rig: &compiled.rig().expect("a machine with a controller"),
        cl_file: &cl_file,
        cl: &fs::read(machine::root().join(&cl_file)).expect("readable"),
        told: plain,
    })
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
        let (name, content) = (format!("{machine}@{program}"), locked(&machine, &program));
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
