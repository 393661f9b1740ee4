//! The chain among the runtime's tables says what was derived of the same machine file: where joints take the tool, and how it
//! moves with each of them.

use mach_runtime::kinematics::{Kinematics, LANES, Lane, PoseBlock, Rate, rates};
use mach_runtime::machine::{Axis, Machine, Motion, Rule, ToolGeometry};
use mach_runtime::vector::{Vec3, angle_rad, norm, scale, sub};
use machc::derive::derive;
use machc::model::machine::Model;
use machc::model::tables;
use machc::plan::Interpreter;
use proptest::prelude::*;

#[path = "common/random.rs"]
mod random;
#[path = "common/machine.rs"]
mod shipped;
#[path = "common/stems.rs"]
mod stems;

use random::{has_its_freedoms, machine, run, with_surplus};

const TIP_BOUND_MM: f64 = 1e-9;
const AXIS_BOUND_RAD: f64 = 1e-12;

const TOOL: ToolGeometry = ToolGeometry::of_length(125.0);

/// Joints spread over the block by a low-discrepancy sequence.
fn joints(machine: &Machine) -> Vec<[f64; LANES]> {
    const STEPS: [f64; 7] = [0.754_877, 0.569_840, 0.618_033, 0.414_213, 0.732_050, 0.236_067, 0.645_751];
    let joint = |(axis, step): (&Axis, f64)| {
        let bound = if axis.motion == Motion::Rotary { 400.0 } else { 500.0 };
        std::array::from_fn(|lane| bound * (2.0 * ((lane + 1) as f64 * step).fract() - 1.0))
    };
    machine.axes.iter().zip(STEPS).map(joint).collect()
}

/// The chain's poses and the plan's, the chain's rates and those of differences.
fn compare(model: &Model) -> Result<(), String> {
    let machine = tables::machine(model);
    compare_poses(model, &machine)?;
    compare_rates(&machine)
}

fn compare_poses(model: &Model, machine: &Machine) -> Result<(), String> {
    let (joints, mut expected) = (joints(machine), PoseBlock::ZERO);
    Interpreter::new(&derive(model)).forward(&joints, TOOL, &mut expected);
    for lane in 0..LANES {
        let values: Vec<f64> = joints.iter().map(|joint| joint[lane]).collect();
        let (tip, axis) = machine.chain.pose(&values, TOOL);
        let (tip_mm, off_rad) = (norm(sub(tip, expected.tip(lane))), angle_rad(axis, expected.axis(lane)));
        if tip_mm > TIP_BOUND_MM || off_rad > AXIS_BOUND_RAD {
            return Err(format!("{}: {tip_mm:e} mm, {off_rad:e} rad", machine.name));
        }
    }
    Ok(())
}

/// Differences over steps of a thousandth keep nine digits.
fn compare_rates(machine: &Machine) -> Result<(), String> {
    const STEP: f64 = 1e-3;
    let (joints, mut found) = (joints(machine), vec![Rate::ZERO; machine.axes.len()]);
    rates(&machine.chain, &joints, TOOL, &mut found);
    for lane in 0..LANES {
        for (axis, rate) in found.iter().enumerate() {
            let moved = |by: f64| {
                let mut values: Vec<f64> = joints.iter().map(|joint| joint[lane]).collect();
                values[axis] += by;
                machine.chain.pose(&values, TOOL)
            };
            let (above, below) = (moved(STEP), moved(-STEP));
            let difference = |a: Vec3, b: Vec3| scale(1.0 / (2.0 * STEP), sub(a, b));
            let at = |rates: &[Lane; 3]| rates.map(|rate| rate[lane]);
            let tip = norm(sub(at(&rate.tip), difference(above.0, below.0)));
            let tilt = norm(sub(at(&rate.axis), difference(above.1, below.1)));
            if tip > 1e-8 || tilt > 1e-11 {
                return Err(format!("{}, axis {axis}: tip off by {tip:e}, tool axis by {tilt:e}", machine.name));
            }
        }
    }
    Ok(())
}

#[test]
fn shipped_machines_have_their_chain_in_the_tables() {
    for name in stems::stems("machines", "mach") {
        let compiled = shipped::compiled(&format!("machines/{name}.mach"), &shipped::Files);
        compare(&compiled.model).expect("one machine");
    }
}

#[test]
fn random_machines_have_their_chain_in_the_tables() {
    for (linears, rotaries) in [(3, 0), (3, 2), (4, 2), (4, 3)] {
        let machines = machine(linears, rotaries).prop_map(|model| with_surplus(model, Rule::Free));
        run(64, machines.prop_filter("every freedom", has_its_freedoms), |model| {
            compare(&model).map_err(TestCaseError::fail)
        });
    }
}
