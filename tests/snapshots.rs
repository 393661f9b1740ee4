//! Every shipped machine with every example: the program, the certificate and the diagnostics, locked in `snapshots/`.
//!
//! A snapshot is `snapshots/MACHINE@PROGRAM.snap`: the machine file's text, what was told, the certificate, the NC text. Controls
//! that no shipped machine has by itself have a few in `snapshots/controllers/CONTROL/`.
//! `machc test` compares the same. `machc review` accepts, and so does `cargo insta review`. Read what you accept.

use mach_command::render::plain;
use machc::snapshot::content::{Program, content};
use machc::sources::Sources;
use std::collections::BTreeSet;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};

#[path = "common/machine.rs"]
mod machine;
#[path = "common/refit.rs"]
mod refit;
#[path = "common/stems.rs"]
mod stems;

use refit::Refit;
use stems::stems;

/// The controls that no shipped machine has by itself.
const ELSEWHERE: [&str; 3] = ["fanuc", "linuxcnc", "heidenhain"];

/// The programs that are locked for each of these, on machines that have the control instead of their own.
const CHOSEN: [(&str, &str); 6] = [
    ("bridge6_quill", "blade_strip"),
    ("hmc5", "pole_crossed"),
    ("tmv710a", "sine_surface"),
    ("vmc3_inch", "face_mill"),
    ("vmc4", "feed_screw"),
    ("xzc_face", "face_mill"),
];

/// Every machine with every program.
fn pairs() -> impl Iterator<Item = (String, String)> {
    let programs = stems("examples", "cls");
    let pair = move |machine: String| programs.clone().into_iter().map(move |program| (machine.clone(), program));
    stems("machines", "mach").into_iter().flat_map(pair)
}

/// What a snapshot holds below its head.
fn locked(machine_file: &str, sources: &dyn Sources, program: &str) -> String {
    let cl_file = format!("examples/{program}.cls");
    let compiled = machine::compiled(machine_file, sources);
    content(&Program {
        machine_file,
        machine_text: &sources.read(machine_file).expect("readable"),
        rig: &compiled.rig().expect("a machine with a controller"),
        cl_file: &cl_file,
        cl: &fs::read(machine::root().join(&cl_file)).expect("readable"),
        told: plain,
    })
}

/// Compares what snapshots of a folder hold with what each pair gives now.
fn compare(folder: &str, pairs: impl Iterator<Item = (String, String)>, locked: impl Fn(&str, &str) -> String) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(machine::root().join(folder));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let mut wrong = Vec::new();
    for (machine, program) in pairs {
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
fn every_program_on_every_machine_is_as_locked() {
    let locked = |machine: &str, program: &str| locked(&format!("machines/{machine}.mach"), &machine::Files, program);
    compare("snapshots", pairs(), locked);
}

#[test]
fn chosen_programs_on_other_controls_are_as_locked() {
    for control in ELSEWHERE {
        let chosen = CHOSEN.into_iter().map(|(machine, program)| (machine.to_owned(), program.to_owned()));
        compare(&format!("snapshots/controllers/{control}"), chosen, |machine, program| {
            let refit = Refit { machine, control };
            locked(&refit.path(), &refit, program)
        });
    }
}

#[test]
fn no_snapshot_is_left_over() {
    let names = |pairs: &mut dyn Iterator<Item = (String, String)>| -> BTreeSet<String> {
        pairs.map(|(machine, program)| format!("{machine}@{program}")).collect()
    };
    assert_eq!(stems("snapshots", "snap"), names(&mut pairs()));
    let chosen = CHOSEN.map(|(machine, program)| (machine.to_owned(), program.to_owned()));
    for control in ELSEWHERE {
        let found = stems(&format!("snapshots/controllers/{control}"), "snap");
        assert_eq!(found, names(&mut chosen.clone().into_iter()), "{control}");
    }
}
