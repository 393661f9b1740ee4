//! What `post` and `solve` share: the machine, the CL file, and the options that say what neither of them says.

use std::io::Read;

use clap::ValueEnum;
use mach_runtime::cl::{Reader, ReaderOptions, quote};
use mach_runtime::diagnostic::Diagnostic;
use mach_runtime::machine::Machine;
use mach_runtime::rig::reader_options;
use mach_runtime::tool::ToolGeometry;
use mach_runtime::unit::LengthUnit;

use crate::files::{open, reopened, shown};
use crate::outcome::Failure;
use crate::progress::watched;
use crate::report::Report;

/// What neither the machine nor the CL file says.
#[derive(Debug, clap::Args)]
pub struct Options {
    #[command(flatten)]
    units: UnitsOption,
    /// Gauge length of the tool in mm, instead of the machine file's
    #[arg(long, value_name = "MM", value_parser = length_mm, allow_negative_numbers = true)]
    tool_length: Option<f64>,
}

/// What the CL file does not say.
#[derive(Debug, clap::Args)]
pub struct UnitsOption {
    /// Unit of the CL's lengths where the file has no UNITS record
    #[arg(long, value_name = "UNIT", value_enum, default_value_t = Unit::Mm)]
    cl_units: Unit,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Unit {
    Mm,
    Inch,
}

impl Options {
    /// The machine with the tool that the options give.
    pub fn equipped(&self, mut machine: Machine) -> Machine {
        if let Some(length_mm) = self.tool_length {
            machine.tools = vec![ToolGeometry::of_length(length_mm)];
        }
        machine
    }

    /// A reader of a CL file for a machine.
    pub fn reader(&self, cl: &str, machine: &Machine, report: &Report) -> Result<Reader<Box<dyn Read>>, Failure> {
        self.units.reader(cl, reader_options(machine), report)
    }
}

impl UnitsOption {
    /// A reader of a CL file.
    pub fn reader(&self, cl: &str, options: ReaderOptions, report: &Report) -> Result<Reader<Box<dyn Read>>, Failure> {
        let (input, bytes) = open(cl)?;
        let length_unit = match self.cl_units {
            Unit::Mm => LengthUnit::Millimetre,
            Unit::Inch => LengthUnit::Inch,
        };
        Ok(Reader::new(shown(cl), watched(input, bytes, report), ReaderOptions { length_unit, ..options }))
    }
}

/// Puts the lines into the diagnostics that lack them. What cannot be read a second time stays as it is.
pub fn quoted(mut diagnostics: Vec<Diagnostic>, cl: &str) -> Vec<Diagnostic> {
    if !diagnostics.is_empty()
        && let Some(input) = reopened(cl)
    {
        let _ = quote(&mut diagnostics, shown(cl), input);
    }
    diagnostics
}

fn length_mm(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(length_mm) if (0.0..=1e4).contains(&length_mm) => Ok(length_mm + 0.0),
        _ => Err("expected a length from 0 to 10000 mm".to_owned()),
    }
}
