//! Generated C: a kinematics module for each machine, compiled against stand-ins for LinuxCNC's headers, and asked.

use crate::blocks::{Block, blocks};
use crate::rows::{self, Templates};
use crate::{library, machine};
use mach_runtime::kinematics::{Kinematics, LANES, PoseBlock};
use machc::compile::Compiled;
use machc::emit::c::c;
use machc::plan::Interpreter;
use std::ffi::OsStr;
use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;

/// Of lengths in millimetres, for each millimetre beyond a metre as much again.
const BOUND: f64 = 1e-9;

/// Runs the C compiler in the stand-ins' folder.
fn cc(arguments: &[&OsStr]) {
    let mut compiler = Command::new("cc");
    compiler.args(["-std=gnu99", "-Wall", "-Wextra", "-Werror", "-I."]).args(arguments);
    let output = compiler.current_dir(machine::root().join("tests/emit/linuxcnc")).output();
    let output = output.expect("a C compiler is there: Rust links with it");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// What loads and asks a module, compiled once.
fn harness() -> &'static Path {
    static HARNESS: OnceLock<PathBuf> = OnceLock::new();
    HARNESS.get_or_init(|| {
        let object = Path::new(env!("CARGO_TARGET_TMPDIR")).join("linuxcnc_harness.o");
        cc(&["-c".as_ref(), "harness.c".as_ref(), "-o".as_ref(), object.as_ref()]);
        object
    })
}

/// What the module answers to these lines, and before them what its pin holds.
fn answers(compiled: &Compiled, lines: &str) -> Vec<Vec<f64>> {
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).expect("writable");
    let [source, program] = ["module.c", "module"].map(|name| folder.path().join(name));
    fs::write(&source, c(compiled).expect("LinuxCNC knows its axes")).expect("writable");
    cc(&[source.as_ref(), harness().as_ref(), "-o".as_ref(), program.as_ref(), "-lm".as_ref()]);
    let mut process =
        Command::new(&program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("the program starts");
    let mut input = process.stdin.take().expect("piped");
    let lines = lines.to_owned();
    let writer = std::thread::spawn(move || input.write_all(lines.as_bytes()).expect("it reads everything"));
    let output = process.wait_with_output().expect("it ends");
    writer.join().expect("everything was written");
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).expect("numbers");
    text.lines().map(|line| line.split(' ').map(|number| number.parse().expect("a number")).collect()).collect()
}

/// The world's coordinates of a tip with a tool of this length.
fn world(compiled: &Compiled, tip: [f64; 3], length_mm: f64) -> [f64; 3] {
    std::array::from_fn(|i| tip[i] + compiled.model.tool.axis[i] * length_mm)
}

/// The world's coordinates beside those of the tip.
const COPIED: [&str; 6] = ["A", "B", "C", "U", "V", "W"];

/// The line that asks for the joints at a place of the world, with the rest of its coordinates from these joints.
fn inverse_line(compiled: &Compiled, world: [f64; 3], joints: &[f64]) -> String {
    let mut line = format!("I {} {} {}", world[0], world[1], world[2]);
    for value in copied(compiled, joints) {
        write!(line, " {value}").expect("strings can be written");
    }
    line + "\n"
}

fn forward_line(joints: &[f64]) -> String {
    let joints: Vec<String> = (0..9).map(|joint| joints.get(joint).copied().unwrap_or(0.0).to_string()).collect();
    format!("F {}\n", joints.join(" "))
}

/// The joints that the world's coordinates hold as they are.
fn copied(compiled: &Compiled, joints: &[f64]) -> [f64; 6] {
    COPIED.map(|word| compiled.model.axes.iter().position(|axis| axis.name == word).map_or(0.0, |axis| joints[axis]))
}

/// An answer: no failure, and these numbers first.
fn require(name: &str, answer: &[f64], wanted: &[f64]) {
    assert_eq!((answer.len(), answer[0]), (10, 0.0), "{name}");
    for (found, wanted) in answer[1..].iter().zip(wanted) {
        let bound = BOUND * (wanted.abs() / 1000.0).max(1.0);
        assert!((found - wanted).abs() <= bound, "{name}: {answer:?} is not {wanted}");
    }
}

/// Where each lane of these blocks leads, by the interpreter: question, and answer wanted.
fn conversation(compiled: &Compiled) -> (String, Vec<Vec<f64>>) {
    let (mut lines, mut wanted) = (String::new(), Vec::new());
    let mut interpreter = Interpreter::new(&compiled.plan);
    for Block { tool, joints, .. } in blocks(compiled) {
        let mut poses = PoseBlock::ZERO;
        interpreter.forward(&joints, tool, &mut poses);
        writeln!(lines, "L {}", tool.length_mm).expect("strings can be written");
        for lane in 0..LANES {
            let joints: Vec<f64> = joints.iter().map(|joint| joint[lane]).collect();
            let world = world(compiled, poses.tip(lane), tool.length_mm);
            lines += &forward_line(&joints);
            wanted.push([&world[..], &copied(compiled, &joints)].concat());
            let mut placed = joints.clone();
            interpreter.position(poses.tip(lane), tool, &mut placed).expect("the tip is held");
            lines += &inverse_line(compiled, world, &joints);
            wanted.push(placed);
        }
    }
    (lines, wanted)
}

#[test]
fn generated_c_computes_the_numbers_of_the_interpreter() {
    for compiled in library() {
        let name = &compiled.model.name;
        let (lines, wanted) = conversation(&compiled);
        let answers = answers(&compiled, &lines);
        assert_eq!(answers[0], [compiled.model.tool.length_mm], "{name}: the pin");
        assert_eq!(answers.len(), wanted.len() + 1, "{name}");
        answers[1..].iter().zip(&wanted).for_each(|(answer, wanted)| require(name, answer, wanted));
    }
}

#[test]
fn generated_c_computes_what_the_modules_of_linuxcnc_compute() {
    for (name, rows) in rows::all() {
        for row in &rows {
            let compiled = machine::compiled(&format!("tests/linuxcnc/{name}.mach"), &Templates(row));
            let joints: Vec<f64> = compiled.model.axes.iter().map(|axis| row.joints[&axis.name]).collect();
            assert_eq!(compiled.model.tool.length_mm, 0.0);
            let answers = answers(&compiled, &(forward_line(&joints) + &inverse_line(&compiled, row.tip, &joints)));
            require(&name, &answers[1], &[&row.tip[..], &copied(&compiled, &joints)].concat());
            require(&name, &answers[2], &joints);
        }
    }
}

#[test]
fn errors_by_position_are_named_as_left_out() {
    let head = |file: &str| c(&machine::compiled(file, &machine::Files)).expect("its axes are LinuxCNC's");
    let named = "Not in here are the errors that depend on a position: EXX, EYX, EBX, EYY, EZZ, EZC, EAC.";
    assert!(head("machines/tmv710a_measured.mach").contains(named));
    assert!(!head("machines/tmv710a.mach").contains("Not in here"));
}

#[test]
fn joints_that_are_no_numbers_are_refused() {
    let compiled = machine::compiled("machines/tilting_ram.mach", &machine::Files);
    let answers = answers(&compiled, "I 10 20 30 0 0 0 0 0 0\nI inf 20 30 0 0 0 0 0 0\n");
    assert_eq!([answers[1][0], answers[2][0]], [0.0, -1.0], "{answers:?}");
    assert_eq!(answers[2][1..], [0.0; 9], "the joints stay as they were");
}

#[test]
fn an_angle_that_linuxcnc_has_not_is_refused() {
    struct Renamed;
    impl machc::sources::Sources for Renamed {
        fn read(&self, _: &str) -> Result<String, String> {
            Ok("machine renamed {\n    chain w C1 b X Y Z t\n    linear X along +x\n    linear Y along +y\n    \
                linear Z along +z\n    rotary C1 about +x\n    tool along +z\n}\n"
                .to_owned())
        }
    }
    let diagnostic = c(&machine::compiled("renamed.mach", &Renamed)).expect_err("there is no C1");
    assert_eq!((diagnostic.code.id, diagnostic.labels[0].place.line), ("E0602", 6));
}
