//! Symbolic derivatives against central differences: random expressions, the forward chains of all shipped machines, and
//! the choices at ties that the documentation promises.

use mach_runtime::machine::ToolGeometry;
use machc::plan::{Graph, Id, Jacobian, Program};
use proptest::prelude::*;

#[path = "common/machine.rs"]
mod machine;
#[path = "common/stems.rs"]
mod stems;

const INPUTS: usize = 3;

/// A step of a stack machine that builds an expression.
#[derive(Debug, Clone, Copy)]
enum Build {
    Input(usize),
    Constant(f64),
    Unary(u8),
    Binary(u8),
    Select,
}

fn builds() -> impl Strategy<Value = Vec<Build>> {
    let build = prop_oneof![
        3 => (0..INPUTS).prop_map(Build::Input),
        1 => (-2.0..2.0).prop_map(Build::Constant),
        2 => (0..5u8).prop_map(Build::Unary),
        4 => (0..7u8).prop_map(Build::Binary),
        1 => Just(Build::Select),
    ];
    prop::collection::vec(build, 4..40)
}

fn expression(graph: &mut Graph, builds: &[Build]) -> Id {
    let mut stack: Vec<Id> = (0..INPUTS).map(|index| graph.input(index)).collect();
    for build in builds {
        let last = *stack.last().expect("inputs stay");
        let before = stack[stack.len().saturating_sub(2)];
        let next = match build {
            Build::Input(index) => graph.input(*index),
            Build::Constant(value) => graph.constant(*value),
            Build::Unary(kind) => unary(graph, *kind, last),
            Build::Binary(kind) => binary(graph, *kind, before, last),
            Build::Select => graph.select(stack[0], before, last),
        };
        stack.push(next);
    }
    *stack.last().expect("inputs stay")
}

fn unary(graph: &mut Graph, kind: u8, a: Id) -> Id {
    match kind {
        0 => graph.neg(a),
        1 => {
            let a = varying(graph, a);
            graph.sqrt(a)
        }
        2 => graph.sin(a),
        3 => graph.cos(a),
        _ => graph.mul(a, a),
    }
}

fn binary(graph: &mut Graph, kind: u8, a: Id, b: Id) -> Id {
    match kind {
        0 => graph.add(a, b),
        1 => graph.sub(a, b),
        2 => graph.mul(a, b),
        3 => {
            let b = varying(graph, b);
            graph.div(a, b)
        }
        4 => graph.atan2(a, b),
        5 => graph.min(a, b),
        _ => graph.max(a, b),
    }
}

/// What has folded to a number makes way for an input: numbers must stay finite.
fn varying(graph: &mut Graph, a: Id) -> Id {
    if graph.as_constant(a).is_some() { graph.input(0) } else { a }
}

fn value(program: &mut Program<1>, point: [f64; INPUTS]) -> f64 {
    for (index, value) in point.into_iter().enumerate() {
        program.input(index)[0] = value;
    }
    program.run();
    program.output(0)[0]
}

/// The central difference with this step.
fn difference(program: &mut Program<1>, point: [f64; INPUTS], input: usize, step: f64) -> f64 {
    let mut at = |step: f64| {
        let mut moved = point;
        moved[input] += step;
        value(program, moved)
    };
    (at(step) - at(-step)) / (2.0 * step)
}

/// The derivative and its central difference, where the two differences say that there is a derivative to be had.
fn both(builds: &[Build], point: [f64; INPUTS], input: usize) -> Option<(f64, f64)> {
    let mut graph = Graph::default();
    let root = expression(&mut graph, builds);
    let by = graph.input(input);
    let derivative = graph.derivatives(&[root], by)[0];
    let mut function = Program::<1>::new(&graph, INPUTS, &[root]);
    let symbolic = value(&mut Program::new(&graph, INPUTS, &[derivative]), point);
    let (coarse, fine) = (difference(&mut function, point, input, 1e-4), difference(&mut function, point, input, 1e-5));
    let scale = 1.0 + fine.abs() + value(&mut function, point).abs();
    let is_smooth = (coarse - fine).abs() < 1e-7 * scale && scale < 1e3;
    // √0 and the angle of (0, 0) have no derivative, though both are constant where their operands stay zero.
    let is_known = !(symbolic.is_nan() && fine == 0.0);
    (is_smooth && is_known).then_some((symbolic / scale, fine / scale))
}

#[test]
fn random_expressions_have_the_derivatives_of_their_differences() {
    let config = ProptestConfig { cases: 4096, failure_persistence: None, ..ProptestConfig::default() };
    let rng = proptest::test_runner::TestRng::deterministic_rng(config.rng_algorithm);
    let mut runner = proptest::test_runner::TestRunner::new_with_rng(config, rng);
    let compared = std::cell::Cell::new(0);
    let inputs = (builds(), [0.1..2.0f64, -2.0..2.0, -2.0..2.0], 0..INPUTS);
    runner
        .run(&inputs, |(builds, point, input)| {
            if let Some((symbolic, difference)) = both(&builds, point, input) {
                compared.set(compared.get() + 1);
                prop_assert!((symbolic - difference).abs() < 1e-6, "{symbolic} is not {difference}");
            }
            Ok(())
        })
        .unwrap_or_else(|error| panic!("{error}"));
    assert!(compared.get() > 2000, "only {} of the expressions were smooth", compared.get());
}

#[test]
fn at_a_tie_the_derivative_is_that_of_the_operand_taken() {
    let mut graph = Graph::default();
    let (a, b) = (graph.input(0), graph.input(1));
    let two = graph.constant(2.0);
    let double = graph.mul(two, a);
    let outputs = [graph.min(double, b), graph.max(double, b), graph.select(b, double, a)];
    let derivatives = graph.derivatives(&outputs, a);
    let mut values = Program::<1>::new(&graph, 2, &outputs);
    let mut slopes = Program::<1>::new(&graph, 2, &derivatives);
    let mut at = |a: f64, b: f64| {
        for program in [&mut values, &mut slopes] {
            (program.input(0)[0], program.input(1)[0]) = (a, b);
            program.run();
        }
        [0, 1, 2].map(|output| (values.output(output)[0], slopes.output(output)[0]))
    };
    assert_eq!(at(1.0, 3.0), [(2.0, 2.0), (3.0, 0.0), (2.0, 2.0)]);
    assert_eq!(at(2.0, 3.0), [(3.0, 0.0), (4.0, 2.0), (4.0, 2.0)]);
    // Neither is less nor greater: both take their second operand, the older node `b`.
    let [least, greatest, selected] = at(0.0, 0.0);
    assert_eq!((least.1, greatest.1, selected), (2.0, 2.0, (0.0, 1.0)));
}

#[test]
fn the_forward_chain_of_every_machine_has_the_jacobian_of_its_differences() {
    const STEP: f64 = 1e-5;
    const TOOL: ToolGeometry = ToolGeometry::of_length(80.0);
    for name in stems::stems("machines", "mach") {
        let compiled = machine::compiled(&format!("machines/{name}.mach"), &machine::Files);
        let axes = compiled.plan.rotary.len();
        let mut chain = Jacobian::new(&compiled.plan);
        for sample in 0..16 {
            let at = |axis: usize| f64::from((sample * 37 + axis as i32 * 101) % 61 - 30);
            let joints: Vec<f64> =
                (0..axes).map(|axis| at(axis) / if compiled.plan.rotary[axis] { 10.0 } else { 0.1 }).collect();
            let mut columns = vec![[0.0; 6]; axes];
            let pose = chain.derivatives(&joints, TOOL, &mut columns);
            assert_eq!(pose, chain.pose(&joints, TOOL), "{name}");
            for (axis, column) in columns.iter().enumerate() {
                let mut moved = |by: f64| {
                    let mut joints = joints.clone();
                    joints[axis] += by;
                    chain.pose(&joints, TOOL)
                };
                let (above, below) = (moved(STEP), moved(-STEP));
                for i in 0..6 {
                    let difference = (above[i] - below[i]) / (2.0 * STEP);
                    assert!((column[i] - difference).abs() < 1e-5, "{name}: {} is not {difference}", column[i]);
                }
            }
        }
    }
}
