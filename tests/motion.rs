//! `machc motion` from outside: a program as the motion that its text means.

#[path = "cli/machc.rs"]
#[allow(dead_code)]
mod machc;

use machc::{Run, Workshop};
use serde_json::{Value, json};

/// A mill that has what a program can say.
const MILL: &str = r#"
use "controllers/syntec.mach"
machine mill {
    chain w B b X Y Z t
    linear X along +x  travel -500 .. 500
    linear Y along +y  travel -500 .. 500
    linear Z along +z  travel -500 .. 500
    rotary B about +y  through (0, 0, 0)  turns unlimited
    tool along +z  length 50 mm
    controller syntec { }
}
"#;

/// Every kind of item, and what is modal changed between them.
const PROGRAM: &str = "\
%
G17 G21 G40 G49 G80 G90 G94 G54
G53 G0 Z0.
T3 M6
S3000 M3
G0 X10. Y0. B-0.
G43 H5 Z5.
M8
G1 Z-1.5 F200.
G3 X0. Y10. I-10. J0.
G2 X-10. Y20. R-10.
G91 G1 X-0.00001 B-90.
G90 G20 X0.5 F10.
G21 G95 F0.15 X12.
G18
G4 X0.5
M1
M0
M5
G28 Z0.
G55 G0 X0.
M30
%
";

fn motion(name: &str, program: &str, more: &[&str]) -> Run {
    let workshop = Workshop::new(name);
    workshop.write("mill.mach", MILL);
    workshop.write("part.nc", program);
    workshop.run(&[&["motion", "mill.mach", "part.nc"], more].concat())
}

fn objects(run: &Run) -> Vec<Value> {
    run.stdout.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
}

#[test]
fn a_program_as_motion() {
    let Run { status, stdout, stderr } = motion("motion-text", PROGRAM, &[]);
    assert_eq!((status, stderr.as_str()), (0, ""));
    insta::assert_snapshot!("program", stdout);
}

#[test]
fn the_same_as_json_lines() {
    let Run { status, stdout, stderr } = motion("motion-json", PROGRAM, &["--json"]);
    assert_eq!((status, stderr.as_str()), (0, ""));
    insta::assert_snapshot!("program_json", stdout);
}

#[test]
fn text_has_as_many_decimals_as_are_asked_for_and_json_has_all() {
    let program = "G17 G21 G90 G94 G54\nG0 X-0.00004 Y1.23456 Z0. B0.\n";
    let said = |run: Run| run.stdout.lines().last().expect("an item").split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(said(motion("motion-four", program, &[])), "2 rapid 0.0000 1.2346 0.0000 0.0000 O1");
    assert_eq!(said(motion("motion-two", program, &["--decimals", "2"])), "2 rapid 0.00 1.23 0.00 0.00 O1");
    let json = &objects(&motion("motion-all", program, &["--json"]))[0];
    assert_eq!(json["joints"], json!({ "X": -0.000_04, "Y": 1.234_56, "Z": 0.0, "B": 0.0 }));
}

#[test]
fn a_line_that_the_control_does_not_understand_is_told_and_does_nothing() {
    let Run { status, stdout, stderr } = motion("motion-unknown", "G0 X1.\nG0 X2. M77\nG0 X3.\n", &[]);
    assert_eq!(status, 1);
    assert!(stderr.contains("error[E1201]: the controller knows no word `M77`"), "{stderr}");
    let lines: Vec<&str> = stdout.lines().skip(1).map(|line| line.split_whitespace().next().expect("a line")).collect();
    assert_eq!(lines, ["1", "3"]);
}
