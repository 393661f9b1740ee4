//! The rows of a Denavit–Hartenberg table.

use mach_runtime::diagnostic::Code;

use super::grammar::{self, Pair, Rule};
use super::{Builder, parts, word};
use crate::syntax::tree::{DhAxis, DhRow};

/// A link with more or fewer numbers.
pub static FIVE_PARAMETERS: Code = Code {
    id: "E0114",
    title: "a link of a `dh` table has five parameters",
    explanation: "\
A link is written with its five parameters, in this order and with commas between them: the turn θ about z, the offsets a,
b and l along x, y and z, and the turn α about x.

    dh {
        //       θ,  a, b, l,      α
        link C:  0,  0, 0, -20 mm, 0
        link     0,  0, 0, 0,      90 deg
    }

A classical table of four (θ, d, a, α) is one with b = 0: `link C: θ, a, 0, d, α`.",
};

impl<'t> Builder<'_, 't> {
    pub(super) fn dh_row(&mut self, pair: Pair<'t>) -> Option<DhRow> {
        let span = grammar::extent(&pair);
        if pair.as_rule() == Rule::bed_statement {
            return Some(DhRow::Bed(span));
        }
        let mut parts = parts(pair);
        let axis = parts.take(Rule::variable).map(variable);
        let parameters: Vec<_> = parts.rest().map(|pair| self.expression(pair)).collect();
        let count = parameters.len();
        let Ok(parameters) = parameters.try_into() else {
            let message = format!("a link has five parameters, this has {count}");
            self.failures.error(&FIVE_PARAMETERS, message, span, "θ, a, b, l, α");
            return None;
        };
        Some(DhRow::Link { axis, parameters })
    }
}

fn variable(pair: Pair<'_>) -> DhAxis {
    let mut inner = pair.into_inner();
    let name = word(&inner.next().expect("a variable begins with its axis"));
    DhAxis { name, primed: inner.next().is_some() }
}
