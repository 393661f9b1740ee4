//! What a program does, whoever wrote it: its text is run on the control's model, and looked at block by block.
//!
//! The survey (`survey`) says where it goes, how long it is, and what in it is suspicious. With a CL it is compared
//! (`comparison`): point by point, event by event, in order. And it can be written as CL (`reverse`).

mod agreement;
pub(crate) mod comparison;
mod habit;
mod judgement;
mod mismatch;
pub(crate) mod pose;
mod reverse;
mod survey;
mod suspicion;
mod tolerance;
mod unreadable;
mod wanted;
mod words;

pub use agreement::Agreement;
pub use comparison::Comparison;
pub use mismatch::DIFFERENCES;
pub use reverse::ReverseCl;
pub use survey::{Survey, ToolUse};
pub use suspicion::SUSPICIONS;
pub use unreadable::{UNREADABLE, Unreadable};

use crate::control::{Block, Control, Mistake};
use crate::diagnostic::Diagnostic;
use crate::dialect::meaning::{Meaning, Once};
use crate::dialect::table::Table;
use crate::kinematics::Kinematics;
use crate::machine::Machine;
use crate::motion::{Motion, What};
use pose::{Pose, Solver};
use std::io;

/// A program that is read line by line.
pub struct Verifier<'m> {
    file: String,
    control: Control<'m>,
    solver: Solver<'m, &'m mut dyn Kinematics>,
    comparison: Option<Comparison<'m>>,
    reverse: Option<ReverseCl<'m>>,
    survey: Survey,
    /// What has been read and not looked at yet, and where the tool is behind each item and before the first one.
    motion: Motion,
    poses: Vec<Option<Pose>>,
    before: Option<Pose>,
    last_line: u64,
    unreadable: Unreadable,
}

/// What could not be read or written beside the program.
#[derive(Debug)]
pub enum Failed {
    /// The CL that it is compared with.
    Against(io::Error),
    /// The CL that it is written as.
    WrittenAs(io::Error),
}

/// So many items are looked at together: what is done for many costs less, and they stay in the processor's cache.
const TOGETHER: usize = 512;

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
            unreadable: Unreadable::default(),
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
    pub fn line(&mut self, text: &str, number: u64, tell: &mut dyn FnMut(Diagnostic)) -> Result<(), Failed> {
        // What stands behind the end is never run.
        if self.control.is_over() {
            let is_end = |block: &Block| block.has(Meaning::Once(Once::ProgramEnd));
            if !self.control.read(text).is_ok_and(|block| block.as_ref().is_none_or(is_end)) {
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
                if self.motion.items().len() >= TOGETHER { self.look(tell) } else { Ok(()) }
            }
            Err(fault) => {
                self.look(tell)?;
                self.unreadable.meet(&self.file, (text, number), fault, tell);
                Ok(())
            }
        }
    }

    /// Looks at what has been read.
    fn look(&mut self, tell: &mut dyn FnMut(Diagnostic)) -> Result<(), Failed> {
        let Self { file, solver, comparison, reverse, survey, motion, poses, before, .. } = self;
        solver.poses(motion, *before, poses);
        survey.take(motion, poses, *before);
        if let Some(comparison) = comparison {
            comparison.compare(motion, poses).map_err(Failed::Against)?;
            comparison.judge_words(motion, solver);
            comparison.tell(file, tell);
        }
        if let Some(reverse) = reverse {
            let mut items = motion.items().iter().zip(&*poses);
            let written = items.try_for_each(|(item, pose)| reverse.take(item, motion, *pose));
            written.map_err(Failed::WrittenAs)?;
        }
        *before = poses.last().copied().unwrap_or(*before);
        motion.clear();
        Ok(())
    }

    /// What the program does, what is suspicious in it, and how it agrees with the CL.
    ///
    /// # Errors
    /// As [`Self::line`].
    pub fn finish(mut self, tell: &mut dyn FnMut(Diagnostic)) -> Result<(Survey, Option<Agreement>), Failed> {
        self.look(tell)?;
        if self.control.is_continued() {
            self.unreadable.meet(&self.file, ("", self.last_line), (Mistake::Unfinished, 0..0), tell);
        }
        self.reverse.map(ReverseCl::end).transpose().map_err(Failed::WrittenAs)?;
        let end = (self.file.as_str(), self.last_line);
        let agreement = self.comparison.map(|comparison| against(comparison, end, tell));
        let agreement = agreement.transpose().map_err(Failed::Against)?;
        self.survey.suspicions(&self.file).into_iter().for_each(tell);
        Ok((self.survey, agreement))
    }
}

/// The end of a comparison with a CL.
fn against(
    mut comparison: Comparison<'_>,
    (file, line): (&str, u64),
    tell: &mut dyn FnMut(Diagnostic),
) -> io::Result<Agreement> {
    comparison.finish(line)?;
    comparison.tell(file, tell);
    Ok(comparison.agreement())
}
