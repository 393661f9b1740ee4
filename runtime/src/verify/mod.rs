//! What a program does, whoever wrote it: its text is run on the control's model, and looked at block by block.
//!
//! The survey (`survey`) says where it goes, how long it is, and what in it is suspicious. With a CL it is compared
//! (`comparison`): point by point, event by event, in order. And it can be written as CL (`reverse`).

mod agreement;
mod comparison;
mod habit;
mod judgement;
mod mismatch;
mod pose;
mod reverse;
mod survey;
mod suspicion;
mod tolerance;
mod wanted;
mod words;

pub use agreement::Agreement;
pub use comparison::Comparison;
pub use mismatch::DIFFERENCES;
pub use reverse::ReverseCl;
pub use survey::{Survey, ToolUse};
pub use suspicion::SUSPICIONS;

use crate::control::{Control, Fault};
use crate::diagnostic::{Code, Diagnostic, Place};
use crate::dialect::table::Table;
use crate::kinematics::Kinematics;
use crate::machine::Machine;
use crate::motion::{Event, Motion, What};
use pose::{Pose, Solver};
use std::io;

/// A program that is read line by line.
pub struct Verifier<'m> {
    file: String,
    control: Control<'m>,
    solver: Solver<'m>,
    comparison: Option<Comparison<'m>>,
    reverse: Option<ReverseCl<'m>>,
    survey: Survey,
    /// What has been read and not looked at yet, and where the tool is behind each item and before the first one.
    motion: Motion,
    poses: Vec<Option<Pose>>,
    before: Option<Pose>,
    last_line: u64,
    /// Whether the program has said that it is over: what stands behind that is never run.
    is_over: bool,
    errors: u32,
}

/// So many items are looked at together: what is done for many costs less, and they stay in the processor's cache.
const TOGETHER: usize = 512;

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
            solver: Solver::new(machine, kinematics),
            comparison: None,
            reverse: None,
            survey: Survey::new(machine, table),
            motion: Motion::new(machine.axes.len()),
            poses: Vec::new(),
            before: None,
            last_line: 0,
            is_over: false,
            errors: 0,
        }
    }

    /// Compares it with a CL.
    #[must_use]
    pub fn against(self, comparison: Option<Comparison<'m>>) -> Self {
        Self { comparison, ..self }
    }

    /// Writes it as CL.
    #[must_use]
    pub fn written_as(self, reverse: Option<ReverseCl<'m>>) -> Self {
        Self { reverse, ..self }
    }

    /// Reads a line.
    ///
    /// # Errors
    /// When the CL cannot be read, or that which is written cannot.
    pub fn line(&mut self, text: &str, number: u64, tell: &mut dyn FnMut(Diagnostic)) -> io::Result<()> {
        if self.is_over {
            if !matches!(self.control.read(text), Ok(None)) {
                self.survey.behind_the_end(number);
            }
            return Ok(());
        }
        self.last_line = number;
        let items = self.motion.items().len();
        match self.control.run(text, number, &mut self.motion) {
            Ok(()) => {
                let items = &self.motion.items()[items..];
                if items.iter().any(|item| matches!(item.what, What::Move(_))) {
                    self.survey.suspect_state(number, self.control.modal());
                }
                self.is_over = items.iter().any(|item| item.what == What::Event(Event::End));
                if self.motion.items().len() >= TOGETHER { self.look(tell) } else { Ok(()) }
            }
            Err(fault) => {
                self.look(tell)?;
                self.tell_unreadable(text, fault, tell);
                Ok(())
            }
        }
    }

    fn tell_unreadable(&mut self, text: &str, (mistake, span): Fault, tell: &mut dyn FnMut(Diagnostic)) {
        self.errors += 1;
        if self.errors <= MOST_ERRORS {
            let place = place(&self.file, self.last_line, text, span);
            tell(Diagnostic::error(&UNREADABLE, mistake.to_string()).at(place, ""));
        }
    }

    /// Looks at what has been read.
    fn look(&mut self, tell: &mut dyn FnMut(Diagnostic)) -> io::Result<()> {
        let Self { file, solver, comparison, reverse, survey, motion, poses, before, .. } = self;
        solver.poses(motion, *before, poses);
        survey.take(motion, poses, *before);
        if let Some(comparison) = comparison {
            comparison.take(motion, poses, solver, file, tell)?;
        }
        if let Some(reverse) = reverse {
            motion.items().iter().zip(&*poses).try_for_each(|(item, pose)| reverse.take(item, motion, *pose))?;
        }
        *before = poses.last().copied().unwrap_or(*before);
        motion.clear();
        Ok(())
    }

    /// What the program does, what is suspicious in it, and how it agrees with the CL.
    ///
    /// # Errors
    /// As [`Self::line`].
    pub fn finish(mut self, tell: &mut dyn FnMut(Diagnostic)) -> io::Result<(Survey, Option<Agreement>)> {
        self.look(tell)?;
        self.reverse.map(ReverseCl::end).transpose()?;
        let end = (self.file.as_str(), self.last_line);
        let agreement = self.comparison.map(|comparison| comparison.finish(end, tell)).transpose()?;
        self.survey.suspicions(&self.file).into_iter().for_each(tell);
        Ok((self.survey, agreement))
    }
}

/// A place in a line that is at hand.
fn place(file: &str, number: u64, text: &str, span: std::ops::Range<usize>) -> Place {
    let start = span.start.min(text.len());
    let end = span.end.clamp(start, text.len());
    let column = text[..start].chars().count() as u64 + 1;
    Place { file: file.to_owned(), line: number, column, excerpt: text.to_owned(), start, end }
}
