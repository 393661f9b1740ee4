//! Generated C: a kinematics module for each machine, compiled against stand-ins for LinuxCNC's headers, and asked.

use crate::blocks::{Block, blocks};
use crate::rows::{self, Templates};
use crate::{library, machine};
use mach_runtime::kinematics::{Kinematics, LANES, PoseBlock};
use mach_runtime::machine::Motion;
use machc::compile::Compiled;
use machc::emit::c::c;
use machc::plan::Interpreter;
use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

/// Of lengths in millimetres, for each millimetre beyond a metre as much again.
const BOUND: f64 = 1e-9;

/// What the module answers to these lines, and before them what its pin holds.
fn answers(compiled: &Compiled, lines: &str) -> Vec<Vec<f64>> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("linuxcnc");
    let stand_ins = machine::root().join("tests/emit/linuxcnc");
    fs::create_dir_all(&folder).expect("writable");
    let program = folder.join(&compiled.model.name);
    let source = program.with_extension("c");
    fs::write(&source, c(compiled).expect("LinuxCNC knows its axes")).expect("writable");
    let mut compiler = Command::new("cc");
    compiler.args(["-std=gnu99", "-Wall", "-Wextra", "-Werror", "-I"]).arg(&stand_ins);
    compiler.arg(&source).arg(stand_ins.join("harness.c")).arg("-o").arg(&program).arg("-lm");
    let output = compiler.output().expect("a C compiler is there: Rust links with it");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
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

/// The line that asks for the joints at a place of the world, with the angles of these joints.
fn inverse_line(compiled: &Compiled, world: [f64; 3], joints: &[f64]) -> String {
    let mut line = format!("I {} {} {}", world[0], world[1], world[2]);
    for word in ["A", "B", "C"] {
        let axis = compiled.model.axes.iter().position(|axis| axis.name == word);
        write!(line, " {}", axis.map_or(0.0, |axis| joints[axis])).expect("strings can be written");
    }
    line + "\n"
}

fn forward_line(joints: &[f64]) -> String {
    let joints: Vec<String> = (0..9).map(|joint| joints.get(joint).copied().unwrap_or(0.0).to_string()).collect();
    format!("F {}\n", joints.join(" "))
}

/// Where the angles of the joints stand in the world's coordinates.
fn world_angles(compiled: &Compiled, joints: &[f64]) -> [f64; 3] {
    ["A", "B", "C"]
        .map(|word| compiled.model.axes.iter().position(|axis| axis.name == word).map_or(0.0, |axis| joints[axis]))
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
    for Block { tool_length_mm, joints, .. } in blocks(compiled) {
        let mut poses = PoseBlock::ZERO;
        interpreter.forward(&joints, tool_length_mm, &mut poses);
        writeln!(lines, "L {tool_length_mm}").expect("strings can be written");
        for lane in 0..LANES {
            let joints: Vec<f64> = joints.iter().map(|joint| joint[lane]).collect();
            let world = world(compiled, poses.tip(lane), tool_length_mm);
            lines += &forward_line(&joints);
            wanted.push([world, world_angles(compiled, &joints)].concat());
            let mut placed = joints.clone();
            interpreter.position(poses.tip(lane), tool_length_mm, &mut placed);
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
            require(&name, &answers[1], &[row.tip, world_angles(&compiled, &joints)].concat());
            require(&name, &answers[2], &joints);
        }
    }
}

#[test]
fn a_place_where_linear_axes_lose_a_direction_is_refused() {
    let compiled = machine::compiled("machines/tilting_ram.mach", &machine::Files);
    let rotary = |axis: &&machc::model::machine::Axis| axis.motion == Motion::Rotary;
    assert_eq!(compiled.model.axes.iter().filter(rotary).count(), 2);
    let answers = answers(&compiled, "I 10 20 30 90 90 90\nI inf 20 30 0 0 0\n");
    assert_eq!(answers[2][0], -1.0, "{answers:?}");
}

#[test]
fn an_angle_that_linuxcnc_has_not_is_refused() {
    struct Renamed;
    impl machc::compile::Sources for Renamed {
        fn read(&self, _: &str) -> Result<String, String> {
            Ok("machine renamed {\n    chain w C1 b X Y Z t\n    linear X along +x\n    linear Y along +y\n    \
                linear Z along +z\n    rotary C1 about +x\n    tool along +z\n}\n"
                .to_owned())
        }
    }
    let diagnostic = c(&machine::compiled("renamed.mach", &Renamed)).expect_err("there is no C1");
    assert_eq!((diagnostic.code.id, diagnostic.labels[0].place.line), ("E0602", 6));
}
