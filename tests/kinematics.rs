//! The derivation closes the loop: for machines of every order of three linear and two rotary axes, with random directions
//! and offsets, the inverse's candidates reach the pose that the forward chain was asked for.

use mach_runtime::kinematics::{LANES, PoseBlock};
use mach_runtime::machine::{BranchPolicy, Motion, Rule, Strictness, Travel, Written};
use machc::derive::{derive, family};
use machc::model::errors::Errors;
use machc::model::machine::{Axis, Joint, Model, Tool};
use nalgebra::Vector3;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

#[path = "common/closing.rs"]
mod closing;

use closing::{close_blocks, close_the_loop};

const BLOCKS: usize = 16;

fn direction() -> impl Strategy<Value = Vector3<f64>> {
    let free = [-1.0..1.0f64, -1.0..1.0, -1.0..1.0].prop_filter_map("a direction", |v| {
        let v = Vector3::from(v);
        (v.norm() > 0.1).then(|| v.normalize())
    });
    let along = (0..3usize, any::<bool>()).prop_map(|(i, minus)| Vector3::ith(i, if minus { -1.0 } else { 1.0 }));
    let nutating = (0..3usize, any::<bool>()).prop_map(|(i, minus)| {
        let mut v = Vector3::repeat(std::f64::consts::FRAC_1_SQRT_2);
        v[i] = 0.0;
        v[(i + 1) % 3] *= if minus { -1.0 } else { 1.0 };
        v
    });
    prop_oneof![2 => along, 1 => nutating, 2 => free]
}

fn point() -> impl Strategy<Value = Vector3<f64>> {
    [-300.0..300.0f64, -300.0..300.0, -300.0..300.0].prop_map(Vector3::from)
}

/// Angle between two lines, 0 to a right angle.
fn line_angle(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    libm::atan2(a.cross(b).norm(), a.dot(b).abs())
}

fn axis(name: &str, motion: Motion, direction: Vector3<f64>, point_mm: Vector3<f64>) -> Axis {
    Axis {
        name: name.into(),
        motion,
        direction,
        point_mm,
        travel: Travel::UNLIMITED,
        rule: Rule::Pose,
        rapid_per_min: None,
        written: Written::Unwound,
    }
}

/// Axes that stand in the chain, in the order of their words.
fn model(axes: Vec<Axis>, chain: Vec<Joint>, tool: Tool) -> Model {
    Model {
        name: "random".into(),
        title: None,
        parameters: vec![],
        axes,
        chain,
        bed: 0,
        tool,
        errors: Errors::default(),
        zero_mm: Vector3::zeros(),
        axis_tolerance_rad: 1e-6,
        plane_tolerance_mm: 0.001,
        chord_tolerance_mm: 0.01,
        unknown_records: Strictness::Error,
        branch: BranchPolicy { start: vec![], then: vec![], reposition: Strictness::Error },
        dialect: None,
    }
}

prop_compose! {
    /// Linear axes X Y Z W and rotary ones A C B, as many of each, in any order.
    fn machine(linears: usize, rotaries: usize)(
        linear in prop_oneof![
            Just(vec![Vector3::x(), Vector3::y(), Vector3::z(), Vector3::z()]),
            prop::collection::vec(direction(), 4),
        ],
        turning in prop::collection::vec((direction(), point()), rotaries),
        tool in (direction(), point(), 0.0..200.0f64),
        order in Just((0..linears + rotaries).collect::<Vec<_>>()).prop_shuffle(),
        primes in prop::collection::vec(any::<bool>(), linears + rotaries),
    ) -> Model {
        let mut axes: Vec<Axis> = ["X", "Y", "Z", "W"].iter().zip(linear).take(linears)
            .map(|(name, direction)| axis(name, Motion::Linear, direction, Vector3::zeros())).collect();
        axes.extend(["A", "C", "B"].iter().zip(turning).map(|(name, (n, c))| axis(name, Motion::Rotary, n, c)));
        let chain = order.iter().zip(primes).map(|(&axis, primed)| Joint { axis, primed }).collect();
        model(axes, chain, Tool { axis: tool.0, gauge_mm: tool.1, length_mm: tool.2 })
    }
}

/// What a checked model has: linear axes that span space, and solved rotaries that give every freedom they should where
/// the others stand.
fn has_its_freedoms(model: &Model) -> bool {
    let [x, y, z] = [0, 1, 2].map(|i| model.axes[i].direction);
    let mut lines: Vec<_> = family::rotaries(model).iter().map(|rotary| rotary.direction).collect();
    lines.push(family::tool(model));
    x.cross(&y).dot(&z).abs() > 0.3 && lines.windows(2).all(|pair| line_angle(&pair[0], &pair[1]) > 0.3)
}

/// The directions of the rotaries, from the workpiece to the tool.
fn rotaries(model: &Model) -> Vec<Vector3<f64>> {
    let axes = model.chain.iter().map(|joint| &model.axes[joint.axis]);
    axes.filter(|axis| axis.motion == Motion::Rotary).map(|axis| axis.direction).collect()
}

fn run(cases: u32, machines: impl Strategy<Value = Model>, test: impl Fn(Model) -> Result<(), TestCaseError>) {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config.clone(), proptest::test_runner::TestRng::deterministic_rng(config.rng_algorithm))
        .run(&machines, test)
        .unwrap_or_else(|error| panic!("{error}"));
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
    // The last rotary or the last linear axis of the model, or both, are left open or locked; in the chain they stand
    // anywhere.
    for (linears, rotaries) in [(3, 3), (4, 2), (4, 3)] {
        let rule = prop_oneof![Just(Rule::Free), (-90.0..90.0f64).prop_map(Rule::Locked)];
        let machines = (machine(linears, rotaries), rule).prop_map(move |(mut model, rule)| {
            (0..linears + rotaries).filter(|&i| i == 3 && linears == 4 || i == linears + 2).for_each(|surplus| {
                model.axes[surplus].rule = rule;
            });
            model
        });
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
            let chain = [4, 2, 0, 1, 3].map(|axis| Joint { axis, primed: false }).to_vec();
            model(axes, chain, Tool { axis: tool, gauge_mm: points[2], length_mm })
        },
    );
    run(256, machines.prop_filter("every freedom", has_its_freedoms), |model| {
        close_blocks(&model, &derive(&model), BLOCKS).map_err(TestCaseError::fail)
    });
}
