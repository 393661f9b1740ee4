//! A program through the library's verifier.

use super::machine::compiled;
use super::refit::Refit;
use mach_runtime::cl::Reader;
use mach_runtime::diagnostic::Diagnostic;
use mach_runtime::rig::{Rig, reader_options};
use mach_runtime::verify::{Agreement, Comparison, Verifier};
use machc::compile::Compiled;
use machc::model::tables;
use machc::plan::Interpreter;
use std::io::Read;
use std::num::NonZeroUsize;

/// A machine, and a CL file that it is posted for.
pub(crate) struct Setup {
    pub(crate) compiled: Compiled,
    pub(crate) rig: Rig<Interpreter>,
}

impl Setup {
    /// A machine of the library with another control than its own.
    pub(crate) fn refitted(machine: &str, control: &str) -> Self {
        let refit = Refit { machine, control };
        Self::new(compiled(&refit.path(), &refit))
    }

    pub(crate) fn new(compiled: Compiled) -> Self {
        let rig = compiled.rig().expect("the machine has a controller");
        Self { compiled, rig }
    }

    /// The program, where the machine can do what the CL asks.
    pub(crate) fn post(&self, cl: &str) -> Option<String> {
        let reader = Reader::new("part.cls", cl.as_bytes(), reader_options(&self.rig.machine));
        let mut nc = Vec::new();
        let posted = self.rig.post(("part.cls", "part"), reader, &mut nc, NonZeroUsize::MIN, &mut |_| {});
        posted.expect("memory can be written").map(|_| String::from_utf8(nc).expect("ASCII"))
    }

    /// What is told of a program against its CL.
    pub(crate) fn verify(&self, nc: &str, cl: &str) -> (Vec<Diagnostic>, Agreement) {
        let machine = tables::machine(&self.compiled.model);
        let mut kinematics = Interpreter::new(&self.compiled.plan);
        let options = reader_options(&machine);
        let reader = Reader::new("part.cls", Box::new(cl.as_bytes()) as Box<dyn Read>, options);
        let comparison = Comparison::new("part.cls", reader, &machine, &self.rig.dialect);
        let mut verifier =
            Verifier::new("part.nc", &self.rig.dialect.table, &machine, &mut kinematics).against(Some(comparison));
        let mut told = Vec::new();
        for (number, line) in (1..).zip(nc.lines()) {
            verifier.line(line, number, &mut |it| told.push(it)).expect("memory can be read");
        }
        let (_, agreement) = verifier.finish(&mut |it| told.push(it)).expect("memory can be read");
        let agreement = agreement.expect("it is compared");
        (told, agreement)
    }
}
