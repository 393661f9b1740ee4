//! Generated posts: `machc build` makes one of every machine in the library, and each does what `machc post` does.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

#[path = "common/stems.rs"]
mod stems;

use stems::stems;

/// Kept between runs: what has not changed is not built again.
const WORKSPACE: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/posts");

#[derive(Debug, PartialEq)]
struct Run {
    status: Option<i32>,
    stdout: String,
    stderr: String,
}

fn run(program: &Path, arguments: &[&str]) -> Run {
    let mut command = Command::new(program);
    let output = command.args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).output();
    let output = output.unwrap_or_else(|error| panic!("{}: {error}", program.display()));
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    Run { status: output.status.code(), stdout: text(output.stdout), stderr: text(output.stderr) }
}

fn machc(arguments: &[&str]) -> Run {
    run(Path::new(env!("CARGO_BIN_EXE_machc")), arguments)
}

/// Builds a post of each machine of the library; their paths, by machine.
fn build(machines: &BTreeSet<String>) -> impl Fn(&str) -> PathBuf {
    let files: Vec<String> = machines.iter().map(|machine| format!("machines/{machine}.mach")).collect();
    let mut arguments = vec!["build", "--workspace", WORKSPACE];
    arguments.extend(files.iter().map(String::as_str));
    let built = machc(&arguments);
    assert_eq!(built.status, Some(0), "{}", built.stderr);
    for (line, machine) in built.stdout.lines().zip(machines) {
        assert!(line.contains(&format!("{machine}-post")) && line.ends_with(" MB"), "{line}");
    }
    assert_eq!(built.stdout.lines().count(), machines.len());
    |machine| Path::new(WORKSPACE).join("target/release").join(format!("{machine}-post"))
}

#[test]
fn every_generated_post_does_what_the_interpreted_one_does() {
    let machines = stems("machines", "mach");
    let post = build(&machines);
    let (programs, wrong_programs) = (stems("examples", "cls"), stems("tests/bad_cl", "cls"));
    for machine in &machines {
        let file = format!("machines/{machine}.mach");
        let of_machc = |cl: &str| machc(&["post", &file, cl]);
        let examples = programs.iter().map(|program| format!("examples/{program}.cls"));
        let wrong = wrong_programs.iter().map(|program| format!("tests/bad_cl/{program}.cls"));
        let wrong = wrong.filter(|_| machine == "tmv710a");
        for cl in examples.chain(wrong) {
            assert_eq!(run(&post(machine), &[&cl]), of_machc(&cl), "{machine}, {cl}");
        }
    }
}

#[test]
fn a_machine_with_errors_is_not_built() {
    let folder = concat!(env!("CARGO_TARGET_TMPDIR"), "/no_posts");
    let built = machc(&["build", "tests/bad/linear_axis_turns.mach", "--workspace", folder]);
    assert_eq!(built.status, Some(1));
    assert!(built.stderr.contains("error[E"), "{}", built.stderr);
    assert!(!Path::new(folder).exists());
}

#[test]
fn two_machines_of_one_name_are_not_built() {
    let folder = concat!(env!("CARGO_TARGET_TMPDIR"), "/no_posts_of_one_name");
    let built = machc(&["build", "machines/vmc3.mach", "machines/vmc3.mach", "--workspace", folder]);
    assert_eq!((built.status, built.stdout.as_str()), (Some(2), ""));
    assert!(built.stderr.contains("`vmc3-post`"), "{}", built.stderr);
    assert!(!Path::new(folder).exists());
}
