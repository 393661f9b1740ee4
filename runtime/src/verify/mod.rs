//! What a program does, whoever wrote it: its text is run on the control's model, and looked at block by block.
//!
//! The survey (`survey`) says where it goes, how long it is, and what in it is suspicious. With a CL it is compared
//! (`comparison`): point by point, event by event, in order. And it can be written as CL (`reverse`).

mod comparison;
mod habit;
mod mismatch;
mod pose;
mod reverse;
mod survey;
mod suspicion;
mod tolerance;
mod wanted;

pub use comparison::{Agreement, Comparison};
pub use mismatch::DIFFERENCES;
pub use reverse::ReverseCl;
pub use survey::{Survey, ToolUse};
pub use suspicion::SUSPICIONS;

use crate::control::Control;
use crate::diagnostic::{Code, Diagnostic, Place};
use crate::dialect::table::Table;
use crate::kinematics::Kinematics;
use crate::machine::Machine;
use crate::motion::{Item, Motion, What};
use pose::{Pose, Solver};
use std::io;

/// A program that is read line by line.
pub struct Verifier<'m> {
    file: String,
    control: Control<'m>,
    machine: &'m Machine,
    solver: Solver<'m>,
    motion: Motion,
    survey: Survey,
    /// Where the tool is, once every axis is known.
    pose: Option<Pose>,
    errors: u32,
}

/// So many lines that cannot be read are told.
const MOST_ERRORS: u32 = 20;

/// E1201.
pub static UNREADABLE: Code = Code {
    id: "E1201",
    title: "the control would not understand this block",
    explanation: "\
The program is read by the table of the machine's controller: its words, and the groups and codes that it declares. What stands
here is in none of them, or not in this way, and nothing of a program is skipped.

If it is a code of the machine's builder that moves nothing, declare it in the machine's own `controller` block:

    plain \"M11\" \"the C axis is unclamped\"

A code that means something is declared in its group. `docs/language.md` lists the groups.",
};

impl<'m> Verifier<'m> {
    /// At the start of a program that the user calls `file`.
    pub fn new(file: &str, table: &'m Table, machine: &'m Machine, kinematics: &'m mut dyn Kinematics) -> Self {
        Self {
            file: file.to_owned(),
            control: Control::new(table, &machine.axes, machine.tool()),
            machine,
            solver: Solver::new(machine, kinematics),
            motion: Motion::new(machine.axes.len()),
            survey: Survey::new(machine, table),
            pose: None,
            errors: 0,
        }
    }

    /// Reads a line; compares it with the CL and writes it as CL, where that is asked for.
    ///
    /// # Errors
    /// When the CL cannot be read, or that which is written cannot.
    pub fn line(
        &mut self,
        (text, number): (&str, u64),
        comparison: &mut Option<Comparison<'_>>,
        reverse: &mut Option<ReverseCl<'_>>,
        tell: &mut dyn FnMut(Diagnostic),
    ) -> io::Result<()> {
        self.motion.clear();
        if let Err((mistake, span)) = self.control.run(text, number, &mut self.motion) {
            self.errors += 1;
            if self.errors <= MOST_ERRORS {
                let place = place(&self.file, number, text, span);
                tell(Diagnostic::error(&UNREADABLE, mistake.to_string()).at(place, ""));
            }
            return Ok(());
        }
        let Self { file, control, machine, solver, motion, survey, pose, .. } = self;
        for item in motion.items() {
            let (before, after) = (*pose, end(item, motion, machine, solver, *pose));
            survey.take(item, motion, control.modal(), [before, after]);
            if let Some(comparison) = comparison {
                comparison.take(item, motion, (after, solver), file, tell)?;
            }
            if let Some(reverse) = reverse {
                reverse.take(item, motion, after)?;
            }
            *pose = after;
        }
        Ok(())
    }

    /// Whether every line could be read.
    pub fn is_readable(&self) -> bool {
        self.errors == 0
    }

    /// What the program does, and what is suspicious in it.
    pub fn finish(self, tell: &mut dyn FnMut(Diagnostic)) -> Survey {
        self.survey.suspicions(&self.file).into_iter().for_each(tell);
        self.survey
    }
}

/// Where the tool is behind an item.
fn end(item: &Item, motion: &Motion, machine: &Machine, solver: &mut Solver<'_>, before: Option<Pose>) -> Option<Pose> {
    let What::Move(it) = &item.what else { return before };
    let all = (1 << machine.axes.len()) - 1;
    (it.known == all).then(|| solver.pose(motion.joints(it)))
}

/// A place in a line that is at hand.
fn place(file: &str, number: u64, text: &str, span: std::ops::Range<usize>) -> Place {
    let start = span.start.min(text.len());
    let end = span.end.clamp(start, text.len());
    let column = text[..start].chars().count() as u64 + 1;
    Place { file: file.to_owned(), line: number, column, excerpt: text.to_owned(), start, end }
}
