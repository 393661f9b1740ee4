//! `machc motion`.

mod json;

use mach_command::files::shown;
use mach_command::outcome::{Failure, Status};
use mach_command::output::Lines;
use mach_command::report::{Collected, Report};
use mach_command::toolpath::{Options, quoted};
use mach_runtime::control::Control;
use mach_runtime::motion::{Event, Motion, MotionText, What};
use mach_runtime::verify::Unreadable;

use super::machine::prepare;
use super::post::no_controller;
use super::program::ProgramLines;
use json::Message;

/// Print the motion of an NC program, one item a line
///
/// The program is read as the machine's control would read it. Each line tells what a block does: where every axis is at its
/// end, in machine coordinates, in mm and degrees; how it gets there; and what is in force: tool, length register, offset,
/// spindle, feed, coolant. Nothing is modal. With --json each line is an object, at full precision.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The machine file
    machine: String,
    /// The program; - reads standard input
    program: String,
    /// Decimals of the text
    #[arg(long, value_name = "COUNT", default_value_t = MotionText::DECIMALS as u8, value_parser = clap::value_parser!(u8).range(0..=9))]
    decimals: u8,
    #[command(flatten)]
    options: Options,
}

pub(super) fn run(arguments: Arguments, report: &mut Report) -> Result<Status, Failure> {
    let Some(prepared) = prepare(&arguments.machine, report)? else { return Ok(Status::Refused) };
    let Some(table) = prepared.model.dialect.as_ref().map(|dialect| &dialect.table) else {
        return Ok(report.tell(&[no_controller(&prepared.origins)]));
    };
    let machine = arguments.options.equipped(prepared.machine.clone());
    let names: Vec<String> = machine.axes.iter().map(|axis| axis.name.clone()).collect();
    let text = MotionText::new(&names, arguments.decimals.into());
    let mut lines = Lines::stdout();
    if !report.is_json() {
        lines.add_text(&text.head());
    }
    let file = &arguments.program;
    let mut program = ProgramLines::open(file, report)?;
    let mut control = Control::new(table, &machine.axes, machine.tool());
    let mut motion = Motion::new(machine.axes.len());
    let (mut told, mut unreadable) = (Collected::default(), Unreadable::default());
    while let Some((line, number)) = program.next()? {
        motion.clear();
        if let Err(fault) = control.run(&line, number, &mut motion) {
            unreadable.meet(shown(file), (&line, number), fault, &mut |diagnostic| told.add(diagnostic));
        }
        for item in motion.items() {
            if report.is_json() {
                lines.add(&Message::new(item, &motion, &machine.axes));
            } else {
                lines.add_text(&text.line(item, &motion));
            }
        }
        let is_over = motion.items().iter().any(|item| item.what == What::Event(Event::End));
        if is_over || !lines.flush_many()? {
            break;
        }
    }
    lines.flush()?;
    Ok(report.tell(&quoted(told.into_diagnostics(), file)))
}
