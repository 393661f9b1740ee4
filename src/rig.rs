//! A compiled machine as one that can be posted for.

use crate::compile::Compiled;
use crate::model::tables;
use crate::plan::Interpreter;
use mach_runtime::rig::Rig;

impl Compiled {
    /// The machine with its closed form; none when it has none, or when the machine file names no controller.
    pub fn rig(&self) -> Option<Rig<Interpreter>> {
        let dialect = self.model.dialect.clone().filter(|_| self.plan.has_closed_form())?;
        Some(Rig { machine: tables::machine(&self.model), kinematics: Interpreter::new(&self.plan), dialect })
    }
}
