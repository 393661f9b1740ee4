//! `machc solve`.

use mach_command::files::cannot_read;
use mach_command::outcome::{Failure, Status};
use mach_command::output::Lines;
use mach_command::report::{Collected, Report};
use mach_command::toolpath::{Options, quoted};
use mach_runtime::branch::Candidate;
use mach_runtime::kinematics::{LANES, Miss};
use mach_runtime::machine::Machine;
use mach_runtime::path::{NoWay, PathSolver, Solved};
use mach_runtime::road::{Traveller, stage};
use mach_runtime::toolpath::{Approach, Point};
use machc::diagnostic::Diagnostic;
use machc::numeric::Inverse;
use serde::Serialize;

use super::axis_values::AxisValues;
use super::joints;
use super::machine::{Prepared, prepare};
use super::solver::SolverOption;

/// Solve every point of a CL file, as JSON lines
///
/// Each line holds a point, all candidates of the machine for it, and which of them is chosen. With --joints it goes
/// the other way round: each line of FILE holds the values of the axes in machine coordinates ({"X": 1, "A": 90, …}),
/// and each line of the output the tip and the tool axis. Lengths are in mm, angles in degrees, all at full precision.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// FILE holds joint values instead of CL data
    #[arg(long, conflicts_with = "solver")]
    joints: bool,
    /// The machine file
    machine: String,
    /// The CL file, or the joint values; - reads standard input
    file: String,
    #[command(flatten)]
    solver: SolverOption,
    #[command(flatten)]
    options: Options,
}

pub(super) fn run(arguments: Arguments, report: &mut Report) -> Result<Status, Failure> {
    let Some(mut prepared) = prepare(&arguments.machine, report)? else { return Ok(Status::Refused) };
    prepared.machine = arguments.options.equipped(prepared.machine);
    if arguments.joints {
        joints::run(&prepared, &arguments.file, report)
    } else {
        let inverse = arguments.solver.inverse(&prepared)?;
        solve(&prepared, inverse, &arguments.file, &arguments.options, report)
    }
}

fn solve(
    prepared: &Prepared,
    mut inverse: Inverse,
    cl: &str,
    options: &Options,
    report: &Report,
) -> Result<Status, Failure> {
    let machine = &prepared.machine;
    let mut reader = options.reader(cl, machine, report)?;
    let path = PathSolver::new(machine, inverse.kinematics_mut());
    let mut solving = Solving { machine, path, lines: Lines::stdout(), told: Collected::default(), unsolved: 0 };
    let mut points = Vec::with_capacity(LANES);
    while stage(&mut reader, &mut points, &mut solving).map_err(|error| cannot_read(cl, &error))?
        && solving.lines.flush()?
    {}
    let Solving { mut lines, told, unsolved, .. } = solving;
    lines.flush()?;
    let status = report.tell(&quoted(told.into_diagnostics(), cl));
    if unsolved > 0 {
        report.note(&format!("points that cannot be reached, with `chosen` null: {unsolved}"));
        return Ok(Status::Refused);
    }
    Ok(status)
}

/// A machine whose solutions are printed.
struct Solving<'a> {
    machine: &'a Machine,
    path: PathSolver<'a>,
    lines: Lines,
    told: Collected,
    unsolved: u64,
}

impl Traveller for Solving<'_> {
    fn go(&mut self, points: &[Point]) {
        let Self { machine, path, lines, unsolved, .. } = self;
        path.solve(points, &mut |solved| {
            *unsolved += u64::from(solved.chosen().is_none());
            lines.add(&PointMessage::new(machine, solved));
        });
    }

    fn stand_at(&mut self, point: &Point) {
        self.path.stand_at(point);
    }

    fn hear(&mut self, diagnostic: Diagnostic) {
        self.told.add(diagnostic);
    }
}

/// One point, solved.
#[derive(Serialize)]
struct PointMessage<'a> {
    line: u64,
    tip_mm: [f64; 3],
    axis: [f64; 3],
    rapid: bool,
    /// Index into the candidates.
    chosen: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    problem: Option<Problem>,
    candidates: Vec<Solution<'a>>,
}

/// Why nothing is chosen.
#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Problem {
    OutOfReach { deg: f64 },
    InsideDeadRadius { mm: f64, radius_mm: f64 },
    OffPlane { mm: f64 },
    OutOfTravel,
    Singular,
    NotCompensated,
}

impl Problem {
    fn of(no_way: NoWay) -> Self {
        match no_way {
            NoWay::OutOfTravel(_) => Self::OutOfTravel,
            NoWay::Missed(Miss::OutOfReach { by_rad }) => Self::OutOfReach { deg: by_rad.to_degrees() },
            NoWay::Missed(Miss::InsideDeadRadius { gap_mm: mm, radius_mm }) => Self::InsideDeadRadius { mm, radius_mm },
            NoWay::Missed(Miss::OffPlane { by_mm: mm }) => Self::OffPlane { mm },
            NoWay::Missed(Miss::Singular) => Self::Singular,
            NoWay::Missed(Miss::NotCompensated) => Self::NotCompensated,
        }
    }
}

#[derive(Serialize)]
struct Solution<'a> {
    joints: AxisValues<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    beyond_travel: Option<Beyond<'a>>,
}

#[derive(Serialize)]
struct Beyond<'a> {
    axis: &'a str,
    by: f64,
}

impl<'a> PointMessage<'a> {
    fn new(machine: &'a Machine, solved: &'a Solved<'_>) -> Self {
        let &Point { line, tip_mm, axis, approach } = solved.point;
        let way = solved.way();
        let (chosen, problem) = (way.ok(), way.err().map(Problem::of));
        let candidates = solved.candidates.iter().map(|candidate| Solution::new(machine, candidate)).collect();
        Self { line, tip_mm, axis, rapid: approach == Approach::Rapid, chosen, problem, candidates }
    }
}

impl<'a> Solution<'a> {
    fn new(machine: &'a Machine, candidate: &'a Candidate) -> Self {
        let beyond = |obstacle: mach_runtime::branch::Obstacle| Beyond {
            axis: &machine.axes[obstacle.axis].name,
            by: obstacle.beyond,
        };
        let joints = AxisValues { axes: &machine.axes, values: &candidate.joints, known: u64::MAX };
        Self { joints, beyond_travel: candidate.obstacle.map(beyond) }
    }
}
