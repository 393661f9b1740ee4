//! The derivation closes the loop: for machines of every order of three linear and two rotary axes, with random directions
//! and offsets, the inverse's candidates reach the pose that the forward chain was asked for.

use mach_runtime::kinematics::{LANES, PoseBlock};
use mach_runtime::machine::{BranchPolicy, Motion, Strictness, Travel, Written};
use machc::derive::derive;
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
        rapid_per_min: None,
        written: Written::Unwound,
    }
}

prop_compose! {
    fn machine(rotaries: usize)(
        linear in prop_oneof![Just([Vector3::x(), Vector3::y(), Vector3::z()]), [direction(), direction(), direction()]],
        turning in prop::collection::vec((direction(), point()), rotaries),
        tool in (direction(), point(), 0.0..200.0f64),
        order in Just((0..3 + rotaries).collect::<Vec<_>>()).prop_shuffle(),
        primes in prop::collection::vec(any::<bool>(), 3 + rotaries),
    ) -> Model {
        let mut axes: Vec<Axis> = ["X", "Y", "Z"].iter().zip(linear)
            .map(|(name, direction)| axis(name, Motion::Linear, direction, Vector3::zeros())).collect();
        axes.extend(["A", "C"].iter().zip(turning).map(|(name, (n, c))| axis(name, Motion::Rotary, n, c)));
        Model {
            name: "random".into(),
            title: None,
            parameters: vec![],
            axes,
            chain: order.iter().zip(primes).map(|(&axis, primed)| Joint { axis, primed }).collect(),
            bed: 0,
            tool: Tool { axis: tool.0, gauge_mm: tool.1, length_mm: tool.2 },
            errors: Errors::default(),
            zero_mm: Vector3::zeros(),
            axis_tolerance_rad: 1e-6,
            chord_tolerance_mm: 0.01,
            unknown_records: Strictness::Error,
            branch: BranchPolicy { start: vec![], then: vec![], reposition: Strictness::Error },
            dialect: None,
        }
    }
}

/// What a checked model has: linear axes that span space, and rotaries that give every freedom they should.
fn has_its_freedoms(model: &Model) -> bool {
    let [x, y, z] = [0, 1, 2].map(|i| model.axes[i].direction);
    let rotaries: Vec<_> = model.chain.iter().filter(|j| j.axis >= 3).map(|j| model.axes[j.axis].direction).collect();
    let mut lines = rotaries.clone();
    lines.push(model.tool.axis);
    x.cross(&y).dot(&z).abs() > 0.3 && lines.windows(2).all(|pair| line_angle(&pair[0], &pair[1]) > 0.3)
}

fn run(cases: u32, rotaries: usize, test: impl Fn(Model) -> Result<(), TestCaseError>) {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    let machines = machine(rotaries).prop_filter("every freedom", has_its_freedoms);
    TestRunner::new_with_rng(config.clone(), proptest::test_runner::TestRng::deterministic_rng(config.rng_algorithm))
        .run(&machines, test)
        .unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn random_machines_close_the_loop_and_miss_no_branch() {
    for rotaries in 0..=2 {
        run(256, rotaries, |model| close_blocks(&model, &derive(&model), BLOCKS).map_err(TestCaseError::fail));
    }
}

#[test]
fn a_nanoradian_from_the_pole_keeps_every_digit() {
    run(256, 2, |mut model| {
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
