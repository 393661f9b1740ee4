//! The statements of a machine and of its `branch` block.

use mach_runtime::diagnostic::{Code, Diagnostic};

use super::grammar::{self, Pair, Rule};
use super::{Builder, parts, word};
use crate::syntax::tree::{
    AxisClause, BranchStatement, ErrorRow, Expression, Link, MachineStatement, Name, Preference, Spanned, Strictness,
    ToleranceKind,
};

/// A clause said twice.
pub static CLAUSE_TWICE: Code = Code {
    id: "E0113",
    title: "clause said twice",
    explanation: "\
An axis has one travel and one rapid traverse. `turns unlimited` says that there are no limits, so it does not stand
beside `travel`:

    linear X along +x  travel -355 .. 355  rapid 36 m/min
    rotary C about +z  turns unlimited     rapid 100 rpm",
};

impl<'t> Builder<'_, 't> {
    pub(super) fn machine_statement(&mut self, pair: Pair<'t>) -> Option<MachineStatement> {
        let rule = pair.as_rule();
        let mut parts = parts(pair.clone());
        Some(match rule {
            Rule::let_statement => MachineStatement::Let { name: parts.name(), value: self.expression(parts.next()) },
            Rule::chain_statement => MachineStatement::Chain(parts.rest().map(link).collect()),
            Rule::linear_statement => MachineStatement::Linear {
                name: parts.name(),
                along: parts.take(Rule::along_clause).map(|clause| self.expression_of(clause)),
                clauses: self.axis_clauses(parts.rest().collect()),
            },
            Rule::rotary_statement => MachineStatement::Rotary {
                name: parts.name(),
                about: parts.take(Rule::about_clause).map(|clause| self.expression_of(clause)),
                through: parts.take(Rule::through_clause).map(|clause| self.expression_of(clause)),
                clauses: self.axis_clauses(parts.rest().collect()),
            },
            Rule::dh_statement => MachineStatement::Dh(self.body(parts.next(), Rule::in_dh, Self::dh_row)),
            Rule::error_statement => self.error_statement(parts.name(), parts.next()),
            Rule::tool_statement => MachineStatement::Tool {
                along: self.expression(parts.next()),
                at: parts.take(Rule::at_clause).map(|clause| self.expression_of(clause)),
                length: parts.take(Rule::length_clause).map(|clause| self.expression_of(clause)),
            },
            Rule::zero_statement => MachineStatement::Zero(self.expression(parts.next())),
            Rule::tolerance_statement => MachineStatement::Tolerance {
                kind: tolerance_kind(&parts.next()),
                value: self.expression(parts.next()),
            },
            Rule::records_statement => MachineStatement::Records(strictness(&parts.next())),
            Rule::branch_statement => {
                MachineStatement::Branch(
                    self.body(parts.next(), Rule::in_branch, |builder, pair| Some(builder.branch(pair))),
                )
            }
            Rule::controller_choice => MachineStatement::Controller {
                name: parts.name(),
                body: self.body(parts.next(), Rule::in_controller, Self::controller_statement),
            },
            rule => unreachable!("{rule:?} is no statement of a machine in the grammar"),
        })
    }

    fn branch(&mut self, pair: Pair<'t>) -> BranchStatement {
        let rule = pair.as_rule();
        let mut parts = parts(pair);
        match rule {
            Rule::start_statement => BranchStatement::Start(parts.rest().map(preference).collect()),
            Rule::then_statement => BranchStatement::Then(parts.rest().map(preference).collect()),
            Rule::lock_statement => BranchStatement::Lock { axis: parts.name(), value: self.expression(parts.next()) },
            Rule::prefer_statement => {
                BranchStatement::Prefer { axis: parts.name(), value: self.expression(parts.next()) }
            }
            Rule::free_statement => BranchStatement::Free(parts.name()),
            _ => BranchStatement::Reposition(strictness(&parts.next())),
        }
    }

    /// A value, or a table of values by positions.
    fn error_statement(&mut self, name: Name, said: Pair<'t>) -> MachineStatement {
        if said.as_rule() == Rule::expression {
            return MachineStatement::Error { name, value: self.expression(said) };
        }
        let row = |builder: &mut Self, pair: Pair<'t>| {
            let mut parts = parts(pair);
            let position = builder.expression(parts.next());
            Some(ErrorRow { position, error: builder.expression(parts.next()) })
        };
        MachineStatement::ErrorTable { name, rows: self.body(said, Rule::at_statement, row) }
    }

    /// The expression of a clause that holds nothing else.
    pub(super) fn expression_of(&mut self, clause: Pair<'t>) -> Expression {
        self.expression(parts(clause).next())
    }

    fn axis_clauses(&mut self, pairs: Vec<Pair<'t>>) -> Vec<Spanned<AxisClause>> {
        let clauses: Vec<_> = pairs.into_iter().map(|pair| self.axis_clause(pair)).collect();
        for (index, clause) in clauses.iter().enumerate() {
            let is_rapid = |clause: &Spanned<AxisClause>| matches!(clause.value, AxisClause::Rapid(_));
            if let Some(first) = clauses[..index].iter().find(|first| is_rapid(first) == is_rapid(clause)) {
                let diagnostic = Diagnostic::error(&CLAUSE_TWICE, "this has been said of the axis already")
                    .at(self.failures.place(&clause.span), "said again")
                    .at(self.failures.place(&first.span), "said here");
                self.failures.push(diagnostic);
            }
        }
        clauses
    }

    fn axis_clause(&mut self, pair: Pair<'t>) -> Spanned<AxisClause> {
        let span = grammar::extent(&pair);
        let rule = pair.as_rule();
        let mut parts = parts(pair);
        let value = match rule {
            Rule::travel_clause => {
                let from = self.expression(parts.next());
                AxisClause::Travel(from, self.expression(parts.next()))
            }
            Rule::rapid_clause => AxisClause::Rapid(self.expression(parts.next())),
            _ => AxisClause::Unlimited,
        };
        Spanned { value, span }
    }
}

fn link(pair: Pair<'_>) -> Link {
    let span = grammar::extent(&pair);
    let mut inner = pair.into_inner();
    let first = inner.next().expect("the grammar's link is not empty");
    match first.as_rule() {
        Rule::workpiece_link => Link::Workpiece(span),
        Rule::bed_link => Link::Bed(span),
        Rule::tool_link => Link::Tool(span),
        _ => Link::Axis { name: word(&first), primed: inner.next().is_some() },
    }
}

fn tolerance_kind(pair: &Pair<'_>) -> Spanned<ToleranceKind> {
    let value = match pair.as_rule() {
        Rule::axis_kind => ToleranceKind::Axis,
        Rule::chord_kind => ToleranceKind::Chord,
        _ => ToleranceKind::Plane,
    };
    Spanned { value, span: grammar::extent(pair) }
}

fn strictness(pair: &Pair<'_>) -> Spanned<Strictness> {
    let value = if pair.as_rule() == Rule::error_kind { Strictness::Error } else { Strictness::Warn };
    Spanned { value, span: grammar::extent(pair) }
}

fn preference(pair: Pair<'_>) -> Spanned<Preference> {
    let span = grammar::extent(&pair);
    let rule = pair.as_rule();
    let mut parts = parts(pair);
    let value = match rule {
        Rule::least_clause => Preference::Least(parts.name()),
        Rule::positive_clause => Preference::Positive(parts.name()),
        Rule::negative_clause => Preference::Negative(parts.name()),
        _ => Preference::Nearest,
    };
    Spanned { value, span }
}
