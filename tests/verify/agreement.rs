//! Every program that machc writes agrees with its CL, read as anybody's.

use super::machine::{Files, compiled};
use super::stems::stems;
use super::verified::Setup;
use mach_runtime::diagnostic::Severity;
use std::path::Path;

#[test]
fn the_library_agrees_with_its_cl() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut compared = 0;
    for name in stems("machines", "mach") {
        let setup = Setup::new(compiled(&format!("machines/{name}.mach"), &Files));
        for program in stems("examples", "cls") {
            let cl = std::fs::read_to_string(examples.join(format!("{program}.cls"))).expect("an example");
            let Some(nc) = setup.post(&cl) else { continue };
            let (told, agreement) = setup.verify(&nc, &cl);
            let errors: Vec<_> = told.iter().filter(|it| it.severity == Severity::Error).collect();
            assert!(errors.is_empty(), "{name} {program}: {errors:#?}");
            assert_eq!(agreement.differences, 0, "{name} {program}");
            assert!(agreement.points > 10, "{name} {program}");
            compared += 1;
        }
    }
    assert!(compared > 150, "{compared}");
}
