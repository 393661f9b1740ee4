//! Every program that machc writes agrees with its CL, read as anybody's.

use super::machine::{Files, compiled};
use super::stems::stems;
use super::verified::Setup;
use mach_runtime::diagnostic::Severity;
use std::collections::BTreeMap;
use std::path::Path;

/// The programs that the machine can do, each of which agrees.
fn agreeing(name: &str, setup: &Setup, programs: &BTreeMap<String, String>) -> Vec<String> {
    let agrees = |(program, cl): (&String, &String)| {
        let nc = setup.post(cl)?;
        let (told, agreement) = setup.verify(&nc, cl);
        let errors: Vec<_> = told.iter().filter(|it| it.severity == Severity::Error).collect();
        assert!(errors.is_empty(), "{name} {program}: {errors:#?}");
        assert_eq!(agreement.differences, 0, "{name} {program}");
        assert!(agreement.points > 10, "{name} {program}");
        Some(program.clone())
    };
    programs.iter().filter_map(agrees).collect()
}

/// Every machine with every control: whether it can do a program does not depend on the control.
#[test]
fn the_library_agrees_with_its_cl_on_every_control() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let read = |name: String| {
        let cl = std::fs::read_to_string(examples.join(format!("{name}.cls"))).expect("an example");
        (name, cl)
    };
    let programs: BTreeMap<_, _> = stems("examples", "cls").into_iter().map(read).collect();
    let mut compared = 0;
    for machine in stems("machines", "mach") {
        let own = Setup::new(compiled(&format!("machines/{machine}.mach"), &Files));
        let possible = agreeing(&machine, &own, &programs);
        compared += possible.len();
        let mut controls = stems("machines/controllers", "mach");
        controls.remove(&own.rig.dialect.name);
        for control in controls {
            let name = format!("{machine} with {control}");
            let found = agreeing(&name, &Setup::refitted(&machine, &control), &programs);
            assert_eq!(found, possible, "{name}");
            compared += found.len();
        }
    }
    assert!(compared > 600, "{compared}");
}
