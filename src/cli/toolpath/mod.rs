//! `machc toolpath`.

mod json;

use mach_command::files::cannot_read;
use mach_command::outcome::{Failure, Status};
use mach_command::output::Lines;
use mach_command::report::{Collected, Report};
use mach_command::toolpath::{UnitsOption, quoted};
use mach_runtime::cl::{ReaderOptions, Toolpath};
use mach_runtime::toolpath::ToolpathText;

use json::Message;

/// Print the toolpath of a CL file, one item a line
///
/// Each line is a point or a command of the file, with its line there: the tip in mm and the unit tool axis, in the frame of the
/// first MSYS; rapid or at feed; and what is in force: tool, spindle, feed, coolant. Nothing is modal, arcs are points within
/// 0.01 mm. With --json each line is an object, at full precision.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The CL file; - reads standard input
    cl: String,
    /// Decimals of the text
    #[arg(long, value_name = "COUNT", default_value_t = ToolpathText::DECIMALS as u8, value_parser = clap::value_parser!(u8).range(0..=9))]
    decimals: u8,
    #[command(flatten)]
    units: UnitsOption,
}

pub(super) fn run(arguments: Arguments, report: &Report) -> Result<Status, Failure> {
    let Arguments { cl, decimals, units } = &arguments;
    let mut toolpath = Toolpath::new(units.reader(cl, ReaderOptions::default(), report)?);
    let text = ToolpathText::new((*decimals).into());
    let (mut lines, mut told) = (Lines::stdout(), Collected::default());
    if !report.is_json() {
        lines.add_text(&text.head());
    }
    while let Some(read) = toolpath.next_item().map_err(|error| cannot_read(cl, &error))? {
        match read {
            Ok(item) if report.is_json() => lines.add(&Message::new(&item)),
            Ok(item) => lines.add_text(&text.line(&item)),
            Err(diagnostic) => told.add(diagnostic),
        }
        if !lines.flush_many()? {
            break;
        }
    }
    lines.flush()?;
    Ok(report.tell(&quoted(told.into_diagnostics(), cl)))
}
