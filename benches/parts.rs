//! Parts of a post, each by itself: `cargo bench --bench parts`.

#[path = "parts/by_hand.rs"]
mod by_hand;
// What `machc emit rust` writes; a test keeps the files as they are written now.
#[allow(dead_code)]
#[rustfmt::skip]
#[path = "../tests/emit/golden/dmu50ev.rs"]
mod dmu50ev;
#[path = "throughput/sine_cl.rs"]
mod sine_cl;
#[allow(dead_code)]
#[rustfmt::skip]
#[path = "../tests/emit/golden/tmv710a.rs"]
mod tmv710a;

use divan::Bencher;
use divan::counter::ItemsCount;
use mach_runtime::cl::{Next, Reader};
use mach_runtime::kinematics::{Kinematics, LANES, PoseBlock, Rate, SolutionBlock, rates};
use mach_runtime::machine::ToolGeometry;
use mach_runtime::rig::reader_options;
use mach_runtime::segment::Segments;
use machc::compile::{Compiled, compile};
use machc::model::tables;
use machc::plan::Interpreter;
use machc::sources::Sources;

const MACHINES: [&str; 4] = ["tmv710a", "dmu50ev", "dmu80_monoblock", "endura900"];
const TOOL: ToolGeometry = ToolGeometry::of_length(150.0);
const RECORDS: usize = 10_000;

fn main() {
    divan::main();
}

/// The project's files.
struct Files;

impl Sources for Files {
    fn read(&self, path: &str) -> Result<String, String> {
        std::fs::read_to_string(path).map_err(|error| error.to_string())
    }
}

fn machine(name: &str) -> Compiled {
    let path = format!("{}/machines/{name}.mach", env!("CARGO_MANIFEST_DIR"));
    compile(&path, &Files).expect("a shipped machine compiles")
}

/// Poses that every machine here can reach: tilted by up to 40 degrees.
fn poses() -> PoseBlock {
    let mut poses = PoseBlock::ZERO;
    for lane in 0..LANES {
        let (tilt, turn) = (0.01 * (lane + 1) as f64, 0.4 * lane as f64);
        let (sine, cosine) = libm::sincos(tilt);
        let axis = [sine * libm::cos(turn), sine * libm::sin(turn), cosine];
        poses.set(lane, [lane as f64, -2.0 * lane as f64, 10.0], axis);
    }
    poses
}

#[divan::bench(args = MACHINES)]
fn compile_and_prove(bencher: Bencher<'_, '_>, name: &str) {
    bencher.bench(|| machine(name));
}

#[divan::bench(args = MACHINES)]
fn inverse_all_branches(bencher: Bencher<'_, '_>, name: &str) {
    let mut interpreter = Interpreter::new(&machine(name).plan);
    let mut solutions = SolutionBlock::of(&interpreter);
    let poses = poses();
    bencher.counter(ItemsCount::new(LANES)).bench_local(|| interpreter.inverse(&poses, &[], TOOL, &mut solutions));
}

/// The machines that have a generated solver and one written by hand.
const SOLVED_BY_HAND: [&str; 2] = ["tmv710a", "dmu50ev"];

#[divan::bench(args = SOLVED_BY_HAND)]
fn inverse_generated(bencher: Bencher<'_, '_>, name: &str) {
    let mut solver: Box<dyn Kinematics> = match name {
        "tmv710a" => Box::new(tmv710a::Solver),
        _ => Box::new(dmu50ev::Solver),
    };
    let mut solutions = SolutionBlock::of(&*solver);
    let poses = poses();
    bencher.counter(ItemsCount::new(LANES)).bench_local(|| solver.inverse(&poses, &[], TOOL, &mut solutions));
}

#[divan::bench(args = SOLVED_BY_HAND)]
fn inverse_by_hand(bencher: Bencher<'_, '_>, name: &str) {
    let solve = if name == "tmv710a" { by_hand::trunnion } else { by_hand::nutating };
    let mut interpreter = Interpreter::new(&machine(name).plan);
    let (mut solutions, mut expected) = (SolutionBlock::of(&interpreter), SolutionBlock::of(&interpreter));
    let poses = poses();
    interpreter.inverse(&poses, &[], TOOL, &mut expected);
    solve(&poses, TOOL.length_mm, &mut solutions);
    assert_close(&solutions, &expected);
    bencher.counter(ItemsCount::new(LANES)).bench_local(|| solve(&poses, TOOL.length_mm, &mut solutions));
}

/// Whoever is faster must not be so by being wrong.
fn assert_close(found: &SolutionBlock, expected: &SolutionBlock) {
    let numbers = |block: &SolutionBlock| block.branches.iter().flatten().flatten().copied().collect::<Vec<f64>>();
    for (found, expected) in numbers(found).into_iter().zip(numbers(expected)) {
        assert!((found - expected).abs() < 1e-9, "{found} is not {expected}");
    }
}

#[divan::bench(args = MACHINES)]
fn forward(bencher: Bencher<'_, '_>, name: &str) {
    let mut interpreter = Interpreter::new(&machine(name).plan);
    let joints = vec![std::array::from_fn(|lane| lane as f64); interpreter.axis_count()];
    let mut poses = PoseBlock::ZERO;
    bencher.counter(ItemsCount::new(LANES)).bench_local(|| interpreter.forward(&joints, TOOL, &mut poses));
}

#[divan::bench(args = MACHINES)]
fn rates_of_axes(bencher: Bencher<'_, '_>, name: &str) {
    let chain = tables::machine(&machine(name).model).chain;
    let joints = vec![std::array::from_fn(|lane| lane as f64); chain.joints.len()];
    let mut found = vec![Rate::ZERO; chain.joints.len()];
    bencher.counter(ItemsCount::new(LANES)).bench_local(|| rates(&chain, &joints, TOOL, &mut found));
}

#[divan::bench(args = MACHINES)]
fn between_points(bencher: Bencher<'_, '_>, name: &str) {
    let machine = tables::machine(&machine(name).model);
    let mut segments = Segments::new(&machine.chain, machine.tool());
    let joints: Vec<f64> = (0..LANES * machine.axes.len()).map(|n| n as f64 / 10.0).collect();
    let tips_mm = [[100.0; LANES]; 3];
    bencher.counter(ItemsCount::new(LANES)).bench_local(|| {
        segments.go_to(&joints, &tips_mm);
        segments.quick_bound_mm(0)
    });
}

#[divan::bench]
fn read_cl(bencher: Bencher<'_, '_>) {
    let text = sine_cl::records(RECORDS);
    let tables = machine_tables();
    bencher.counter(ItemsCount::new(RECORDS)).bench_local(|| {
        let mut reader = Reader::new("sine.cls", text.as_bytes(), reader_options(&tables));
        let mut points = Vec::new();
        while reader.next_into(&mut points, LANES).expect("memory can be read") != Next::End {
            points.clear();
        }
    });
}

#[divan::bench]
fn post_with_certificate(bencher: Bencher<'_, '_>) {
    let text = sine_cl::records(RECORDS);
    let compiled = machine("tmv710a");
    let rig = compiled.rig().expect("the machine has a controller");
    bencher.counter(ItemsCount::new(RECORDS)).bench_local(|| rig.post_text("sine.cls", text.as_bytes()));
}

fn machine_tables() -> mach_runtime::machine::Machine {
    tables::machine(&machine("tmv710a").model)
}
