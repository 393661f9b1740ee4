//! The kinematics modules of LinuxCNC, described as machines: the same joints for the same poses.
//!
//! `tests/linuxcnc/NAME.mach` is the machine, `rows.json` holds for each machine its parameters' values, tips and joints
//! as the modules compute them, in millimetres and degrees. The modules never solve for the angles, so a row is checked
//! three ways: the linear joints for its rotary angles, the forward chain of its joints, and the inverse of that pose.

use mach_runtime::kinematics::{Kinematics, LANES, PoseBlock, SolutionBlock};
use mach_runtime::vector::{norm, sub};
use machc::compile::Compiled;
use machc::model::machine::Model;
use machc::plan::Interpreter;

#[path = "common/machine.rs"]
mod machine;
#[path = "common/rows.rs"]
mod rows;

use rows::{Row, Templates};

/// Of lengths in millimetres and of angles in degrees.
const BOUND: f64 = 1e-9;

/// The row's joints in the order of the model.
fn joints(model: &Model, row: &Row) -> Vec<f64> {
    model.axes.iter().map(|axis| row.joints[&axis.name]).collect()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= BOUND
}

/// Equal up to whole turns.
fn same_angle(a_deg: f64, b_deg: f64) -> bool {
    let turns = ((a_deg - b_deg) / 360.0).round();
    close(a_deg, b_deg + 360.0 * turns)
}

fn check(name: &str, Compiled { model, plan, .. }: &Compiled, row: &Row) {
    let mut machine = Interpreter::new(plan);
    let wanted = joints(model, row);
    let rotary = |axis: usize| model.axes[axis].name.starts_with(['A', 'B', 'C']);

    let axes = wanted.len();
    let mut placed: Vec<f64> = (0..axes).map(|axis| if rotary(axis) { wanted[axis] } else { f64::NAN }).collect();
    machine.position(row.tip, model.tool.geometry(), &mut placed).expect("the tip is held");
    assert!((0..axes).all(|axis| close(placed[axis], wanted[axis])), "{name}: {placed:?} is not {wanted:?}");

    let mut pose = PoseBlock::ZERO;
    let block = wanted.iter().map(|joint| [*joint; LANES]).collect();
    machine.forward(&block, model.tool.geometry(), &mut pose);
    assert!(norm(sub(pose.tip(0), row.tip)) <= BOUND, "{name}: {:?} is not {:?}", pose.tip(0), row.tip);

    let surplus: Vec<_> = machine.surplus_axes().iter().map(|&axis| [wanted[axis]; LANES]).collect();
    let mut solutions = SolutionBlock::of(&machine);
    machine.inverse(&pose, &surplus, model.tool.geometry(), &mut solutions);
    let is_wanted = |candidate: &Vec<[f64; LANES]>| {
        let same = |axis| if rotary(axis) { same_angle } else { close }(candidate[axis][0], wanted[axis]);
        (0..axes).all(same)
    };
    let candidates: Vec<Vec<f64>> =
        solutions.branches.iter().map(|branch| branch.iter().map(|joint| joint[0]).collect()).collect();
    assert!(solutions.branches.iter().any(is_wanted), "{name}: none of {candidates:?} is {wanted:?}");
}

#[test]
fn machines_of_linuxcnc_have_the_joints_that_linuxcnc_computes() {
    for (name, rows) in rows::all() {
        assert!(rows.len() >= 6, "{name}");
        for row in &rows {
            check(&name, &machine::compiled(&format!("tests/linuxcnc/{name}.mach"), &Templates(row)), row);
        }
    }
}
