//! What a machine is asked for: poses it reaches, poses at its poles, and directions out of its reach.

use mach_runtime::kinematics::{JointBlock, Kinematics, LANES, PoseBlock};
use mach_runtime::machine::{Motion, ToolGeometry};
use machc::compile::Compiled;
use machc::model::class;
use machc::plan::Interpreter;

/// One block of questions.
pub(crate) struct Block {
    pub(crate) tool: ToolGeometry,
    pub(crate) poses: PoseBlock,
    pub(crate) joints: JointBlock,
}

const LENGTHS_MM: [f64; 3] = [0.0, 75.25, 312.5];

/// Numbers from -1 to 1, spread evenly.
fn spread(place: usize, count: usize) -> f64 {
    let step = [0.754_877_666, 0.569_840_290, 0.618_033_988, 0.414_213_562, 0.732_050_807, 0.236_067_977][place % 6];
    2.0 * ((count + 1) as f64 * step).fract() - 1.0
}

/// Joints all over the machine, and poses of both kinds.
pub(crate) fn blocks(compiled: &Compiled) -> Vec<Block> {
    let mut blocks = Vec::new();
    for (number, tool) in LENGTHS_MM.map(ToolGeometry::of_length).into_iter().enumerate() {
        let joint = |axis: usize, motion: Motion| {
            let bound = if motion == Motion::Rotary { 180.0 } else { 500.0 };
            std::array::from_fn(|lane| bound * spread(axis, number * LANES + lane))
        };
        let joints: JointBlock =
            compiled.model.axes.iter().enumerate().map(|(place, axis)| joint(place, axis.motion)).collect();
        let mut reached = PoseBlock::ZERO;
        Interpreter::new(&compiled.plan).forward(&joints, tool, &mut reached);
        blocks.push(Block { tool, poses: reached, joints: joints.clone() });
        blocks.push(Block { tool, poses: anywhere(compiled, number), joints });
    }
    blocks
}

/// Directions all over the sphere, the machine's axes among them exactly, next to them, and both ways.
fn anywhere(compiled: &Compiled, number: usize) -> PoseBlock {
    let mut exact: Vec<[f64; 3]> = class::poles(&compiled.model).into_iter().map(Into::into).collect();
    let axes = compiled.model.axes.iter().map(|axis| axis.direction);
    exact.extend(axes.flat_map(|axis| [axis, -axis]).map(<[f64; 3]>::from));
    exact.extend([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [1e-9, 0.0, 1.0], [0.0, -1e-14, 1.0], [0.0, 0.0, 0.0]]);
    let mut poses = PoseBlock::ZERO;
    for lane in 0..LANES {
        let count = number * LANES + lane;
        let tip = [0, 1, 2].map(|place| 400.0 * spread(place, count));
        let direction = exact.get(lane).copied().unwrap_or_else(|| unit([3, 4, 5].map(|place| spread(place, count))));
        poses.set(lane, tip, direction);
    }
    poses
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}
