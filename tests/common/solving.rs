//! Axes along a path, as `machc solve` gives them.

use super::machc::{Run, Workshop};
use serde_json::Value;

/// Solves this CL on this machine, a line a point.
pub(crate) fn solved(machine: &str, cl: &str) -> Vec<Value> {
    let workshop = Workshop::new("solving");
    workshop.write("m.mach", machine);
    let Run { stdout, stderr, .. } = workshop.run_with(&["solve", "m.mach", "-"], cl);
    let lines: Vec<Value> = stdout.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    assert!(!lines.is_empty(), "{stderr}");
    lines
}

/// The chosen values of these axes, to six decimals.
pub(crate) fn chosen<const N: usize>(line: &Value, axes: [&str; N]) -> [f64; N] {
    let index = line["chosen"].as_u64().unwrap_or_else(|| panic!("no way: {line}")) as usize;
    let joints = &line["candidates"][index]["joints"];
    axes.map(|axis| (joints[axis].as_f64().expect("a number") * 1e6).round() / 1e6)
}

/// What posting this CL on this machine says, and its exit status.
pub(crate) fn told(machine: &str, cl: &str) -> (i32, String) {
    let workshop = Workshop::new("told");
    workshop.write("m.mach", machine);
    workshop.write("part.cls", cl);
    let run = workshop.run(&["post", "m.mach", "part.cls"]);
    (run.status, run.stderr)
}

/// A controller for every axis.
pub(crate) const PLAIN: &str = "\
controller plain {
    format number \"#####.###\"
    word X Y Z W A B C F number
    group motion { rapid \"G0\"  line \"G1\" }
    on rapid { \"G0 {axes}\" }
    on feed { \"G1 {axes} {feed}\" }
}
";
