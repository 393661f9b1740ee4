//! What comes out of a post does not depend on the number of threads.

use mach_runtime::rig::Posted;
use machc::compile::Compiled;
use machc::plan::Interpreter;
use std::fs;
use std::num::NonZeroUsize;

#[path = "common/machine.rs"]
mod machine;
#[path = "common/program.rs"]
#[expect(dead_code, reason = "it posts texts")]
mod program;
#[path = "common/stems.rs"]
mod stems;

use stems::stems;

/// The CL files of a folder, names and texts.
fn cl_files(folder: &str) -> impl Iterator<Item = (String, Vec<u8>)> {
    stems(folder, "cls").into_iter().map(move |stem| {
        let name = format!("{folder}/{stem}.cls");
        let text = fs::read(machine::root().join(&name)).expect("readable");
        (name, text)
    })
}

fn post(compiled: &Compiled, name: &str, cl: &[u8], threads: usize) -> Posted {
    let threads = NonZeroUsize::new(threads).expect("some threads");
    program::posted_text(&Interpreter::new(&compiled.plan), compiled, name, cl, threads)
}

fn assert_same_on_two_threads(compiled: &Compiled, name: &str, cl: &[u8]) {
    let [one, two] = [1, 2].map(|threads| post(compiled, name, cl, threads));
    assert_eq!(one.certificate, two.certificate, "{name}");
    assert_eq!(one.diagnostics, two.diagnostics, "{name}");
    assert!(one.certificate.is_none() || one.nc == two.nc, "{name}");
}

/// Of some thousand points, so that the second thread has work.
fn long_program() -> Vec<u8> {
    fs::read(machine::root().join("examples/sine_surface.cls")).expect("readable").repeat(20)
}

#[test]
fn every_example_on_every_machine() {
    for stem in stems("machines", "mach") {
        let machine = machine::compiled(&format!("machines/{stem}.mach"), &machine::Files);
        let mut all = Vec::new();
        for (name, cl) in cl_files("examples").chain(cl_files("tests/goldens")) {
            assert_same_on_two_threads(&machine, &name, &cl);
            all.extend(cl);
        }
        assert_same_on_two_threads(&machine, &format!("all examples on {stem}"), &all);
    }
}

#[test]
fn a_long_program() {
    let machine = machine::compiled("machines/tmv710a.mach", &machine::Files);
    let long = long_program();
    assert!(post(&machine, "long.cls", &long, 1).certificate.is_some());
    assert_same_on_two_threads(&machine, "long.cls", &long);
}

#[test]
fn every_mistake_in_a_short_and_a_long_program() {
    let machine = machine::compiled("machines/tmv710a.mach", &machine::Files);
    for (name, cl) in cl_files("tests/bad_cl") {
        assert_same_on_two_threads(&machine, &name, &cl);
        assert_same_on_two_threads(&machine, &name, &[long_program(), cl.repeat(30)].concat());
    }
}
