//! A way out that leads to the part. Looks at the finished tables: it takes the axes' travel and the controller's blocks, which
//! are run on the control's model.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::Draft;
use crate::model::machine::Model;
use crate::model::quantity::readable;
use crate::model::source::{Located, Location};
use crate::model::tables;
use crate::syntax::tree::ControllerStatement;
use mach_runtime::control::Control;
use mach_runtime::machine::{Machine, Retract, Travel};
use mach_runtime::motion::{Motion, What};
use mach_runtime::nc::dialect::{Block, Dialect, Piece, Trigger, Value};
use mach_runtime::nc::writer::{Values, Writer};
use mach_runtime::toolpath::LoadedTool;

/// A way out in the half of the travel where the part is.
pub(crate) static TOWARDS_THE_PART: Code = Code {
    id: "E0557",
    title: "the way out leads towards the part",
    explanation: "\
A block takes the linear axis that moves most along the tool to a place, in machine coordinates, that lies in the half of its
travel where the part is: as this file counts the travel, and also if the control counts it from the end on the tool's side. In
rapid traverse the tool would go down where it should be taken out.

    linear Z along +z travel -450 .. 60
    controller syntec { retract \"Z-400.\" }      // 50 mm above the lowest Z
    controller syntec { retract \"Z0.\" }         // the top, as the control counts
",
};

/// A way out that is the end of the travel where the part is, as the file counts.
pub(crate) static LOWEST: Code = Code {
    id: "W0558",
    title: "as this file counts, the way out is where the part is",
    explanation: "\
A block takes the linear axis that moves most along the tool to the end of its travel where the part is, as the file counts this
travel. That is right only if the control counts it from the other end.

    linear Z along +z travel 0 .. 510
    controller syntec { retract \"Z0.\" }         // the lowest Z of the file, the top of many controls

Count the travel as the control does, `travel -510 .. 0`, and place the program zero with `zero`.
",
};

/// The first block whose way out leads to the part.
pub(crate) fn check(
    model: &Model,
    draft: &Draft<'_>,
    statements: &[Located<ControllerStatement>],
) -> Option<Diagnostic> {
    let dialect = model.dialect.as_ref()?;
    let machine = tables::machine(model);
    let retract = Retract::of(&machine.axes)?;
    let moving = [Trigger::Start, Trigger::Operation, Trigger::Tool, Trigger::End];
    let found = moving.into_iter().find_map(|trigger| {
        let block = dialect.block(trigger)?;
        let ends = ends_mm(trigger, dialect, &machine, retract.axis);
        let (end_mm, wrong) = ends.into_iter().find_map(|end_mm| Some((end_mm, judge(end_mm, &retract, &machine)?)))?;
        Some((block, end_mm, wrong))
    });
    let (block, end_mm, wrong) = found?;
    let name = &machine.axes[retract.axis].name;
    let at = statements.iter().rev().find_map(|statement| said(statement, block))?;
    let Travel { lower, upper } = machine.axes[retract.axis].travel;
    let [end, lower, upper] = [end_mm, lower, upper].map(readable);
    let label = format!("goes to {name} {end} of a travel from {lower} to {upper}");
    let on = block.trigger.name();
    Some(match wrong {
        Wrong::HoweverCounted => {
            let message = format!("`on {on}` takes {name} towards the part");
            super::error(draft, &TOWARDS_THE_PART, message, &at, &label)
        }
        Wrong::AsCounted => {
            let message = format!("as this file counts, `on {on}` takes {name} where the part is");
            super::warning(draft, &LOWEST, message, &at, &label)
        }
    })
}

/// What is wrong with a way out.
enum Wrong {
    /// It leads towards the part from whichever end the control counts the travel.
    HoweverCounted,
    /// It leads there if the control counts as the file does.
    AsCounted,
}

/// What is wrong with going there.
fn judge(end_mm: f64, retract: &Retract, machine: &Machine) -> Option<Wrong> {
    let Travel { lower, upper } = machine.axes[retract.axis].travel;
    let length_mm = upper - lower;
    // Above the end where the part is: as the file counts, and as a control counts that has its zero at the other end.
    let (by_file_mm, from_the_top_mm) =
        if retract.is_upper { (end_mm - lower, length_mm + end_mm) } else { (upper - end_mm, length_mm - end_mm) };
    let is_low = |above_mm: f64| above_mm < 0.5 * length_mm;
    match (is_low(by_file_mm) && is_low(from_the_top_mm), by_file_mm <= 0.0) {
        _ if !length_mm.is_finite() => None,
        (true, _) => Some(Wrong::HoweverCounted),
        (false, true) => Some(Wrong::AsCounted),
        (false, false) => None,
    }
}

/// Where an axis goes in machine coordinates when the block of this event is run.
fn ends_mm(trigger: Trigger, dialect: &Dialect, machine: &Machine, axis: usize) -> Vec<f64> {
    let tool = LoadedTool { number: 1, register: 1 };
    let values = Values { program: "P", tool: Some(tool), ..Values::default() };
    let (mut writer, mut text) = (Writer::new(dialect.clone(), &machine.axes), Vec::new());
    // A block that cannot be printed has been told.
    let _ = writer.command(trigger, &values, &mut text);
    let mut control = Control::new(&dialect.table, &machine.axes, machine.tool());
    let mut motion = Motion::new(machine.axes.len());
    control.run_what_it_can(&String::from_utf8_lossy(&text), &mut motion);
    let ends = motion.items().iter().filter_map(|item| match &item.what {
        What::Move(it) if it.is_machine && it.named & it.known & 1 << axis != 0 => Some(motion.joints(it)[axis]),
        _ => None,
    });
    ends.collect()
}

/// Where the statement says where the block goes: `retract`, if the block prints that, else the block itself.
fn said(statement: &Located<ControllerStatement>, block: &Block) -> Option<Location> {
    let mut pieces = block.lines.iter().flat_map(|line| &line.pieces);
    let prints_retract = pieces.any(|piece| matches!(piece, Piece::Value(Value::Retract, _)));
    match &statement.value {
        ControllerStatement::Retract(_) if prints_retract => Some(statement.at.clone()),
        ControllerStatement::On { event, .. } if !prints_retract && event.value == block.trigger => {
            Some(statement.at.clone())
        }
        _ => None,
    }
}
