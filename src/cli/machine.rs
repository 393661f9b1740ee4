//! From the name of a machine file to everything that is made of it.

use std::path::Path;

use mach_command::files::shown;
use mach_command::outcome::{Failure, Status};
use mach_command::report::Report;
use mach_runtime::machine::Machine;
use mach_runtime::rig::Rig;
use machc::compile::{Compiled, compile};
use machc::diagnostic::Diagnostic;
use machc::model::machine::Model;
use machc::model::origin::Origins;
use machc::model::tables;
use machc::plan::{Interpreter, Plan};
use machc::prove::Proof;

use super::folders::{Folders, generated_name};

/// The code of a file that cannot be read; without a place it is the one that the arguments name.
const CANNOT_READ: &str = "E0201";

/// A machine, compiled and proved.
#[derive(Debug)]
pub(super) struct Prepared {
    pub(super) model: Model,
    pub(super) origins: Origins,
    pub(super) machine: Machine,
    pub(super) plan: Plan,
    pub(super) proof: Proof,
}

impl Prepared {
    /// The machine with its closed form; none when it names no controller.
    pub(super) fn rig(&self) -> Option<Rig<Interpreter>> {
        let dialect = self.model.dialect.clone()?;
        Some(Rig { machine: self.machine.clone(), kinematics: Interpreter::new(&self.plan), dialect })
    }
}

/// Compiles a machine file and tells what there is to tell; nothing when it has errors.
pub(super) fn prepare(file: &str, report: &Report) -> Result<Option<Prepared>, Failure> {
    prepare_in(Path::new(""), file, report)
}

/// The same for a file that is named as seen from another folder.
pub(super) fn prepare_in(base: &Path, file: &str, report: &Report) -> Result<Option<Prepared>, Failure> {
    let prepared = |Compiled { model, origins, plan, proof, .. }: Compiled| {
        let machine = tables::machine(&model);
        Prepared { model, origins, machine, plan, proof }
    };
    Ok(compiled_in(base, file, report)?.map(prepared))
}

/// Compiles a machine file and tells what there is to tell, without making anything of it.
pub(super) fn compiled(file: &str, report: &Report) -> Result<Option<Compiled>, Failure> {
    compiled_in(Path::new(""), file, report)
}

fn compiled_in(base: &Path, file: &str, report: &Report) -> Result<Option<Compiled>, Failure> {
    match compile(file, &Folders { base, entry: file }) {
        Ok(mut compiled) => {
            compiled.origins.call_files(generated_name);
            report.tell(&compiled.warnings);
            Ok(Some(compiled))
        }
        Err(diagnostics) => {
            let unreadable =
                |diagnostic: &&Diagnostic| diagnostic.code.id == CANNOT_READ && diagnostic.labels.is_empty();
            if let Some(entry) = diagnostics.iter().find(unreadable) {
                return Err(Failure(entry.message.replace("`-`", &format!("`{}`", shown("-")))));
            }
            report.tell(&diagnostics);
            Ok(None)
        }
    }
}

/// `Done` or `Refused` for something that is there or not.
pub(super) fn status<T>(prepared: Option<T>) -> Status {
    if prepared.is_some() { Status::Done } else { Status::Refused }
}
