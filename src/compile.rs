//! The whole compiler on one screen: text in, a proved machine or diagnostics out. It reads through [`Sources`] and does no I/O
//! of its own.

use crate::check;
use crate::derive::derive;
use crate::diagnostic::{Diagnostic, Severity};
use crate::model::build::build;
use crate::model::describe::describe;
use crate::model::dialect::dialect;
use crate::model::library::Library;
use crate::model::load::load;
use crate::model::machine::Model;
use crate::model::origin::{Origins, origins};
use crate::model::source::SourceMap;
use crate::model::{family, library};
use crate::plan::Plan;
use crate::prove::{self, Proof};
use crate::sources::Sources;

/// What compiling a machine gives.
#[derive(Debug)]
pub struct Compiled {
    /// The checked machine.
    pub model: Model,
    /// Where its statements stand.
    pub origins: Origins,
    /// What was derived of it.
    pub plan: Plan,
    /// How far the derivation was from exact when it was tried.
    pub proof: Proof,
    /// What a user should look at.
    pub warnings: Vec<Diagnostic>,
}

/// Compiles the machine that the file `entry` defines, with everything the file uses.
///
/// # Errors
///
/// Every mistake that was found, in the order of the text (and the warnings with them).
pub fn compile(entry: &str, sources: &dyn Sources) -> Result<Compiled, Vec<Diagnostic>> {
    let mut found = Vec::new();
    let program = load(entry, sources, &mut found);
    let library = Library::collect(&program, &mut found);
    let Some(machine) = library::entry_machine(&program, &mut found) else {
        return Err(in_order(&program.sources, found));
    };
    let said = family::of_machine(&library, machine, &mut found);
    let controller = family::controller(&library, &said.statements, &mut found);
    let draft = describe(&library, &machine, &said, controller.as_ref(), &mut found);
    let dialect = controller.as_ref().and_then(|controller| dialect(controller, &draft, &mut found));
    found.extend(check::all(&draft));
    refuse_errors(&program.sources, &mut found)?;

    let model = Model { dialect, ..build(&draft) };
    if let Some(controller) = &controller {
        found.extend(check::narrow_word::check(&model, &draft, &controller.said.statements));
        found.extend(check::coarse_word::check(&model, &draft, &controller.said.statements));
        found.extend(check::towards_the_part::check(&model, &draft, &controller.said.statements));
        found.extend(check::no_way_out::check(&model, &draft, &controller.said.statements));
    }
    refuse_errors(&program.sources, &mut found)?;

    let origins = origins(&draft);
    let plan = derive(&model);
    let proof = prove::prove(&model, &plan);
    found.extend(prove::check(&model, &proof));
    refuse_errors(&program.sources, &mut found)?;
    Ok(Compiled { model, origins, plan, proof, warnings: found })
}

/// Ends the work if an error was found.
fn refuse_errors(sources: &SourceMap, found: &mut Vec<Diagnostic>) -> Result<(), Vec<Diagnostic>> {
    *found = in_order(sources, std::mem::take(found));
    let refused = found.iter().any(|diagnostic| diagnostic.severity == Severity::Error);
    if refused { Err(std::mem::take(found)) } else { Ok(()) }
}

/// What was found, in the order of the text.
fn in_order(sources: &SourceMap, mut found: Vec<Diagnostic>) -> Vec<Diagnostic> {
    found.sort_by_key(|diagnostic| {
        let cause = diagnostic.labels.first().map(|label| &label.place);
        cause.map(|place| (sources.find(&place.file), place.line, place.column))
    });
    found
}
