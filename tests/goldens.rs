//! Published CL data with the NC that belongs to it, in `tests/goldens`.
//!
//! `sine`: an NX job on a sine surface and the NC of a Tongtai TMV-710A. `sine.csv` has a row for each GOTO: the joints by
//! the authors' formulas, and then (from the third GOTO on) the words that NX printed. `impeller`: points of an impeller
//! and the NC of a table-tilting machine all of whose axes move the workpiece, good to 2e-4.

use mach_runtime::cl::{Next, Reader};
use mach_runtime::kinematics::Kinematics;
use mach_runtime::path::PathSolver;
use mach_runtime::rig::reader_options;
use mach_runtime::toolpath::Point;
use machc::compile::Compiled;
use machc::model::tables;
use machc::plan::Interpreter;
use std::fs;

#[path = "common/machine.rs"]
mod machine;
#[path = "common/program.rs"]
mod program;

const SINE: &str = "tests/goldens/sine.cls";

/// X Y Z A C.
type Row = [f64; 5];

/// The names of a row's values.
const NAMES: [&str; 5] = ["X", "Y", "Z", "A", "C"];

/// The rows of a table's columns from `column` on; none for rows that are empty there.
fn table(path: &str, column: usize) -> Vec<Option<Row>> {
    let text = fs::read_to_string(machine::root().join(path)).expect("readable");
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').skip(column).collect();
        let numbers: Vec<f64> = cells.iter().take(5).filter_map(|cell| cell.parse().ok()).collect();
        Row::try_from(numbers).ok()
    };
    text.lines().skip(1).map(row).collect()
}

/// The chosen joints of every point, and the points.
fn solved(Compiled { model, plan, .. }: &Compiled, cl: &str) -> (Vec<Row>, Vec<Point>) {
    assert!(model.axes.iter().map(|axis| axis.name.as_str()).eq(NAMES), "joints are in the order of a row");
    let tables = tables::machine(model);
    let mut kinematics = Interpreter::new(plan);
    let mut path = PathSolver::new(&tables, &mut kinematics);
    let text = fs::read(machine::root().join(cl)).expect("readable");
    let mut reader = Reader::new(cl, text.as_slice(), reader_options(&tables));
    let (mut points, mut rows, mut all) = (Vec::new(), Vec::new(), Vec::new());
    loop {
        points.clear();
        let next = reader.next_into(&mut points, 64).expect("reading from memory does not fail");
        path.solve(&points, &mut |solved| {
            let joints = solved.chosen().expect("every point is within reach and travel").joints.as_slice();
            rows.push(Row::try_from(joints).expect("five axes"));
        });
        all.extend_from_slice(&points);
        if next == Next::End {
            return (rows, all);
        }
    }
}

/// The words of every motion, modal words carried along: the blocks that print an axis, from the one on with which every axis
/// has been given.
fn printed(nc: &str) -> Vec<Row> {
    let mut current = [f64::NAN; 5];
    let mut rows = Vec::new();
    for block in nc.lines().filter(|line| !line.contains("G53")) {
        let words = block.split_whitespace();
        let axis_word =
            |word: &str| Some((NAMES.iter().position(|name| word.starts_with(name))?, word[1..].parse().ok()?));
        let found: Vec<(usize, f64)> = words.filter_map(axis_word).collect();
        found.iter().for_each(|&(axis, value)| current[axis] = value);
        if !found.is_empty() && current.iter().all(|value| value.is_finite()) {
            rows.push(current);
        }
    }
    rows
}

fn assert_close(found: &[Row], wanted: &[Option<Row>], bound: f64, wrap: bool) {
    assert_eq!(found.len(), wanted.len());
    for (index, (found, wanted)) in found.iter().zip(wanted).enumerate() {
        let Some(wanted) = wanted else { continue };
        for axis in 0..5 {
            let turn = if wrap && axis == 4 { 360.0 } else { f64::INFINITY };
            let off = (found[axis] - wanted[axis]).abs();
            let off = off.min((turn - off).abs());
            assert!(off <= bound, "point {index}, {}: {} is not {}", NAMES[axis], found[axis], wanted[axis]);
        }
    }
}

#[test]
fn the_joints_of_the_sine_surface_are_the_published_ones() {
    let machine = machine::compiled("machines/tmv710a.mach", &machine::Files);
    let analytic = table("tests/goldens/sine.csv", 0);
    assert!(analytic.len() == 47 && analytic.iter().all(Option::is_some));
    assert_close(&solved(&machine, SINE).0, &analytic, 1.1e-5, true);
}

#[test]
fn the_words_of_the_sine_surface_are_those_of_nx() {
    let machine = machine::compiled("machines/tmv710a.mach", &machine::Files);
    let posted = program::posted(&machine, SINE);
    // Its steps are long for a table that turns; nothing else is to be said.
    let codes: Vec<&str> = posted.diagnostics.iter().map(|diagnostic| diagnostic.code.id).collect();
    assert_eq!(codes, ["W1110"]);
    let nc = String::from_utf8(posted.nc).expect("ASCII");
    let rows = printed(&nc);
    assert!(rows.iter().all(|row| (0.0..360.0).contains(&row[4])), "C is written in [0, 360)");
    let nx = table("tests/goldens/sine.csv", 5);
    assert_eq!(nx.iter().flatten().count(), 45);
    assert_close(&rows, &nx, 0.0011, false);
}

#[test]
fn numbers_are_printed_as_nx_printed_them() {
    let machine = machine::compiled("machines/tmv710a.mach", &machine::Files);
    let nc = program::posted(&machine, SINE).nc;
    for words in ["X70.711", " Y18.271", " Z21.124", " A23.955", " C315.", " X.483 ", " X0.0 ", " X25. ", " C.002\n"] {
        let found = nc.windows(words.len()).any(|window| window == words.as_bytes());
        assert!(found, "`{words}` is not in\n{}", String::from_utf8_lossy(&nc));
    }
}

/// The published figures come from an iteration that was stopped early: their angles are good to 2e-4 deg, and so are
/// their lengths, in millimetres, for these angles. (45 mm from the axis, that much angle moves the tip as much again.)
#[test]
fn the_joints_of_the_impeller_are_the_published_ones() {
    let machine = machine::compiled("tests/goldens/impeller.mach", &machine::Files);
    let published: Vec<Row> = table("tests/goldens/impeller.csv", 0).into_iter().flatten().collect();
    assert_eq!(published.len(), 3);
    let (rows, points) = solved(&machine, "tests/goldens/impeller.cls");
    let mut kinematics = Interpreter::new(&machine.plan);
    for ((row, point), published) in rows.iter().zip(&points).zip(&published) {
        let mut at_published_angles = *published;
        kinematics
            .position(point.tip_mm, machine.model.tool.geometry(), &mut at_published_angles)
            .expect("the tip is held");
        let found = [&at_published_angles[..3], &row[3..]].concat();
        for (axis, name) in NAMES.into_iter().enumerate() {
            let (found, published) = (found[axis], published[axis]);
            assert!((found - published).abs() <= 2e-4, "{name}: {found} is not {published}");
        }
    }
}
