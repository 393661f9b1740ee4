//! A published program, read: `goldens/sine_numeric.csv` has rows of the numeric NC list of a 2017 thesis on five-axis posts
//! (the same job and machine as `goldens/sine.cls`: a Tongtai TMV-710A, A/C trunnion, its rotary centre 20 mm below the part's
//! zero), and the tips and tool axes that the thesis finds for them by its forward chain. Z counts from 175 mm above the
//! part's zero; A and C are unwound.

use super::machine::{Files, compiled, root};
use mach_runtime::verify::{ReverseCl, Verifier};
use machc::compile::Compiled;
use machc::model::tables;
use machc::plan::Interpreter;
use std::fmt::Write;
use std::fs;

/// Rows: X, Y, Z, A, C, the tip in millimetres and the unit tool axis.
type Row = [f64; 11];

/// How far above the part's zero the program's Z has its own, in millimetres.
const ZERO_MM: f64 = 175.0;

fn rows() -> Vec<Row> {
    let text = fs::read_to_string(root().join("tests/goldens/sine_numeric.csv")).expect("readable");
    let row = |line: &str| -> Row {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().expect("a number")).collect();
        cells.try_into().expect("eleven numbers")
    };
    text.lines().skip(1).map(row).collect()
}

/// The rows as a program, every word with its point.
fn program(rows: &[Row]) -> String {
    let mut nc = "G17 G21 G40 G49 G90 G94\nG54\nT1 M6\nS1000 M3\n".to_owned();
    for [x, y, z, a, c, ..] in rows {
        writeln!(nc, "G1 X{x:.6} Y{y:.6} Z{z:.6} A{a:.6} C{c:.6} F1000.").expect("memory can be written");
    }
    nc + "M5\nM30\n"
}

/// The points of a program, as CL text.
fn points(Compiled { model, plan, .. }: &Compiled, nc: &str) -> String {
    let (machine, dialect) = (tables::machine(model), model.dialect.as_ref().expect("the machine has a controller"));
    let mut cl = Vec::new();
    let reverse = ReverseCl::begin(&mut cl, &machine, "LIST").expect("memory can be written");
    let mut kinematics = Interpreter::new(plan);
    let mut verifier = Verifier::new("list.nc", &dialect.table, &machine, &mut kinematics).written_as(Some(reverse));
    let told = &mut |it| panic!("{it:?}");
    for (number, line) in (1..).zip(nc.lines()) {
        verifier.line(line, number, told).expect("memory can be written");
    }
    verifier.finish(told).expect("memory can be written");
    String::from_utf8(cl).expect("ASCII")
}

#[test]
fn the_published_list_goes_to_the_published_tips() {
    let machine = compiled("tests/goldens/sine_numeric.mach", &Files);
    let rows = rows();
    let cl = points(&machine, &program(&rows));
    let found: Vec<&str> = cl.lines().filter_map(|line| line.strip_prefix("GOTO/")).collect();
    assert_eq!((found.len(), rows.len()), (4, 4), "{cl}");
    for (found, row) in found.iter().zip(&rows) {
        let mut pose: Vec<f64> = found.split(',').map(|number| number.parse().expect("a number")).collect();
        pose[2] += ZERO_MM;
        for (index, (found, wanted)) in pose.iter().zip(&row[5..]).enumerate() {
            let bound = if index < 3 { 1e-4 } else { 1e-6 };
            assert!((found - wanted).abs() <= bound, "{index}: {found} is not {wanted}\n{cl}");
        }
    }
}

/// Counted from the part's zero, the same list is 175 mm off: the test above has looked.
#[test]
fn the_zero_of_the_list_matters() {
    let rows = rows();
    let cl = points(&compiled("machines/tmv710a.mach", &Files), &program(&rows));
    let first = cl.lines().find_map(|line| line.strip_prefix("GOTO/")).expect("a point");
    let z: f64 = first.split(',').nth(2).expect("z").parse().expect("a number");
    assert!((z - rows[0][7]).abs() > 100.0, "{cl}");
}
