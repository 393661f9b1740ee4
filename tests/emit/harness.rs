//! Runs generated solvers: `harness solve NAME` answers blocks of numbers on standard input, `harness tables NAME` prints the
//! tables.

mod machines;

use mach_runtime::kinematics::{JointBlock, Kinematics, LANES, Lane, PoseBlock, SolutionBlock};
use mach_runtime::machine::ToolGeometry;
use std::io::{Read, Write, stdin, stdout};

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    match arguments[1].as_str() {
        "tables" => print!("{}", machines::tables(&arguments[2])),
        _ => solve(&mut *machines::solver(&arguments[2])),
    }
}

fn solve(solver: &mut dyn Kinematics) {
    let mut input = Vec::new();
    stdin().read_to_end(&mut input).expect("readable");
    let mut numbers = input.chunks_exact(8).map(|bytes| f64::from_le_bytes(bytes.try_into().expect("eight bytes")));
    let mut out = Vec::new();
    while let Some(length_mm) = numbers.next() {
        let mut lane = || -> Lane { std::array::from_fn(|_| numbers.next().expect("a whole block")) };
        let poses = PoseBlock { tip_mm: [lane(), lane(), lane()], axis: [lane(), lane(), lane()] };
        let joints: JointBlock = (0..solver.axis_count()).map(|_| lane()).collect();
        answer(solver, ToolGeometry::of_length(length_mm), &poses, &joints, &mut out);
    }
    let bytes: Vec<u8> = out.into_iter().flat_map(f64::to_le_bytes).collect();
    stdout().write_all(&bytes).expect("writable");
}

include!("answer.rs");
