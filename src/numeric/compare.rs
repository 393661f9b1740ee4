//! The solvers side by side along one toolpath.

use super::{Effort, Inverse, Solver};
use crate::diagnostic::Diagnostic;
use crate::plan::{Interpreter, Plan};
use mach_runtime::certificate::Extreme;
use mach_runtime::cl::event::Point;
use mach_runtime::cl::{Next, Reader};
use mach_runtime::compensation::Compensated;
use mach_runtime::kinematics::{JointBlock, Kinematics, LANES, Lane, PoseBlock, SolutionBlock};
use mach_runtime::machine::Machine;
use mach_runtime::path::PathSolver;
use mach_runtime::vector::{Vec3, add, angle_rad, norm, sub};
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
    /// How long the inverse took for all points.
    pub time: Duration,
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
    let mut timed: Vec<Timed<'_>> = inverses.map(|inverse| Timed { inverse, clock, time: Duration::ZERO }).collect();
    let mut runs: Vec<Run<'_>> = timed.iter_mut().map(|timed| Run::new(machine, plan, timed)).collect();
    let mut points = Vec::with_capacity(LANES);
    let mut count = 0;
    loop {
        points.clear();
        let next = reader.next_into(&mut points, LANES)?;
        count += points.len() as u64;
        runs.iter_mut().for_each(|run| run.go(&points));
        match next {
            Next::Full | Next::Command(..) => {}
            Next::From(point) => runs.iter_mut().for_each(|run| run.path.solve(&[point], &mut |_| {})),
            Next::Diagnostic(diagnostic) => tell(diagnostic),
            Next::End => break,
        }
    }
    let found: Vec<Found> = runs.into_iter().map(|run| run.found).collect();
    let measured = solvers.into_iter().zip(found).zip(timed).map(|((solver, found), timed)| {
        let Found { tip_mm, axis_rad, failures } = found;
        Measured { solver, effort: timed.inverse.effort(), tip_mm, axis_rad, failures, time: timed.time }
    });
    Ok(Compared { points: count, solvers: measured.collect() })
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
        self.forward.forward(joints, machine.tool_length_mm, &mut self.poses);
        for (lane, point) in points.iter().enumerate().filter(|(lane, _)| reached[*lane]) {
            let tip = add(point.tip_mm, machine.zero_mm);
            found.tip_mm.meet(norm(sub(self.poses.tip(lane), tip)), point.line);
            found.axis_rad.meet(angle_rad(self.poses.axis(lane), point.axis), point.line);
        }
    }
}

/// An inverse with a stopwatch.
struct Timed<'c> {
    inverse: Inverse,
    clock: &'c (dyn Fn() -> Duration + Sync),
    time: Duration,
}

impl Kinematics for Timed<'_> {
    fn axis_count(&self) -> usize {
        self.inverse.kinematics().axis_count()
    }

    fn branch_count(&self) -> usize {
        self.inverse.kinematics().branch_count()
    }

    fn free_axis(&self) -> Option<usize> {
        self.inverse.kinematics().free_axis()
    }

    fn surplus_axes(&self) -> &[usize] {
        self.inverse.kinematics().surplus_axes()
    }

    fn inverse(&mut self, poses: &PoseBlock, surplus: &[Lane], tool_length_mm: f64, out: &mut SolutionBlock) {
        let start = (self.clock)();
        self.inverse.kinematics_mut().inverse(poses, surplus, tool_length_mm, out);
        self.time += (self.clock)() - start;
    }

    fn position(&mut self, tip_mm: Vec3, tool_length_mm: f64, joints: &mut [f64]) {
        self.inverse.kinematics_mut().position(tip_mm, tool_length_mm, joints);
    }

    fn forward(&mut self, joints: &JointBlock, tool_length_mm: f64, out: &mut PoseBlock) {
        self.inverse.kinematics_mut().forward(joints, tool_length_mm, out);
    }

    fn forward_actual(&mut self, joints: &JointBlock, deviations: &[Lane], tool_length_mm: f64, out: &mut PoseBlock) {
        self.inverse.kinematics_mut().forward_actual(joints, deviations, tool_length_mm, out);
    }
}
