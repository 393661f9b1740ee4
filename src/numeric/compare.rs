//! The solvers side by side along one toolpath.

use super::{Effort, Inverse, Solver};
use crate::diagnostic::Diagnostic;
use crate::plan::{Interpreter, Plan};
use mach_runtime::certificate::Extreme;
use mach_runtime::cl::Reader;
use mach_runtime::compensation::Compensated;
use mach_runtime::coordinates::in_machine_frame;
use mach_runtime::kinematics::{JointBlock, Kinematics, LANES, Lane, Miss, Pole, PoseBlock, SolutionBlock};
use mach_runtime::machine::Machine;
use mach_runtime::path::PathSolver;
use mach_runtime::road::{Traveller, travel};
use mach_runtime::tool::ToolGeometry;
use mach_runtime::toolpath::Point;
use mach_runtime::vector::{Vec3, angle_rad, norm, sub};
use std::io::{self, Read};
use std::time::Duration;

/// What one solver did.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// Which one.
    pub solver: Solver,
    /// What it took; nothing for the closed form, which does not iterate.
    pub effort: Option<Effort>,
    /// The largest distance of a tip from the wanted one, by the forward chain, in millimetres.
    pub tip_mm: Extreme,
    /// The largest angle of a tool axis from the wanted one, by the forward chain, in radians.
    pub axis_rad: Extreme,
    /// Points at which nothing could be chosen.
    pub failures: u64,
    /// How long the inverse took for a pose, in nanoseconds. The first of several blocks, which finds nothing in the
    /// processor's caches, does not count.
    pub pose_ns: f64,
}

/// The solvers that the machine has, the closed form first.
#[derive(Debug, Clone, PartialEq)]
pub struct Compared {
    /// Points of the toolpath.
    pub points: u64,
    /// One for each solver.
    pub solvers: Vec<Measured>,
}

/// Takes every solver along the toolpath. The `clock` says how long it is since some moment. Diagnostics of the CL go to
/// `tell` as they come.
///
/// # Errors
/// When the CL cannot be read.
pub fn compare<R: Read>(
    machine: &Machine,
    plan: &Plan,
    mut reader: Reader<R>,
    clock: &(dyn Fn() -> Duration + Sync),
    tell: &mut dyn FnMut(Diagnostic),
) -> io::Result<Compared> {
    let solvers: Vec<Solver> = Solver::of_plan(plan).collect();
    let inverses = solvers.iter().map(|solver| solver.inverse(plan).expect("the plan has these solvers"));
    let mut timed: Vec<Timed<'_>> = inverses.map(|inverse| Timed::new(inverse, clock)).collect();
    let runs = timed.iter_mut().map(|timed| Run::new(machine, plan, timed)).collect();
    let mut race = Race { runs, points: 0, tell };
    travel(&mut reader, &mut race)?;
    let (points, found) = (race.points, race.runs.into_iter().map(|run| run.found).collect::<Vec<_>>());
    let measured = solvers.into_iter().zip(found).zip(timed).map(|((solver, found), timed)| {
        let Found { tip_mm, axis_rad, failures } = found;
        Measured { solver, effort: timed.inverse.effort(), tip_mm, axis_rad, failures, pose_ns: timed.pose_ns() }
    });
    Ok(Compared { points, solvers: measured.collect() })
}

/// All of them on their way.
struct Race<'a> {
    runs: Vec<Run<'a>>,
    points: u64,
    tell: &'a mut dyn FnMut(Diagnostic),
}

impl Traveller for Race<'_> {
    fn go(&mut self, points: &[Point]) {
        self.points += points.len() as u64;
        self.runs.iter_mut().for_each(|run| run.go(points));
    }

    fn stand_at(&mut self, point: &Point) {
        self.runs.iter_mut().for_each(|run| run.path.stand_at(point));
    }

    fn hear(&mut self, diagnostic: Diagnostic) {
        (self.tell)(diagnostic);
    }
}

/// A solver on its way along the path.
struct Run<'a> {
    machine: &'a Machine,
    path: PathSolver<'a>,
    /// A second chain, for where the joints take the tool.
    forward: Compensated<'a, Interpreter>,
    joints: JointBlock,
    poses: PoseBlock,
    found: Found,
}

/// How well it did.
#[derive(Default)]
struct Found {
    tip_mm: Extreme,
    axis_rad: Extreme,
    failures: u64,
}

impl<'a> Run<'a> {
    fn new(machine: &'a Machine, plan: &Plan, timed: &'a mut Timed<'_>) -> Self {
        Self {
            machine,
            path: PathSolver::new(machine, timed),
            forward: Compensated::new(Interpreter::new(plan), machine),
            joints: vec![[0.0; LANES]; machine.axes.len()],
            poses: PoseBlock::ZERO,
            found: Found::default(),
        }
    }

    /// Solves a block of points, and measures what was chosen.
    fn go(&mut self, points: &[Point]) {
        let Self { machine, path, joints, found, .. } = self;
        let mut reached = [false; LANES];
        path.solve(points, &mut |solved| match solved.chosen() {
            Some(chosen) => {
                reached[solved.lane] = true;
                joints.iter_mut().zip(&chosen.joints).for_each(|(joint, value)| joint[solved.lane] = *value);
            }
            None => found.failures += 1,
        });
        self.forward.forward(joints, machine.tool(), &mut self.poses);
        for (lane, point) in points.iter().enumerate().filter(|(lane, _)| reached[*lane]) {
            let tip = in_machine_frame(machine, point.tip_mm);
            found.tip_mm.meet(norm(sub(self.poses.tip(lane), tip)), point.line);
            found.axis_rad.meet(angle_rad(self.poses.axis(lane), point.axis), point.line);
        }
    }
}

/// An inverse with a stopwatch.
struct Timed<'c> {
    inverse: Inverse,
    clock: &'c (dyn Fn() -> Duration + Sync),
    blocks: u32,
    time: Duration,
}

impl<'c> Timed<'c> {
    fn new(inverse: Inverse, clock: &'c (dyn Fn() -> Duration + Sync)) -> Self {
        Self { inverse, clock, blocks: 0, time: Duration::ZERO }
    }

    fn pose_ns(&self) -> f64 {
        let poses = f64::from(self.blocks.saturating_sub(1).max(1)) * LANES as f64;
        self.time.as_nanos() as f64 / poses
    }
}

impl Kinematics for Timed<'_> {
    fn axis_count(&self) -> usize {
        self.inverse.kinematics().axis_count()
    }

    fn branch_count(&self) -> usize {
        self.inverse.kinematics().branch_count()
    }

    fn pole(&self) -> Option<Pole> {
        self.inverse.kinematics().pole()
    }

    fn surplus_axes(&self) -> &[usize] {
        self.inverse.kinematics().surplus_axes()
    }

    fn inverse(&mut self, poses: &PoseBlock, surplus: &[Lane], tool: ToolGeometry, out: &mut SolutionBlock) {
        let start = (self.clock)();
        self.inverse.kinematics_mut().inverse(poses, surplus, tool, out);
        let taken = (self.clock)() - start;
        self.time = if self.blocks < 2 { taken } else { self.time + taken };
        self.blocks += 1;
    }

    fn position(&mut self, tip_mm: Vec3, tool: ToolGeometry, joints: &mut [f64]) -> Result<(), Miss> {
        self.inverse.kinematics_mut().position(tip_mm, tool, joints)
    }

    fn forward(&mut self, joints: &JointBlock, tool: ToolGeometry, out: &mut PoseBlock) {
        self.inverse.kinematics_mut().forward(joints, tool, out);
    }

    fn forward_actual(&mut self, joints: &JointBlock, deviations: &[Lane], tool: ToolGeometry, out: &mut PoseBlock) {
        self.inverse.kinematics_mut().forward_actual(joints, deviations, tool, out);
    }
}
