//! Which way a machine's inverse is computed.

use super::{Method, Numeric};
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

    /// The kinematics of a plan; none where a closed form is asked for and there is none.
    pub fn kinematics(self, plan: &Plan) -> Option<Box<dyn Kinematics>> {
        match self {
            Self::ClosedForm if !plan.has_closed_form() => None,
            Self::ClosedForm => Some(Box::new(Interpreter::new(plan))),
            Self::Numeric(method) => Some(Box::new(Numeric::new(plan, method))),
        }
    }
}
