//! Which way a machine's inverse is computed.

use super::{Effort, Method, Numeric};
use crate::plan::{Interpreter, Plan};
use mach_runtime::kinematics::Kinematics;

/// A way from poses to joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Solver {
    /// The plan's inverse.
    ClosedForm,
    /// Iteration on the plan's forward chain.
    Numeric(Method),
}

impl Solver {
    /// Those that a plan has; the one to take where nobody says otherwise comes first.
    pub fn of_plan(plan: &Plan) -> impl Iterator<Item = Self> + use<> {
        let closed_form = plan.has_closed_form().then_some(Self::ClosedForm);
        closed_form.into_iter().chain([Self::Numeric(Method::Newton), Self::Numeric(Method::Broyden)])
    }

    /// The inverse of a plan's machine; none where a closed form is asked for and there is none.
    pub fn inverse(self, plan: &Plan) -> Option<Inverse> {
        match self {
            Self::ClosedForm if !plan.has_closed_form() => None,
            Self::ClosedForm => Some(Inverse::ClosedForm(Box::new(Interpreter::new(plan)))),
            Self::Numeric(method) => Some(Inverse::Numeric(Box::new(Numeric::new(plan, method)))),
        }
    }
}

/// A machine's inverse, one way or the other.
#[derive(Debug, Clone)]
pub enum Inverse {
    /// In closed form.
    ClosedForm(Box<Interpreter>),
    /// By iteration.
    Numeric(Box<Numeric>),
}

impl Inverse {
    /// As the runtime knows it.
    pub fn kinematics(&self) -> &dyn Kinematics {
        match self {
            Self::ClosedForm(interpreter) => &**interpreter,
            Self::Numeric(numeric) => &**numeric,
        }
    }

    /// As the runtime runs it.
    pub fn kinematics_mut(&mut self) -> &mut (dyn Kinematics + Send) {
        match self {
            Self::ClosedForm(interpreter) => &mut **interpreter,
            Self::Numeric(numeric) => &mut **numeric,
        }
    }

    /// What it has taken so far; nothing for a closed form, which does not iterate.
    pub fn effort(&self) -> Option<Effort> {
        match self {
            Self::ClosedForm(_) => None,
            Self::Numeric(numeric) => Some(numeric.effort()),
        }
    }
}
