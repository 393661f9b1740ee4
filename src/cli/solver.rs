//! The option `--solver`.

use clap::ValueEnum;
use mach_command::outcome::Failure;
use machc::numeric::{Inverse, Method, Solver};

use super::machine::Prepared;

#[derive(Debug, clap::Args)]
pub(super) struct SolverOption {
    /// How the joints are found: in closed form, or by iteration with the derivatives of the forward chain (Newton), or
    /// without (Broyden); by default in closed form where the machine has one
    #[arg(long, value_name = "SOLVER", value_enum)]
    solver: Option<Choice>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Choice {
    ClosedForm,
    Newton,
    Broyden,
}

impl SolverOption {
    /// The inverse of this machine.
    pub(super) fn inverse(&self, prepared: &Prepared) -> Result<Inverse, Failure> {
        let solver = match self.solver {
            None => Solver::of_plan(&prepared.plan).next().expect("a plan can always be iterated on"),
            Some(Choice::ClosedForm) => Solver::ClosedForm,
            Some(Choice::Newton) => Solver::Numeric(Method::Newton),
            Some(Choice::Broyden) => Solver::Numeric(Method::Broyden),
        };
        let none = || Failure(format!("machine `{}` has no closed form", prepared.model.name));
        solver.inverse(&prepared.plan).ok_or_else(none)
    }
}

/// As the option and the tables name it.
pub(super) fn name(solver: Solver) -> &'static str {
    match solver {
        Solver::ClosedForm => "closed-form",
        Solver::Numeric(Method::Newton) => "newton",
        Solver::Numeric(Method::Broyden) => "broyden",
    }
}
