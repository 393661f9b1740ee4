//! Machines at random.

use mach_runtime::machine::{BranchPolicy, Motion, Rule, Strictness, Travel, Written};
use machc::model::class;
use machc::model::errors::Errors;
use machc::model::machine::{Model, ModelAxis, ModelJoint, Tool};
use nalgebra::Vector3;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

/// Along the frame's directions, between two of them, or any.
pub(crate) fn direction() -> impl Strategy<Value = Vector3<f64>> {
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

/// A point, in millimetres.
pub(crate) fn point() -> impl Strategy<Value = Vector3<f64>> {
    [-300.0..300.0f64, -300.0..300.0, -300.0..300.0].prop_map(Vector3::from)
}

/// An axis without limits that the pose decides.
pub(crate) fn axis(name: &str, motion: Motion, direction: Vector3<f64>, point_mm: Vector3<f64>) -> ModelAxis {
    ModelAxis {
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
pub(crate) fn model(axes: Vec<ModelAxis>, chain: Vec<ModelJoint>, tool: Tool) -> Model {
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
    pub(crate) fn machine(linears: usize, rotaries: usize)(
        linear in prop_oneof![
            Just(vec![Vector3::x(), Vector3::y(), Vector3::z(), Vector3::z()]),
            prop::collection::vec(direction(), 4),
        ],
        turning in prop::collection::vec((direction(), point()), rotaries),
        tool in (direction(), point(), 0.0..200.0f64),
        order in Just((0..linears + rotaries).collect::<Vec<_>>()).prop_shuffle(),
        primes in prop::collection::vec(any::<bool>(), linears + rotaries),
    ) -> Model {
        let mut axes: Vec<ModelAxis> = ["X", "Y", "Z", "W"].iter().zip(linear).take(linears)
            .map(|(name, direction)| axis(name, Motion::Linear, direction, Vector3::zeros())).collect();
        axes.extend(["A", "C", "B"].iter().zip(turning).map(|(name, (n, c))| axis(name, Motion::Rotary, n, c)));
        let chain = order.iter().zip(primes).map(|(&axis, primed)| ModelJoint { axis, primed }).collect();
        model(axes, chain, Tool { axis: tool.0, gauge_mm: tool.1, length_mm: tool.2 })
    }
}

/// Angle between two lines, 0 to a right angle.
pub(crate) fn line_angle(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    libm::atan2(a.cross(b).norm(), a.dot(b).abs())
}

/// What a checked model has: linear axes that span space, and solved rotaries that give every freedom they should where
/// the others stand.
pub(crate) fn has_its_freedoms(model: &Model) -> bool {
    let [x, y, z] = [0, 1, 2].map(|i| model.axes[i].direction);
    let mut lines: Vec<_> = class::rotaries(model).iter().map(|rotary| rotary.direction).collect();
    lines.push(class::tool(model));
    x.cross(&y).dot(&z).abs() > 0.3 && lines.windows(2).all(|pair| line_angle(&pair[0], &pair[1]) > 0.3)
}

/// A fourth linear axis and a third rotary one are left open or locked; in the chain they stand anywhere.
pub(crate) fn with_surplus(mut model: Model, rule: Rule) -> Model {
    for axis in model.axes.iter_mut().filter(|axis| matches!(axis.name.as_str(), "W" | "B")) {
        axis.rule = rule;
    }
    model
}

/// Puts so many of them to a test.
pub(crate) fn run<T: std::fmt::Debug>(
    cases: u32,
    machines: impl Strategy<Value = T>,
    test: impl Fn(T) -> Result<(), TestCaseError>,
) {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config.clone(), proptest::test_runner::TestRng::deterministic_rng(config.rng_algorithm))
        .run(&machines, test)
        .unwrap_or_else(|error| panic!("{error}"));
}
