//! What the placeholders of a block stand for, and how that is printed.

use super::dialect::{Dialect, Value, Word};
use super::text::{print_comment, print_program_name};
use super::write_error::WriteError;
use crate::number::{DecimalPoint, Picture};
use crate::toolpath::LoadedTool;

/// What the placeholders of a command's block stand for.
#[derive(Debug, Clone, Copy, Default)]
pub struct Values<'a> {
    /// The program's name, as the user gave it.
    pub program: &'a str,
    /// The machine's name.
    pub machine: &'a str,
    /// The CL's operation.
    pub operation: &'a str,
    /// The CL's name of the tool.
    pub tool_name: &'a str,
    /// A message or a comment.
    pub text: &'a str,
    /// The tool in the spindle, once the CL has loaded one.
    pub tool: Option<LoadedTool>,
    /// The spindle's speed in revolutions a minute.
    pub speed_rpm: f64,
    /// A dwell.
    pub dwell_s: f64,
}

/// Seconds where the template gives no picture.
const SECONDS: Picture = Picture { decimals: 3, point: DecimalPoint::Needed, ..Picture::WHOLE };

impl Values<'_> {
    /// The name, the usual picture and the number of a placeholder that is one; no number of a tool where there is none.
    fn number(&self, value: Value) -> Option<(&'static str, Picture, Option<f64>)> {
        Some(match value {
            Value::Tool => ("tool", Picture::WHOLE, self.tool.map(|tool| tool.number as f64)),
            Value::Register => ("register", Picture::WHOLE, self.tool.map(|tool| tool.register as f64)),
            Value::Speed => ("speed", Picture::WHOLE, Some(self.speed_rpm)),
            Value::Seconds => ("seconds", SECONDS, Some(self.dwell_s)),
            Value::Milliseconds => ("milliseconds", Picture::WHOLE, Some(self.dwell_s * 1000.0)),
            _ => return None,
        })
    }

    /// Prints what a placeholder stands for.
    pub(super) fn print(
        &self,
        value: Value,
        picture: Option<&Picture>,
        dialect: &Dialect,
        out: &mut Vec<u8>,
    ) -> Result<(), WriteError> {
        let delimiters = (dialect.comment.0.as_str(), dialect.comment.1.as_str());
        if let Some((name, plain, number)) = self.number(value) {
            let number = number.ok_or(WriteError::NoTool { name })?;
            return print_number(name, number, picture.unwrap_or(&plain), out);
        }
        match value {
            Value::Program if print_program_name(self.program, out) => {}
            Value::Program => return Err(WriteError::NoProgramName),
            Value::Machine => print_comment(self.machine, delimiters, out),
            Value::Operation => print_comment(self.operation, delimiters, out),
            Value::ToolName => print_comment(self.tool_name, delimiters, out),
            Value::Text => print_comment(self.text, delimiters, out),
            Value::Offset => out.extend_from_slice(dialect.offset.as_bytes()),
            Value::Units => out.extend_from_slice(dialect.codes.units.as_bytes()),
            Value::FeedMode | Value::Retract => {} // the writer knows the state and the axes
            Value::Tool | Value::Register | Value::Speed | Value::Seconds | Value::Milliseconds => {} // numbers
        }
        Ok(())
    }
}

fn print_number(name: &'static str, value: f64, picture: &Picture, out: &mut Vec<u8>) -> Result<(), WriteError> {
    let units = picture.units(value).ok_or_else(|| {
        let word = Word { name: name.into(), address: String::new(), picture: picture.clone() };
        WriteError::too_large(&word, value)
    })?;
    if units == 0 && value != 0.0 {
        return Err(WriteError::Zero { name, value });
    }
    picture.print(units, out);
    Ok(())
}
