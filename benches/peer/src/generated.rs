//! Solvers as `machc emit rust` writes them: two solutions of every pose.

// A test of the project keeps the files as they are written now.
#[allow(dead_code)]
#[rustfmt::skip]
#[path = "../../../tests/emit/golden/dmu50ev.rs"]
pub(crate) mod dmu50ev;
#[allow(dead_code)]
#[rustfmt::skip]
#[path = "../../../tests/emit/golden/tmv710a.rs"]
pub(crate) mod tmv710a;

use crate::GAUGE_LENGTH_MM;
use crate::poses::Pose;
use mach_runtime::kinematics::{Kinematics, LANES, PoseBlock, SolutionBlock};
use mach_runtime::machine::ToolGeometry;
use std::hint::black_box;

const TOOL: ToolGeometry = ToolGeometry::of_length(GAUGE_LENGTH_MM);

/// How far a checked solution may be from its pose: what the peer allows itself, a millionth of the machine's size (here
/// of a metre) and of a radian.
const TOLERANCE_MM: f64 = 1e-3;
const TOLERANCE_RAD: f64 = 1e-6;

/// A machine and what it has to solve.
pub(crate) struct Machine<K> {
    solver: K,
    blocks: Vec<PoseBlock>,
    solutions: SolutionBlock,
    back: PoseBlock,
}

impl<K: Kinematics> Machine<K> {
    pub(crate) fn new(solver: K, poses: &[Pose]) -> Self {
        let (whole, rest) = poses.as_chunks::<LANES>();
        assert!(rest.is_empty(), "poses come in blocks of {LANES}");
        let solutions = SolutionBlock::of(&solver);
        Self { solver, blocks: whole.iter().map(block).collect(), solutions, back: PoseBlock::ZERO }
    }

    /// Solves every pose; how many solutions there are.
    pub(crate) fn solve(&mut self) -> usize {
        for block in &self.blocks {
            self.solver.inverse(block, &[], TOOL, &mut self.solutions);
            black_box(&self.solutions);
        }
        self.blocks.len() * LANES * self.solutions.branches.len()
    }

    /// Solves every pose and puts every solution through the forward chain; how many of them lead back.
    pub(crate) fn solve_and_check(&mut self) -> usize {
        let mut right = 0;
        for block in &self.blocks {
            self.solver.inverse(block, &[], TOOL, &mut self.solutions);
            for joints in &self.solutions.branches {
                self.solver.forward(joints, TOOL, &mut self.back);
                right += (0..LANES).filter(|&lane| same(block, &self.back, lane)).count();
            }
        }
        right
    }
}

fn block(poses: &[Pose; LANES]) -> PoseBlock {
    let mut block = PoseBlock::ZERO;
    for (lane, pose) in poses.iter().enumerate() {
        block.set(lane, pose.tip_mm, pose.axis);
    }
    block
}

fn same(wanted: &PoseBlock, found: &PoseBlock, lane: usize) -> bool {
    distance(wanted.tip(lane), found.tip(lane)) <= TOLERANCE_MM
        && distance(wanted.axis(lane), found.axis(lane)) <= TOLERANCE_RAD
}

fn distance([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]) -> f64 {
    let (x, y, z) = (ax - bx, ay - by, az - bz);
    (x * x + y * y + z * z).sqrt()
}
