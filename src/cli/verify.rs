//! `machc verify`.

use std::io::{Write, stdout};

use mach_command::files::{cannot_read, cannot_write, shown, stem};
use mach_command::outcome::{Failure, Status};
use mach_command::output::Output;
use mach_command::report::{Collected, Report};
use mach_command::toolpath::{Options, quoted};
use mach_runtime::machine::Machine;
use mach_runtime::nc::dialect::Dialect;
use mach_runtime::verify::{Agreement, Comparison, Failed, ReverseCl, Survey, Verifier};
use machc::plan::{Interpreter, Plan};
use serde::Serialize;

use super::machine::prepare;
use super::post::no_controller;
use super::program::ProgramLines;

/// Run a program on the control's model: what it does, and whether it does what a CL file asks
///
/// The program may be anybody's, in the dialect of the machine's controller. Its blocks are read by the words, groups and codes
/// that the controller declares; what is not declared is an error at its place. Told are where the program goes, how long its
/// ways are, and what is suspicious in it. With --against it is compared with a CL file: every point, kind of motion, feed, tool,
/// register, offset, spindle, coolant, stop and dwell, in their order. Exit status: 0 nothing is wrong, 1 something is.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The machine file
    machine: String,
    /// The program; - reads standard input
    program: String,
    /// Compare it with this CL file
    #[arg(long, value_name = "CL")]
    against: Option<String>,
    /// Write it back as a CL file
    #[arg(long, value_name = "FILE")]
    cl: Option<String>,
    #[command(flatten)]
    options: Options,
}

/// The machine's tables, and how its programs are written.
struct Reading<'a> {
    machine: &'a Machine,
    dialect: &'a Dialect,
    plan: &'a Plan,
}

pub(super) fn run(arguments: Arguments, report: &mut Report) -> Result<Status, Failure> {
    let Some(prepared) = prepare(&arguments.machine, report)? else { return Ok(Status::Refused) };
    let Some(dialect) = &prepared.model.dialect else {
        return Ok(report.tell(&[no_controller(&prepared.origins)]));
    };
    let machine = arguments.options.equipped(prepared.machine.clone());
    let reading = Reading { machine: &machine, dialect, plan: &prepared.plan };
    let mut output = arguments.cl.as_deref().map(|path| Output::begin(Some(path))).transpose()?;
    let mut told = Collected::default();
    let (survey, agreement) = verify(&arguments, &reading, output.as_mut(), &mut told, report)?;
    let mut diagnostics = told.into_diagnostics();
    for file in arguments.against.iter().chain([&arguments.program]) {
        diagnostics = quoted(diagnostics, file);
    }
    let status = report.tell(&diagnostics);
    print(&survey, agreement.as_ref(), report)?;
    if status == Status::Done
        && let Some(output) = output
    {
        output.commit()?;
    }
    Ok(status)
}

fn verify(
    arguments: &Arguments,
    reading: &Reading<'_>,
    output: Option<&mut Output>,
    told: &mut Collected,
    report: &Report,
) -> Result<(Survey, Option<Agreement>), Failure> {
    let Reading { machine, dialect, plan } = *reading;
    let (program, cl) = (&arguments.program, arguments.cl.as_deref().unwrap_or_default());
    let mut lines = ProgramLines::open(program, report)?;
    let comparison = match &arguments.against {
        Some(file) => {
            let reader = arguments.options.reader(file, machine, report)?;
            Some(Comparison::new(shown(file), reader, machine, dialect))
        }
        None => None,
    };
    let begin = |output| ReverseCl::begin(output, machine, stem(program).unwrap_or("PROGRAM"));
    let reverse = output.map(|output| begin(output as &mut dyn Write)).transpose();
    let reverse = reverse.map_err(|error| cannot_write(cl, &error))?;
    let mut kinematics = Interpreter::new(plan);
    let mut verifier = Verifier::new(shown(program), &dialect.table, machine, &mut kinematics);
    verifier = verifier.against(comparison).written_as(reverse);
    let cannot = |failed| match failed {
        Failed::Against(error) => cannot_read(arguments.against.as_deref().unwrap_or_default(), &error),
        Failed::WrittenAs(error) => cannot_write(cl, &error),
    };
    while let Some((text, number)) = lines.next()? {
        verifier.line(&text, number, &mut |it| told.add(it)).map_err(cannot)?;
    }
    verifier.finish(&mut |it| told.add(it)).map_err(cannot)
}

/// What was found, on standard output.
fn print(survey: &Survey, agreement: Option<&Agreement>, report: &Report) -> Result<(), Failure> {
    let text = if report.is_json() {
        let message = Message::new(survey, agreement);
        serde_json::to_string(&message).expect("numbers and texts are JSON") + "\n"
    } else {
        agreement.map_or(String::new(), |agreement| format!("{agreement}\n")) + &survey.to_string()
    };
    match stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(cannot_write("<stdout>", &error)),
        _ => Ok(()),
    }
}

#[derive(Serialize)]
struct Message {
    blocks: u64,
    tools: Vec<Tool>,
    axes: Vec<Axis>,
    against: Option<Against>,
}

#[derive(Serialize)]
struct Tool {
    tool: Option<u32>,
    blocks: u64,
    rapid_mm: f64,
    feed_mm: f64,
    feed_s: f64,
}

#[derive(Serialize)]
struct Axis {
    name: String,
    least: f64,
    greatest: f64,
}

#[derive(Serialize)]
struct Against {
    points: u64,
    differences: u64,
    approaches: u64,
    retracts: u64,
    tip_error_mm: f64,
    axis_error_rad: f64,
}

impl Message {
    fn new(survey: &Survey, agreement: Option<&Agreement>) -> Self {
        let visited = survey.ranges.iter().filter(|range| range.is_visited());
        let axis = |range: &mach_runtime::certificate::Range| Axis {
            name: range.axis.name.clone(),
            least: range.least().value,
            greatest: range.greatest().value,
        };
        let tool = |it: &mach_runtime::verify::ToolUse| Tool {
            tool: it.tool,
            blocks: it.blocks,
            rapid_mm: it.rapid_mm,
            feed_mm: it.feed_mm,
            feed_s: it.feed_s,
        };
        let against = |it: &Agreement| Against {
            points: it.points,
            differences: it.differences,
            approaches: it.approaches,
            retracts: it.retracts,
            tip_error_mm: it.worst.tip_mm.value,
            axis_error_rad: it.worst.axis_rad.value,
        };
        Self {
            blocks: survey.blocks,
            tools: survey.tools.iter().map(tool).collect(),
            axes: visited.map(axis).collect(),
            against: agreement.map(against),
        }
    }
}
