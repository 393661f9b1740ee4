//! Plain blocks have a shorter way through the control; what they mean does not depend on it.

use super::machine::{Files, compiled};
use super::stems::stems;
use super::verified::Setup;
use mach_runtime::control::Control;
use mach_runtime::motion::Motion;

/// Edits that make other blocks, some of them wrong, of a line.
fn edited(line: &str) -> Vec<String> {
    let mut lines = vec![line.to_owned(), line.to_lowercase(), line.replace(' ', ""), format!("{line} {line}")];
    lines.extend(["G0", "G01", "G1.", "X1", "X1=2", "F.5", "M8", "(", "+"].map(|more| format!("{line}{more}")));
    lines.extend((0..line.len()).filter(|at| line.is_char_boundary(*at)).map(|at| {
        let (before, behind) = line.split_at(at);
        format!("{before}{}", behind.chars().skip(1).collect::<String>())
    }));
    lines
}

#[test]
fn a_plain_block_is_what_its_tokens_are() {
    let mut compared = 0;
    for name in stems("machines", "mach") {
        let setup = Setup::new(compiled(&format!("machines/{name}.mach"), &Files));
        let Some(program) = setup.post(include_str!("../../examples/face_mill.cls")) else { continue };
        let axes = &setup.rig.machine.axes;
        for line in program.lines().take(80).flat_map(edited) {
            let mut control = Control::new(&setup.rig.dialect.table, axes, setup.rig.machine.tool());
            control.stand_at(&vec![0.0; axes.len()]);
            let run = control.run(&line, 1, &mut Motion::new(axes.len()));
            compared += u32::from(run.is_ok());
            match control.read(&line) {
                Ok(Some(block)) if run.is_ok() => assert_eq!(*control.block(), block, "{name}: {line}"),
                Ok(_) => {}
                Err(_) => assert!(run.is_err(), "{name}: {line}"),
            }
        }
    }
    assert!(compared > 10_000, "{compared}");
}
