//! Measured errors: the forward chain against one of its own, and the compensation of machines at random.

use mach_runtime::compensation::Compensated;
use mach_runtime::kinematics::{JointBlock, Kinematics, LANES, Miss, Outcome, PoseBlock, SolutionBlock, Tolerances};
use mach_runtime::machine::{Component, ErrorTable, Motion, ToolGeometry};
use mach_runtime::vector::{angle_rad, cross, norm, sub};
use machc::compile::Compiled;
use machc::derive::derive;
use machc::model::errors::{Errors, LocationError};
use machc::model::machine::{Model, ModelJoint};
use machc::model::tables;
use machc::plan::Interpreter;
use machc::sources::Sources;
use nalgebra::{Isometry3, Point3, Rotation3, Translation3, UnitQuaternion, UnitVector3, Vector3};
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::{Config, TestRng, TestRunner};

#[path = "errors/independent.rs"]
mod independent;
#[path = "common/machine.rs"]
mod machine;
#[path = "common/program.rs"]
mod program;

use independent::pose;

const TIP_BOUND_MM: f64 = 1e-9;
const AXIS_BOUND_RAD: f64 = 1e-12;
/// What machines are off by.
const ERROR_MM: f64 = 0.01;
const ERROR_RAD: f64 = 20e-6;

/// One of every class: tables, heads, both, a rotary between linear axes, nutating ones, an angle head, four and three axes.
const MACHINES: [&str; 9] = [
    "tmv710a",
    "dmu50ev",
    "dmu70_evline",
    "dmu80p_duoblock",
    "dmu80_monoblock",
    "fs10000",
    "vstar_angle_head",
    "vmc4",
    "vmc3",
];

fn model(name: &str) -> Model {
    machine::compiled(&format!("machines/{name}.mach"), &machine::Files).model
}

/// A value for each location error and each table of one axis.
#[derive(Debug, Clone)]
struct Measured {
    locations: [f64; 6],
    tables: [Vec<f64>; 6],
}

fn measured() -> impl Strategy<Value = Measured> {
    let unit = || -1.0..1.0f64;
    // Half of the tables were not measured.
    let table = || prop_oneof![Just(vec![]), prop::collection::vec(unit(), 2..8)];
    let tables = [table(), table(), table(), table(), table(), table()];
    (prop::array::uniform6(unit()), tables).prop_map(|(locations, tables)| Measured { locations, tables })
}

/// A machine of some class with other senses and another place of the bed, and everything measured.
fn measured_machine() -> impl Strategy<Value = Model> {
    let models: Vec<Model> = MACHINES.iter().map(|name| model(name)).collect();
    (select(models), prop::collection::vec((any::<bool>(), measured()), 5), 0..=5usize).prop_map(
        |(mut model, axes, bed)| {
            model.bed = bed.min(model.chain.len());
            for (joint, (primed, measured)) in model.chain.iter_mut().zip(axes) {
                *joint = ModelJoint { primed, ..*joint };
                let axis = joint.axis;
                for (component, value) in Component::ALL.into_iter().zip(measured.locations) {
                    let value = value * size(component);
                    model.errors.locations.push(LocationError { axis, component, value });
                }
                let span = if model.axes[axis].motion == Motion::Rotary { (0.0, 360.0) } else { (-400.0, 400.0) };
                for (component, values) in Component::ALL.into_iter().zip(measured.tables) {
                    let rows = rows(span, values, component, model.axes[axis].motion);
                    if !rows.is_empty() {
                        model.errors.tables.push(ErrorTable { axis, component, rows });
                    }
                }
            }
            model
        },
    )
}

/// Evenly spread; a table of a whole turn closes.
fn rows((from, to): (f64, f64), mut values: Vec<f64>, component: Component, motion: Motion) -> Vec<(f64, f64)> {
    if let (Motion::Rotary, [first, .., last]) = (motion, &mut values[..]) {
        *last = *first;
    }
    let step = (to - from) / (values.len().max(2) - 1) as f64;
    values.iter().enumerate().map(|(i, value)| (from + step * i as f64, value * size(component))).collect()
}

fn size(component: Component) -> f64 {
    if component.is_turn() { ERROR_RAD } else { ERROR_MM }
}

/// Joints spread over a block, within the travel of a machine of middling size.
fn joints(model: &Model, block: usize) -> JointBlock {
    let spread = |axis: usize, lane: usize| {
        let step = [0.754_877_666, 0.569_840_290, 0.618_033_988, 0.414_213_562, 0.732_050_807][axis];
        2.0 * ((block * LANES + lane + 1) as f64 * step).fract() - 1.0
    };
    let bound = |axis: usize| if model.axes[axis].motion == Motion::Rotary { 180.0 } else { 350.0 };
    (0..model.axes.len()).map(|axis| std::array::from_fn(|lane| bound(axis) * spread(axis, lane))).collect()
}

fn run(cases: u32, test: impl Fn(Model) -> Result<(), TestCaseError>) {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    let random = TestRng::deterministic_rng(config.rng_algorithm);
    TestRunner::new_with_rng(config, random).run(&measured_machine(), test).unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn the_forward_chain_with_errors_is_that_of_an_independent_model() {
    run(64, |model| {
        let (tables, plan) = (tables::machine(&model), derive(&model));
        let mut kinematics = Compensated::new(Interpreter::new(&plan), &tables);
        let (joints, mut poses) = (joints(&model, 0), PoseBlock::ZERO);
        kinematics.forward(&joints, model.tool.geometry(), &mut poses);
        for lane in 0..LANES {
            let values: Vec<f64> = joints.iter().map(|joint| joint[lane]).collect();
            let (tip, axis) = pose(&model, &tables.axes, &values);
            prop_assert!(norm(sub(poses.tip(lane), tip)) < TIP_BOUND_MM, "{:?} {tip:?}", poses.tip(lane));
            prop_assert!(angle_rad(poses.axis(lane), axis) < AXIS_BOUND_RAD, "{:?} {axis:?}", poses.axis(lane));
        }
        Ok(())
    });
}

/// Where a rotary between linear axes leaves them no room, joints grow without bound; no machine goes there.
fn far(candidate: &JointBlock, lane: usize) -> bool {
    candidate.iter().any(|joint| joint[lane].abs() > 1e4)
}

#[test]
fn four_corrections_put_the_tip_where_it_should_be() {
    run(128, |model| {
        let (tables, plan) = (tables::machine(&model), derive(&model));
        let mut kinematics = Compensated::new(Interpreter::new(&plan), &tables);
        let (mut wanted, mut reached) = (PoseBlock::ZERO, PoseBlock::ZERO);
        let mut solutions = SolutionBlock::of(&kinematics);
        for block in 0..4 {
            kinematics.forward(&joints(&model, block), model.tool.geometry(), &mut wanted);
            kinematics.inverse(&wanted, &[], model.tool.geometry(), &mut solutions);
            for candidate in &solutions.branches {
                kinematics.forward(candidate, model.tool.geometry(), &mut reached);
                for lane in (0..LANES).filter(|&lane| !far(candidate, lane)) {
                    let tip = norm(sub(reached.tip(lane), wanted.tip(lane)));
                    prop_assert!(tip <= TIP_BOUND_MM, "{}: tip {tip:e} mm", model.name);
                    // What the rotaries leave alone is no more than all turns together.
                    let axis = angle_rad(reached.axis(lane), wanted.axis(lane));
                    prop_assert!(axis <= 30.0 * ERROR_RAD, "{}: axis {axis:e} rad", model.name);
                }
            }
        }
        prop_assert!(kinematics.most_corrections() <= 4, "{}: {}", model.name, kinematics.most_corrections());
        Ok(())
    });
}

#[test]
fn the_tool_axis_is_compensated_away_from_the_pole() {
    run(32, |measured| {
        // A trunnion reaches every direction, so that there is no edge of the reach to be next to.
        let model = Model { errors: measured.errors, ..model("tmv710a") };
        prop_assume!(measured.axes.len() == model.axes.len() && of_the_same_kinds(&measured.axes, &model.axes));
        let (tables, plan) = (tables::machine(&model), derive(&model));
        let mut kinematics = Compensated::new(Interpreter::new(&plan), &tables);
        let (mut wanted, mut reached) = (PoseBlock::ZERO, PoseBlock::ZERO);
        let mut solutions = SolutionBlock::of(&kinematics);
        kinematics.forward(&joints(&model, 0), model.tool.geometry(), &mut wanted);
        kinematics.inverse(&wanted, &[], model.tool.geometry(), &mut solutions);
        for candidate in &solutions.branches {
            kinematics.forward(candidate, model.tool.geometry(), &mut reached);
            for lane in (0..LANES).filter(|&lane| norm(cross(wanted.axis(lane), [0.0, 0.0, 1.0])) > 0.1) {
                let axis = angle_rad(reached.axis(lane), wanted.axis(lane));
                prop_assert!(axis <= AXIS_BOUND_RAD, "axis {axis:e} rad at {:?}", wanted.axis(lane));
            }
        }
        Ok(())
    });
}

fn of_the_same_kinds(a: &[machc::model::machine::ModelAxis], b: &[machc::model::machine::ModelAxis]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.motion == b.motion)
}

/// A machine `like` the trunnion, with these statements.
struct Measurement<'a>(&'a str);

impl Sources for Measurement<'_> {
    fn read(&self, path: &str) -> Result<String, String> {
        match path {
            "machines/measured.mach" => {
                Ok(format!("use \"tmv710a.mach\"\nmachine measured like tmv710a {{\n{}\n}}\n", self.0))
            }
            path => machine::Files.read(path),
        }
    }
}

fn measured_trunnion(statements: &str) -> Compiled {
    machine::compiled("machines/measured.mach", &Measurement(statements))
}

const LOCATIONS: &str = "error EX0C 10 um  error EYOC -10 um  error EA0C 20 urad  error EB(0X)C -20 urad
    error EC(0X)Y 20 urad  error EA0Z -20 urad  error EB0Z 20 urad
    error EY0A -10 um  error EZ0A 10 um  error EB0A 20 urad  error EC0A -20 urad";

#[test]
fn location_errors_are_solved_in_closed_form() {
    let Compiled { model, plan, proof, .. } = measured_trunnion(LOCATIONS);
    assert!(proof.holds(&model) && model.errors.tables.is_empty() && model.errors.locations.len() == 11);
    let (tables, mut kinematics) = (tables::machine(&model), Interpreter::new(&plan));
    let (joints, mut poses) = (joints(&model, 3), PoseBlock::ZERO);
    kinematics.forward(&joints, ToolGeometry::of_length(0.0), &mut poses);
    for lane in 0..LANES {
        let values: Vec<f64> = joints.iter().map(|joint| joint[lane]).collect();
        let (tip, axis) = pose(&model, &tables.axes, &values);
        assert!(norm(sub(poses.tip(lane), tip)) < TIP_BOUND_MM && angle_rad(poses.axis(lane), axis) < AXIS_BOUND_RAD);
    }
}

#[test]
fn the_signs_are_those_of_the_right_hand_rule() {
    let model = measured_trunnion(LOCATIONS).model;
    let line = |name: &str| model.line(model.axes.iter().position(|axis| axis.name == name).expect("an axis"));
    let near = |a: Vector3<f64>, b: [f64; 3]| (a - Vector3::from(b)).norm() < 1e-9;
    // Turned about +x, +z goes towards -y; about +y, towards +x. Turned about +z, +y goes towards -x.
    assert!(near(line("C").direction, [-20e-6, -20e-6, 1.0]), "{:?}", line("C"));
    assert!(near(line("C").point_mm, [0.01, -0.01, -20.0]), "{:?}", line("C"));
    assert!(near(line("Y").direction, [-20e-6, 1.0, 0.0]), "{:?}", line("Y"));
    assert!(near(line("A").direction, [1.0, -20e-6, -20e-6]), "{:?}", line("A"));
    // What the control adds knows of no errors.
    let shares: Vec<f64> = tables::machine(&model).axes.iter().map(|axis| axis.length_share).collect();
    assert_eq!(shares, [0.0, 0.0, 1.0, 0.0, 0.0]);
}

const TABLES: &str = "
    error EXX { at -355 mm: 8 um  at 0: 0  at 355 mm: -10 um }
    error EYX { at -355 mm: -3 um  at 355 mm: 10 um }
    error ECY { at -310: -20 urad  at 200: 5 urad }
    error EAZ { at -450: 20 urad  at 60: 0 }
    error EBA { at -30: -10 urad  at 120: 20 urad }
    error EAC { at 0: 20 urad  at 90: -5 urad  at 180: -20 urad  at 360: 20 urad }
    error EZC { at 0: 10 um  at 200: -10 um  at 360: 10 um }";

#[test]
fn a_later_measurement_replaces_an_earlier_one_however_it_is_spelt() {
    struct Later;
    impl Sources for Later {
        fn read(&self, path: &str) -> Result<String, String> {
            let later = "use \"tmv710a_measured.mach\" machine later like tmv710a_measured {
                error EXOC 1 um  error EXX { at 0: 2 um } }";
            if path == "machines/later.mach" { Ok(later.to_owned()) } else { machine::Files.read(path) }
        }
    }
    let [later, before] = ["later", "tmv710a_measured"]
        .map(|name| machine::compiled(&format!("machines/{name}.mach"), &Later).model.errors);
    assert_eq!((later.locations.len(), later.tables.len()), (before.locations.len(), before.tables.len()));
    let value = |errors: &Errors| errors.locations.iter().find(|error| error.axis == 4).map(|error| error.value);
    assert_eq!([value(&before), value(&later)], [Some(0.006), Some(0.001)]);
    assert_eq!(later.tables[0].rows, [(0.0, 0.002)]);
}

#[test]
fn a_program_is_posted_for_where_the_tool_really_is() {
    let with_errors = measured_trunnion(&format!("{LOCATIONS}\n{TABLES}"));
    for cl in ["hemisphere", "sine_surface", "face_mill"] {
        let cl = format!("examples/{cl}.cls");
        let (posted, usual) = (program::posted(&with_errors, &cl), program::posted(&measured_trunnion(""), &cl));
        assert_ne!(posted.nc, usual.nc, "{cl}");
        let [posted, usual] = [posted, usual].map(|posted| posted.certificate.expect("no errors"));
        // What the printed digits leave, with or without errors.
        assert!(
            posted.worst.tip_mm.value < usual.worst.tip_mm.value + 5e-4,
            "{cl}: {} {}",
            posted.worst.tip_mm.value,
            usual.worst.tip_mm.value
        );
        // Next to the pole the tables' turns of the tool are left alone.
        assert!(
            posted.worst.axis_rad.value < usual.worst.axis_rad.value + 10.0 * ERROR_RAD,
            "{cl}: {}",
            posted.worst.axis_rad.value
        );
    }
}

#[test]
fn the_rotaries_stand_still_at_the_pole() {
    let with_errors = measured_trunnion(TABLES);
    let posted = program::posted(&with_errors, "examples/face_mill.cls").certificate.expect("no errors");
    assert_eq!(posted.rotary_step_deg.value, 0.0);
    assert!(posted.worst.axis_rad.value < 5.0 * ERROR_RAD, "{}", posted.worst.axis_rad.value);
}

#[test]
fn a_table_that_never_settles_is_refused() {
    // Any step to the right is undone by the error, which comes back with the step to the left.
    let steep = measured_trunnion("error EXX { at -1 um: -4 mm  at 1 um: 4 mm }");
    let posted = program::posted(&steep, "examples/hemisphere.cls");
    assert!(posted.certificate.is_none());
    let codes: Vec<&str> = posted.diagnostics.iter().map(|diagnostic| diagnostic.code.id).collect();
    assert!(codes.contains(&"E1120"), "{codes:?}");
}

#[test]
fn errors_do_not_hide_that_the_linear_axes_span_no_space() {
    struct Ram;
    impl Sources for Ram {
        fn read(&self, path: &str) -> Result<String, String> {
            let measured = "use \"tilting_ram.mach\"
                machine ram like tilting_ram { error EYX { at -1 mm: 0 at 1 mm: 5 um } }";
            if path == "machines/ram.mach" { Ok(measured.to_owned()) } else { machine::Files.read(path) }
        }
    }
    let Compiled { model, plan, .. } = machine::compiled("machines/ram.mach", &Ram);
    let tables = tables::machine(&model);
    let mut kinematics = Compensated::new(Interpreter::new(&plan), &tables);
    let (mut wanted, mut solutions) = (PoseBlock::ZERO, SolutionBlock::of(&kinematics));
    // With the ram horizontal, Y and Z go along one line.
    (0..LANES).for_each(|lane| wanted.set(lane, [10.0, 20.0, 30.0], [[0.0, 1.0, 0.0], [0.0, 0.6, 0.8]][lane % 2]));
    kinematics.inverse(&wanted, &[], ToolGeometry::of_length(100.0), &mut solutions);
    let tolerances = Tolerances { axis_rad: 1e-9, plane_mm: 0.0 };
    for (lane, outcome) in solutions.outcomes(tolerances).into_iter().enumerate() {
        assert_eq!(outcome, [Outcome::Missed(Miss::Singular), Outcome::Reached][lane % 2], "lane {lane}");
        assert_eq!(outcome, solutions.outcome(lane, tolerances));
    }
}
