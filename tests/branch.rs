//! Which of a machine's positions is taken, seen from outside: the rotary axes along a path.

#[path = "cli/machc.rs"]
#[allow(dead_code)]
mod machc;

use machc::{MILL, Run, Workshop};
use serde_json::Value;

/// A and C at each point on `mill.mach` with this travel of A and these statements.
fn rotaries(travel_a: &str, statements: &str, cl: &str) -> Vec<(f64, f64)> {
    let workshop = Workshop::new("branch");
    let machine = MILL.replace("-30 .. 120 deg", travel_a).replace("tool along", &format!("{statements} tool along"));
    workshop.write("mill.mach", &machine);
    let Run { status, stdout, stderr } = workshop.run_with(&["solve", "mill.mach", "-"], cl);
    assert_eq!((status, stderr.as_str()), (0, ""));
    let chosen = |line: &str| {
        let line: Value = serde_json::from_str(line).expect("JSON");
        let joints = &line["candidates"][line["chosen"].as_u64().expect("chosen") as usize]["joints"];
        let rounded = |axis: &str| (joints[axis].as_f64().expect("a number") * 1e6).round() / 1e6;
        (rounded("A"), rounded("C"))
    };
    stdout.lines().map(chosen).collect()
}

/// Vertical, in rapid and then at feed, before the cut tilts by 30 degrees towards +y or +x.
const TO_Y: &str = "RAPID\nGOTO/0,0,50,0,0,1\nFEDRAT/100\nGOTO/0,0,0\nGOTO/0,0,0,0,.5,.866025403784\n";
const TO_X: &str = "RAPID\nGOTO/0,0,50,0,0,1\nFEDRAT/100\nGOTO/0,0,0\nGOTO/0,0,0,.5,0,.866025403784\n";

#[test]
fn at_the_pole_the_free_axis_waits_where_the_cut_wants_it() {
    assert_eq!(rotaries("-20 .. 120 deg", "", TO_Y), [(0.0, 180.0), (0.0, 180.0), (30.0, 180.0)]);
    assert_eq!(rotaries("-90 .. 90 deg", "", TO_Y), [(0.0, 0.0), (0.0, 0.0), (-30.0, 0.0)]);
}

#[test]
fn the_start_rule_holds_for_a_program_that_starts_at_the_pole() {
    let positive = "branch { start positive A }";
    assert_eq!(rotaries("-90 .. 90 deg", positive, TO_Y), [(0.0, 180.0), (0.0, 180.0), (30.0, 180.0)]);
    let positive_x = rotaries("-90 .. 90 deg", positive, TO_X);
    let negative_x = rotaries("-90 .. 90 deg", "branch { start negative A }", TO_X);
    assert_eq!((positive_x[2].0, negative_x[2].0), (30.0, -30.0));
    assert_eq!((positive_x[0].1, negative_x[0].1), (positive_x[2].1, negative_x[2].1));
}

#[test]
fn in_a_cut_and_without_a_tilt_to_come_the_free_axis_stays() {
    let cut = "FEDRAT/100\nGOTO/0,0,0,.5,0,.866025403784\nGOTO/0,0,0,0,0,1\nGOTO/0,0,0,0,.5,.866025403784\n";
    let free = rotaries("-90 .. 90 deg", "", cut);
    assert_eq!(free[0].1, free[1].1);
    let vertical = "RAPID\nGOTO/0,0,0,.5,0,.866025403784\nRAPID\nGOTO/0,0,0,0,0,1\nRAPID\nGOTO/9,0,0\n";
    let vertical = rotaries("-90 .. 90 deg", "", vertical);
    assert_eq!((vertical[0].1, vertical[0].1), (vertical[1].1, vertical[2].1));
}

#[test]
fn a_point_out_of_reach_has_candidates_of_its_own() {
    let workshop = Workshop::new("out_of_reach");
    let machine = MILL.replace("chain w C A b", "chain w A b").replace("rotary C about", "// ");
    workshop.write("mill.mach", &machine);
    let run = workshop.run_with(&["solve", "mill.mach", "-"], "RAPID\nGOTO/1,2,3,0,0,1\nRAPID\nGOTO/4,5,6,1,0,0\n");
    assert_eq!(run.status, 1, "{}", run.stderr);
    let line: Value = serde_json::from_str(run.stdout.lines().nth(1).expect("two points")).expect("JSON");
    assert_eq!((&line["chosen"], &line["candidates"][0]["joints"]["X"]), (&Value::Null, &4.0.into()));
}

#[test]
fn a_limit_can_be_reached_exactly() {
    assert_eq!(rotaries("-30 .. 120 deg", "", TO_Y)[2].0, -30.0);
    assert_eq!(rotaries("0 .. 30 deg", "", TO_Y)[2].0, 30.0);
}
