//! `machc compare-solvers`.

use std::time::Instant;

use mach_command::files::cannot_read;
use mach_command::outcome::{Failure, Status};
use mach_command::output::{Lines, print};
use mach_command::report::{Collected, Report};
use mach_command::toolpath::{Options, quoted};
use mach_runtime::certificate::Extreme;
use machc::numeric::{Compared, Effort, Measured, compare};
use serde_json::{Value, json};

use super::machine::prepare;
use super::solver::name;

/// Compare the solvers along a CL file: closed form, Newton, Broyden
///
/// Each takes the machine along the toolpath, starting every point from the one before. Told are the iterations of the
/// numeric ones, for all solutions of a point together, how exact the chosen joints are by the forward chain, points
/// without a solution, and the time of the inverse. Times differ from run to run and computer to computer: ratios count.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The machine file
    machine: String,
    /// The CL file; - reads standard input
    cl: String,
    #[command(flatten)]
    options: Options,
}

pub(super) fn run(arguments: Arguments, report: &Report) -> Result<Status, Failure> {
    let Arguments { machine, cl, options } = arguments;
    let Some(prepared) = prepare(&machine, report)? else { return Ok(Status::Refused) };
    let machine = options.equipped(prepared.machine);
    let reader = options.reader(&cl, &machine, report)?;
    let mut told = Collected::default();
    let start = Instant::now();
    let clock = || start.elapsed();
    let compared = compare(&machine, &prepared.plan, reader, &clock, &mut |diagnostic| told.add(diagnostic));
    let compared = compared.map_err(|error| cannot_read(&cl, &error))?;
    let status = report.tell(&quoted(told.into_diagnostics(), &cl));
    if report.is_json() {
        let mut lines = Lines::stdout();
        compared.solvers.iter().for_each(|solver| lines.add(&line(&machine.name, &compared, solver)));
        lines.flush()?;
    } else {
        print(&table(&machine.name, &cl, &compared))?;
    }
    Ok(status)
}

/// As a multiple of the first solver's time.
fn ratio(measured: &Measured, compared: &Compared) -> f64 {
    measured.pose_ns / compared.solvers[0].pose_ns
}

fn line(machine: &str, compared: &Compared, measured: &Measured) -> Value {
    let extreme = |extreme: Extreme| json!({ "value": extreme.value, "line": extreme.line });
    let effort = measured.effort.map(|effort| {
        json!({
            "mean": effort.mean_iterations(),
            "most": effort.most_iterations,
            "bisections": effort.bisections,
            "searches": effort.searches,
        })
    });
    json!({
        "type": "solver",
        "solver": name(measured.solver),
        "machine": machine,
        "points": compared.points,
        "failures": measured.failures,
        "tip_error_mm": extreme(measured.tip_mm),
        "axis_error_rad": extreme(measured.axis_rad),
        "iterations": effort,
        "time_per_pose_ns": measured.pose_ns,
        "time_ratio": ratio(measured, compared),
    })
}

/// One column for each solver.
fn table(machine: &str, cl: &str, compared: &Compared) -> String {
    let effort = |of: &dyn Fn(Effort) -> String| {
        let of_solver = |measured: &Measured| measured.effort.map_or_else(|| "-".to_owned(), of);
        compared.solvers.iter().map(of_solver).collect::<Vec<_>>()
    };
    let result = |of: &dyn Fn(&Measured) -> String| compared.solvers.iter().map(of).collect::<Vec<_>>();
    let error = |of: fn(&Measured) -> f64| {
        let of_solver = |measured: &Measured| {
            let is_solved = measured.failures < compared.points;
            if is_solved { format!("{:.1e}", of(measured)) } else { "-".to_owned() }
        };
        result(&of_solver)
    };
    let rows = [
        ("", result(&|measured| name(measured.solver).to_owned())),
        ("iterations a point, mean", effort(&|effort| format!("{:.2}", effort.mean_iterations()))),
        ("iterations a point, most", effort(&|effort| effort.most_iterations.to_string())),
        ("steps halved", effort(&|effort| effort.bisections.to_string())),
        ("searches from the grid", effort(&|effort| effort.searches.to_string())),
        ("largest tip error, mm", error(|measured| measured.tip_mm.value)),
        ("largest axis error, rad", error(|measured| measured.axis_rad.value)),
        ("points without a solution", result(&|measured| measured.failures.to_string())),
        ("time of a pose, ns", result(&|measured| format!("{:.0}", measured.pose_ns))),
        ("times the first", result(&|measured| format!("{:.1}", ratio(measured, compared)))),
    ];
    let row = |(title, cells): &(&str, Vec<String>)| {
        let cells: String = cells.iter().map(|cell| format!("{cell:>14}")).collect();
        format!("{title:<28}{cells}\n")
    };
    format!("{machine} along the {} points of {cl}\n\n", compared.points) + &rows.iter().map(row).collect::<String>()
}
