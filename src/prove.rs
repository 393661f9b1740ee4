//! The proof that comes with every machine: seeded random poses through inverse and forward.

use crate::model::class;
use crate::model::machine::{Model, ModelAxis};
use crate::plan::{Interpreter, Plan};
use mach_runtime::diagnostic::{Code, Diagnostic};
use mach_runtime::kinematics::{JointBlock, Kinematics, LANES, Lane, PoseBlock, SolutionBlock};
use mach_runtime::machine::{Motion, Rule};
use mach_runtime::tool::ToolGeometry;
use mach_runtime::vector::{angle_rad, norm, sub};

/// E0601.
pub static NOT_PROVED: Code = Code {
    id: "E0601",
    title: "the derived kinematics did not pass their proof",
    explanation: "\
Every machine is tried when it is compiled: seeded random poses go through the forward chain, the inverse, and the forward
chain again. For this machine they did not come back to where they started, so no post is made.

This is a defect of machc, not of the machine file. Please report it with the file. Offsets of many kilometres, which no
machine has, can bring it about too: check the units of the lengths.",
};

/// How far the loop may be from closed: tip in millimetres for a machine of metres, axis in radians.
pub const TIP_BOUND_MM: f64 = 1e-9;
/// See [`TIP_BOUND_MM`].
pub const AXIS_BOUND_RAD: f64 = 1e-12;

/// How many poses are tried.
pub const POSES: usize = 2048;

/// How the loop closed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Proof {
    /// The poses that were tried, each with every candidate.
    pub poses: usize,
    /// The largest distance of a tip from where it should be.
    pub tip_mm: f64,
    /// The largest angle of a tool axis from where it should be.
    pub axis_rad: f64,
}

impl Proof {
    /// Whether the derivation is what it should be.
    pub fn holds(&self, model: &Model) -> bool {
        self.tip_mm <= TIP_BOUND_MM && self.axis_rad <= AXIS_BOUND_RAD + wobble_rad(model)
    }
}

/// Where the position decides the only rotary, nothing is left to tilt the tool: if the two are not quite along each other,
/// the tool of one solution leans as much to one side as that of the other to the other side.
fn wobble_rad(model: &Model) -> f64 {
    let lean = |rotary: class::Rotary| {
        let (n, t) = (rotary.direction, class::tool(model));
        libm::atan2(n.cross(&t).norm(), n.dot(&t).abs())
    };
    2.0 * class::polar(model).map_or(0.0, lean)
}

/// Takes joints at random (but for the locked ones), their pose, and every candidate for it back to a pose.
pub fn prove(model: &Model, plan: &Plan) -> Proof {
    let mut machine = Interpreter::new(plan);
    let mut random = SplitMix(0x6d61_6368);
    let mut proof = Proof { poses: 0, tip_mm: 0.0, axis_rad: 0.0 };
    while proof.poses < POSES {
        let joint = |axis: &ModelAxis| match (axis.rule, axis.motion) {
            (Rule::Locked(value), _) => [value; LANES],
            (_, Motion::Rotary) => random.lane(180.0),
            (_, Motion::Linear) => random.lane(500.0),
        };
        let joints: JointBlock = model.axes.iter().map(joint).collect();
        close(&mut machine, &joints, model.tool.geometry(), &mut proof);
    }
    proof
}

/// The proof's failure, if it failed.
pub fn check(model: &Model, proof: &Proof) -> Option<Diagnostic> {
    let message = || {
        let (tip, axis) = (proof.tip_mm, proof.axis_rad);
        format!("the kinematics of `{}` close only to {tip:.1e} mm and {axis:.1e} rad", model.name)
    };
    let error = || {
        let error = Diagnostic::error(&NOT_PROVED, message());
        error.note("is an offset kilometres long? if none is, this is a defect of machc: please report it")
    };
    (!proof.holds(model)).then(error)
}

/// Forward, inverse, and forward again.
fn close(machine: &mut Interpreter, joints: &JointBlock, tool: ToolGeometry, proof: &mut Proof) {
    let (mut wanted, mut reached) = (PoseBlock::ZERO, PoseBlock::ZERO);
    machine.forward(joints, tool, &mut wanted);
    let surplus: Vec<Lane> = machine.surplus_axes().iter().map(|&axis| joints[axis]).collect();
    let mut solutions = SolutionBlock::of(machine);
    machine.inverse(&wanted, &surplus, tool, &mut solutions);
    for candidate in &solutions.branches {
        machine.forward(candidate, tool, &mut reached);
        for lane in 0..LANES {
            let (tip, axis) =
                (norm(sub(reached.tip(lane), wanted.tip(lane))), angle_rad(reached.axis(lane), wanted.axis(lane)));
            if candidate.iter().all(|joint| joint[lane].abs() < FAR) {
                proof.tip_mm = proof.tip_mm.max(tip);
                proof.axis_rad = proof.axis_rad.max(axis);
            }
        }
    }
    proof.poses += LANES;
}

/// Next to a positional singularity (a rotary between linear axes) joints grow without bound, and their rounding with
/// them: no machine goes there.
const FAR: f64 = 1e5;

/// Steele, Lea and Flood's generator: the same numbers on every machine.
struct SplitMix(u64);

impl SplitMix {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Numbers from -bound to bound.
    fn lane(&mut self, bound: f64) -> [f64; LANES] {
        std::array::from_fn(|_| {
            let unit = (self.next() >> 11) as f64 / (1u64 << 53) as f64;
            bound * (2.0 * unit - 1.0)
        })
    }
}
