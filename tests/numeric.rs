//! The iterated inverses against the closed form: the same solutions along random paths, next to the pole and beyond the
//! reach, and the same programs byte for byte.

#[path = "common/machine.rs"]
mod machine;
#[path = "common/program.rs"]
mod program;
#[path = "common/stems.rs"]
mod stems;

use mach_runtime::kinematics::{
    JointBlock, Kinematics, LANES, Lane, Miss, Outcome, PoseBlock, SolutionBlock, Tolerances,
};
use mach_runtime::machine::{Component, ErrorTable};
use mach_runtime::vector::{Vec3, angle_rad, norm, sub};
use machc::compile::Compiled;
use machc::derive::derive;
use machc::numeric::{Inverse, Method, Numeric, Solver};
use machc::plan::Interpreter;
use program::{posted, posted_by};
use std::f64::consts::FRAC_PI_2;
use stems::stems;

const METHODS: [Method; 2] = [Method::Newton, Method::Broyden];

/// What the closed form is proved to.
const TIP_BOUND_MM: f64 = 1e-9;
const AXIS_BOUND_RAD: f64 = 1e-12;

const TOLERANCES: Tolerances = Tolerances { axis_rad: 0.0, plane_mm: TIP_BOUND_MM };

fn compiled(name: &str) -> Compiled {
    machine::compiled(&format!("machines/{name}.mach"), &machine::Files)
}

/// Every candidate for the block, and how far they are from it by the closed form's forward chain.
struct Solved {
    block: SolutionBlock,
    tip_mm: f64,
    axis_rad: f64,
}

/// The surplus joints are those of `joints`.
fn solved(compiled: &Compiled, kinematics: &mut dyn Kinematics, wanted: &PoseBlock, joints: &JointBlock) -> Solved {
    let tool = compiled.model.tool.geometry();
    let mut block = SolutionBlock::of(kinematics);
    let surplus: Vec<Lane> = kinematics.surplus_axes().iter().map(|&axis| joints[axis]).collect();
    kinematics.inverse(wanted, &surplus, tool, &mut block);
    let (mut reached, mut tip_mm, mut axis_rad) = (PoseBlock::ZERO, 0.0_f64, 0.0_f64);
    for candidate in &block.branches {
        Interpreter::new(&compiled.plan).forward(candidate, tool, &mut reached);
        for lane in (0..LANES).filter(|&lane| !is_far(candidate, lane)) {
            tip_mm = tip_mm.max(norm(sub(reached.tip(lane), wanted.tip(lane))));
            axis_rad = axis_rad.max(angle_rad(reached.axis(lane), wanted.axis(lane)));
        }
    }
    Solved { block, tip_mm, axis_rad }
}

/// How far the wanted direction is out of reach.
fn beyond_rad(block: &SolutionBlock, lane: usize) -> f64 {
    match block.outcome(lane, TOLERANCES) {
        Outcome::Missed(Miss::OutOfReach { by_rad }) => by_rad,
        _ => 0.0,
    }
}

/// Every axis at zero.
fn at_home(compiled: &Compiled) -> JointBlock {
    vec![[0.0; LANES]; compiled.model.axes.len()]
}

/// Whether a rotary between the linear axes stands next to where they no longer span space: joints grow without bound
/// there, and their rounding with them.
fn is_far(candidate: &[[f64; LANES]], lane: usize) -> bool {
    candidate.iter().any(|joint| joint[lane].abs() > 1e4)
}

/// Joints on their way: steps of up to half a turn and half a metre, and lanes that hardly move.
fn joints(compiled: &Compiled, block: usize) -> JointBlock {
    let spread = |axis: usize, lane: usize| {
        let step = [0.754_877_666, 0.569_840_29, 0.618_033_988, 0.414_213_562, 0.732_050_807, 0.236_067_977][axis];
        let n = (block * LANES + lane + 1) as f64;
        let far = 2.0 * (n * step).fract() - 1.0;
        let near = 0.4 + 0.001 * (n * (axis + 1) as f64).fract();
        if lane.is_multiple_of(16) { far } else { near + 0.01 * (lane % 16) as f64 }
    };
    let bound = |rotary: bool| if rotary { 180.0 } else { 500.0 };
    let axes = compiled.plan.rotary.iter().enumerate();
    axes.map(|(axis, &rotary)| std::array::from_fn(|lane| bound(rotary) * spread(axis, lane))).collect()
}

/// Whether two candidates have the same rotary joints up to whole turns. Next to the edge of the reach the angles are
/// known to the square root of a rounding only.
fn is_same(rotary: &[bool], a: &[[f64; LANES]], b: &[[f64; LANES]], lane: usize) -> bool {
    let turn = |d: f64| (d - 360.0 * (d / 360.0).round()).abs();
    (0..rotary.len()).filter(|&axis| rotary[axis]).all(|axis| turn(a[axis][lane] - b[axis][lane]) < 1e-4)
}

#[test]
fn the_solutions_are_those_of_the_closed_form() {
    for name in stems("machines", "mach") {
        let compiled = compiled(&name);
        let mut closed = Interpreter::new(&compiled.plan);
        for method in METHODS {
            let mut numeric = Numeric::new(&compiled.plan, method);
            for block in 0..4 {
                let (joints, mut wanted) = (joints(&compiled, block), PoseBlock::ZERO);
                closed.forward(&joints, compiled.model.tool.geometry(), &mut wanted);
                let expected = solved(&compiled, &mut closed, &wanted, &joints);
                let found = solved(&compiled, &mut numeric, &wanted, &joints);
                assert!(found.tip_mm <= TIP_BOUND_MM, "{name} {method:?}: {:e} mm", found.tip_mm);
                assert!(found.axis_rad <= AXIS_BOUND_RAD, "{name} {method:?}: {:e} rad", found.axis_rad);
                // At the pole a rotary is free, and so is one that a surplus axis lays the tool along, where the branches
                // meet: there are more solutions than these.
                let has_two = |lane: &usize| {
                    let branches = &expected.block.branches;
                    let is_near = !branches.iter().any(|candidate| is_far(candidate, *lane));
                    let meet = |pair: &[JointBlock]| is_same(&compiled.plan.rotary, &pair[0], &pair[1], *lane);
                    is_near
                        && expected.block.outcome(*lane, TOLERANCES) == Outcome::Reached
                        && !branches.windows(2).any(meet)
                };
                for lane in (0..LANES).filter(has_two) {
                    assert_eq!(beyond_rad(&found.block, lane), 0.0, "{name} {method:?}");
                    for candidate in &expected.block.branches {
                        let mut all = found.block.branches.iter();
                        let is_found = all.any(|other| is_same(&compiled.plan.rotary, candidate, other, lane));

                        assert!(is_found, "{name} {method:?}: a solution is missed in lane {lane} of block {block}");
                    }
                }
            }
        }
    }
}

/// Axes at these tilts from the direction, all around it.
fn around(direction: Vec3, tilts_rad: &[f64]) -> PoseBlock {
    let aside = if direction[2].abs() > 0.5 { [1.0, 0.0, 0.0] } else { [0.0, 0.0, 1.0] };
    let first = unit(mach_runtime::vector::cross(direction, aside));
    let second = mach_runtime::vector::cross(direction, first);
    let mut poses = PoseBlock::ZERO;
    for lane in 0..LANES {
        let tilt = tilts_rad[lane % tilts_rad.len()];
        let (sine, cosine) = libm::sincos(lane as f64);
        let axis = std::array::from_fn(|i| {
            libm::cos(tilt) * direction[i] + libm::sin(tilt) * (cosine * first[i] + sine * second[i])
        });
        poses.set(lane, [10.0, -20.0 + lane as f64, 30.0], unit(axis));
    }
    poses
}

fn unit(v: Vec3) -> Vec3 {
    v.map(|component| component / norm(v))
}

#[test]
fn next_to_the_pole_and_at_it_the_bounds_hold() {
    for name in ["tmv710a", "dmu50ev", "endura900", "dmu80_monoblock"] {
        let compiled = compiled(name);
        let wanted = around([0.0, 0.0, 1.0], &[0.1, 1e-3, 0.0, 1e-5, 1e-7, 1e-9, 1e-11, 0.3]);
        for method in METHODS {
            let found = solved(&compiled, &mut Numeric::new(&compiled.plan, method), &wanted, &at_home(&compiled));
            assert!(found.tip_mm <= TIP_BOUND_MM, "{name} {method:?}: {:e} mm", found.tip_mm);
            assert!(found.axis_rad <= AXIS_BOUND_RAD, "{name} {method:?}: {:e} rad", found.axis_rad);
            assert!((0..LANES).all(|lane| beyond_rad(&found.block, lane) == 0.0), "{name} {method:?}");
        }
    }
}

#[test]
fn beyond_the_reach_the_angle_to_it_is_told() {
    // The nutating table reaches what is within 90 degrees of the vertical.
    let tilts_rad = [1e-6, 1e-3, 0.1, 0.5];
    let wanted = around([0.0, 0.0, 1.0], &tilts_rad.map(|beyond| FRAC_PI_2 + beyond));
    let compiled = compiled("dmu50ev");
    for method in METHODS {
        let found = solved(&compiled, &mut Numeric::new(&compiled.plan, method), &wanted, &at_home(&compiled));
        assert!(found.tip_mm <= TIP_BOUND_MM, "{method:?}: the tip is held all the same, not to {:e} mm", found.tip_mm);
        for lane in 0..LANES {
            let (told, beyond) = (beyond_rad(&found.block, lane), tilts_rad[lane % tilts_rad.len()]);
            assert!((told - beyond).abs() < 0.01 * beyond, "{method:?}: {told} is not {beyond}");
        }
    }
}

#[test]
fn a_machine_without_rotaries_says_how_far_the_axis_is_off() {
    let compiled = compiled("vmc3");
    let wanted = around([0.0, 0.0, 1.0], &[0.0, 1e-9, 0.2, 2.0]);
    for method in METHODS {
        let found = solved(&compiled, &mut Numeric::new(&compiled.plan, method), &wanted, &at_home(&compiled));
        assert!(found.tip_mm <= TIP_BOUND_MM);
        for lane in 0..LANES {
            let told = beyond_rad(&found.block, lane);
            assert!((told - [0.0, 1e-9, 0.2, 2.0][lane % 4]).abs() < 1e-12, "{method:?}: {told}");
        }
    }
}

#[test]
fn where_the_linear_axes_do_not_span_space_that_is_told_and_it_goes_on_behind() {
    // With the ram horizontal, Y and Z go along one line.
    let compiled = compiled("tilting_ram");
    let mut wanted = PoseBlock::ZERO;
    for lane in 0..LANES {
        let axis = if lane % 2 == 0 { [0.0, 0.0, 1.0] } else { [0.0, 1.0, 0.0] };
        wanted.set(lane, [10.0, 20.0, 30.0 + lane as f64], axis);
    }
    for method in METHODS {
        let found = solved(&compiled, &mut Numeric::new(&compiled.plan, method), &wanted, &at_home(&compiled)).block;
        for candidate in &found.branches {
            for lane in 0..LANES {
                // Next to there the axis may be given up for a tip that far joints hold; that is told.
                let is_missed = matches!(found.outcome(lane, TOLERANCES), Outcome::Missed(_));
                let is_held = !is_missed && !is_far(candidate, lane);
                assert_eq!(is_held, lane % 2 == 0, "{method:?}: lane {lane}");
                let rotaries = (0..5).filter(|&axis| compiled.plan.rotary[axis]);
                assert!(rotaries.map(|axis| candidate[axis][lane]).all(f64::is_finite), "{method:?}: lane {lane}");
            }
        }
    }
}

#[test]
fn programs_are_the_same_byte_for_byte() {
    // The other two turn by exactly half a turn at once: which way is for the last digit to decide.
    let programs = stems("examples", "cls").into_iter().filter(|name| name != "pole_crossed" && name != "feed_screw");
    let programs: Vec<String> = programs.map(|name| format!("examples/{name}.cls")).collect();
    for name in stems("machines", "mach") {
        let compiled = compiled(&name);
        for cl in &programs {
            let expected = posted(&compiled, cl);
            for method in METHODS {
                let found = posted_by(&Numeric::new(&compiled.plan, method), &compiled, cl);
                let codes = |posted: &mach_runtime::rig::Posted| -> Vec<&str> {
                    posted.diagnostics.iter().map(|diagnostic| diagnostic.code.id).collect()
                };
                assert_eq!(codes(&found), codes(&expected), "{name} {cl} {method:?}");
                assert_eq!(found.certificate.is_some(), expected.certificate.is_some(), "{name} {cl} {method:?}");
                assert!(found.nc == expected.nc, "{name} {cl} {method:?}: another program");
            }
        }
    }
}

#[test]
fn errors_of_the_axes_are_compensated_around_either_inverse() {
    let mut compiled = compiled("tmv710a");
    let table = |axis, component, rows: [(f64, f64); 2]| ErrorTable { axis, component, rows: rows.to_vec() };
    let (x, a) = (
        table(0, Component::Y, [(-300.0, -0.02), (300.0, 0.02)]),
        table(3, Component::C, [(-30.0, 0.0), (120.0, 2e-5)]),
    );
    compiled.model.errors.tables.extend([x, a]);
    compiled.plan = derive(&compiled.model);
    let expected = posted(&compiled, "examples/sine_surface.cls");
    assert!(expected.certificate.is_some());
    for method in METHODS {
        let found = posted_by(&Numeric::new(&compiled.plan, method), &compiled, "examples/sine_surface.cls");
        assert!(found.certificate.is_some() && found.nc == expected.nc, "{method:?}");
    }
}

#[test]
fn a_machine_without_a_closed_form_is_iterated_for() {
    let mut compiled = compiled("dmu80_monoblock");
    let expected = posted(&compiled, "examples/hemisphere.cls");
    compiled.plan.branches.clear();
    assert!(Solver::ClosedForm.inverse(&compiled.plan).is_none());
    let solver = Solver::of_plan(&compiled.plan).next().expect("a plan can be iterated on");
    assert_eq!(solver, Solver::Numeric(Method::Newton));
    let Some(Inverse::Numeric(inverse)) = solver.inverse(&compiled.plan) else { panic!("it iterates") };
    let found = posted_by(&*inverse, &compiled, "examples/hemisphere.cls");
    assert!(found.certificate.is_some() && found.nc == expected.nc);
}
