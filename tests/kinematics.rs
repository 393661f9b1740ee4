//! The derivation closes the loop: for machines of every order of three linear and two rotary axes, with random directions
//! and offsets, the inverse's candidates reach the pose that the forward chain was asked for.

use mach_runtime::kinematics::{LANES, PoseBlock};
use mach_runtime::machine::{Motion, Rule};
use machc::derive::derive;
use machc::model::machine::{Model, ModelJoint, Tool};
use nalgebra::Vector3;
use proptest::prelude::*;

#[path = "common/closing.rs"]
mod closing;
#[path = "common/random.rs"]
mod random;

use closing::{close_blocks, close_the_loop};
use random::{axis, direction, has_its_freedoms, line_angle, machine, model, point, run, with_surplus};

const BLOCKS: usize = 16;

/// The directions of the rotaries, from the workpiece to the tool.
fn rotaries(model: &Model) -> Vec<Vector3<f64>> {
    let axes = model.chain.iter().map(|joint| &model.axes[joint.axis]);
    axes.filter(|axis| axis.motion == Motion::Rotary).map(|axis| axis.direction).collect()
}

#[test]
fn random_machines_close_the_loop_and_miss_no_branch() {
    for rotaries in 0..=2 {
        let machines = machine(3, rotaries).prop_filter("every freedom", has_its_freedoms);
        run(256, machines, |model| close_blocks(&model, &derive(&model), BLOCKS).map_err(TestCaseError::fail));
    }
}

#[test]
fn a_nanoradian_from_the_pole_keeps_every_digit() {
    let machines = machine(3, 2).prop_filter("every freedom", has_its_freedoms);
    run(256, machines, |mut model| {
        // A pole exists where the angle from the first to the second rotary is that from the second to the tool.
        let rotaries: Vec<usize> = model.chain.iter().map(|joint| joint.axis).filter(|&axis| axis >= 3).collect();
        model.tool.axis = model.axes[rotaries[0]].direction;
        let n1 = model.axes[rotaries[0]].direction;
        let aside = n1.cross(&model.axes[rotaries[1]].direction).normalize();
        let mut wanted = PoseBlock::ZERO;
        for lane in 0..LANES {
            let turned = nalgebra::Rotation3::new(n1 * (lane as f64)) * aside;
            let axis = (n1 + 1e-9 * turned).normalize();
            for i in 0..3 {
                wanted.axis[i][lane] = axis[i];
                wanted.tip_mm[i][lane] = (lane * (i + 3) % 17) as f64 * 10.0;
            }
        }
        close_the_loop(&model, &derive(&model), &wanted, None).map_err(TestCaseError::fail)
    });
}

#[test]
fn axes_that_the_pose_leaves_open_take_any_value() {
    for (linears, rotaries) in [(3, 3), (4, 2), (4, 3)] {
        let rule = prop_oneof![Just(Rule::Free), (-90.0..90.0f64).prop_map(Rule::Locked)];
        let machines = (machine(linears, rotaries), rule).prop_map(|(model, rule)| with_surplus(model, rule));
        let machines = machines.prop_filter("every freedom", has_its_freedoms);
        run(256, machines, |model| close_blocks(&model, &derive(&model), BLOCKS).map_err(TestCaseError::fail));
    }
}

/// Whether a rotary makes up for the third linear axis: it does not turn in the plane of the two.
fn is_polar(model: &Model) -> bool {
    let normal = model.axes[0].direction.cross(&model.axes[1].direction);
    normal.norm() > 0.3 && line_angle(&rotaries(model)[0], &normal) > 0.3
}

#[test]
fn two_linear_axes_and_the_rotary_that_turns_about_the_tool_reach_a_point_in_two_ways() {
    let machines = (machine(2, 1), any::<bool>()).prop_map(|(mut model, minus)| {
        model.tool.axis = rotaries(&model)[0] * if minus { -1.0 } else { 1.0 };
        model
    });
    run(512, machines.prop_filter("polar", is_polar), |model| {
        let plan = derive(&model);
        prop_assert_eq!(plan.branches.len(), 2);
        close_blocks(&model, &plan, BLOCKS).map_err(TestCaseError::fail)
    });
}

#[test]
fn two_linear_axes_and_a_rotary_that_turns_the_tool_reach_what_they_can() {
    let has_its_freedoms = |model: &Model| {
        let planar = model.axes[0].direction.cross(&model.axes[1].direction).norm() > 0.3;
        planar && line_angle(&rotaries(model)[0], &model.tool.axis) > 0.3
    };
    run(256, machine(2, 1).prop_filter("every freedom", has_its_freedoms), |model| {
        close_blocks(&model, &derive(&model), BLOCKS).map_err(TestCaseError::fail)
    });
}

#[test]
fn the_ways_of_a_slant_bed_may_lean_as_they_like() {
    let leaning = [-1.0..1.0f64, -1.0..1.0, -0.7..0.7];
    let machines = (leaning, direction(), [point(), point(), point()], 0.0..200.0f64).prop_map(
        |(leaning, tool, points, length_mm)| {
            let [x, y, b] = leaning;
            let axes = vec![
                axis("X", Motion::Linear, Vector3::new(libm::cos(x), libm::sin(x), 0.0), Vector3::zeros()),
                axis("Y", Motion::Linear, Vector3::new(0.0, libm::cos(y), libm::sin(y)), Vector3::zeros()),
                axis("Z", Motion::Linear, Vector3::z(), Vector3::zeros()),
                axis("B", Motion::Rotary, Vector3::new(libm::sin(b), libm::cos(b), 0.0), points[0]),
                axis("C", Motion::Rotary, Vector3::z(), points[1]),
            ];
            let chain = [4, 2, 0, 1, 3].map(|axis| ModelJoint { axis, primed: false }).to_vec();
            model(axes, chain, Tool { axis: tool, gauge_mm: points[2], length_mm })
        },
    );
    run(256, machines.prop_filter("every freedom", has_its_freedoms), |model| {
        close_blocks(&model, &derive(&model), BLOCKS).map_err(TestCaseError::fail)
    });
}
