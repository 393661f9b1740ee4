//! The statements of a machine and of its `branch` block.

use super::Printer;
use super::expression::expression;
use super::layout::{StatementText, Table};
use crate::syntax::tree::{
    AxisClause, BranchStatement, DhRow, ErrorRow, Expression, Link, MachineStatement, Preference, Spanned, Strictness,
    ToleranceKind,
};

impl Printer {
    pub(super) fn machine_statement(&mut self, statement: &MachineStatement, behind: Option<&str>) {
        match statement {
            MachineStatement::Branch(body) => self.block("branch", body, behind, |printer, statement, behind| {
                printer.line(branch(statement), behind);
            }),
            MachineStatement::Dh(body) => self.block("dh", body, behind, |printer, row, behind| {
                printer.line(dh_row(row), behind);
            }),
            MachineStatement::ErrorTable { name, rows } => {
                self.block(&format!("error {}", name.value), rows, behind, |printer, row, behind| {
                    printer.line(error_row(row), behind);
                });
            }
            MachineStatement::Controller { name, body } => {
                self.block(&format!("controller {}", name.value), body, behind, Self::controller_statement);
            }
            statement => self.line(line(statement), behind),
        }
    }
}

/// A statement without a block.
fn line(statement: &MachineStatement) -> StatementText {
    let text = match statement {
        MachineStatement::Let { name, value } => {
            let cells = vec![format!("let {}", name.value), format!("= {}", expression(value))];
            return StatementText::row(Table::Parameters, cells);
        }
        MachineStatement::Linear { name, along, clauses } => {
            let along = along.as_ref().map_or(String::new(), |along| format!("along {}", expression(along)));
            let cells = vec![format!("linear {}", name.value), along];
            return StatementText::row(Table::LinearAxes, [cells, axis_clauses(clauses)].concat());
        }
        MachineStatement::Rotary { name, about, through, clauses } => {
            let cells = vec![
                format!("rotary {}", name.value),
                about.as_ref().map_or(String::new(), |about| format!("about {}", expression(about))),
                through.as_ref().map_or(String::new(), |point| format!("through {}", expression(point))),
            ];
            return StatementText::row(Table::RotaryAxes, [cells, axis_clauses(clauses)].concat());
        }
        MachineStatement::Error { name, value } => {
            return StatementText::row(Table::Errors, vec![format!("error {}", name.value), expression(value)]);
        }
        MachineStatement::Chain(links) => format!("chain {}", links.iter().map(link).collect::<Vec<_>>().join(" ")),
        MachineStatement::Tool { along, at, length } => {
            format!(
                "tool along {}{}{}",
                expression(along),
                clause("at", at.as_ref()),
                clause("length", length.as_ref())
            )
        }
        MachineStatement::Zero(point) => format!("zero {}", expression(point)),
        MachineStatement::Tolerance { kind, value } => {
            let kind = match kind.value {
                ToleranceKind::Axis => "axis",
                ToleranceKind::Chord => "chord",
                ToleranceKind::Plane => "plane",
            };
            format!("tolerance {kind} {}", expression(value))
        }
        MachineStatement::Records(strictness) => format!("records unknown {}", word(strictness)),
        MachineStatement::Branch(_)
        | MachineStatement::Controller { .. }
        | MachineStatement::Dh(_)
        | MachineStatement::ErrorTable { .. } => unreachable!("printed as a block"),
    };
    StatementText::plain(text)
}

/// ` KEYWORD EXPRESSION`, where it is said.
pub(super) fn clause(keyword: &str, value: Option<&Expression>) -> String {
    value.map_or(String::new(), |value| format!(" {keyword} {}", expression(value)))
}

/// Travel in one column and rapid in the next; where they stand the other way round, both in one.
fn axis_clauses(clauses: &[Spanned<AxisClause>]) -> Vec<String> {
    let texts: Vec<String> = clauses.iter().map(|clause| axis_clause(&clause.value)).collect();
    match clauses {
        [only] if matches!(only.value, AxisClause::Rapid(_)) => vec![String::new(), texts.concat()],
        [first, ..] if matches!(first.value, AxisClause::Rapid(_)) => vec![texts.join("  ")],
        _ => texts,
    }
}

fn axis_clause(clause: &AxisClause) -> String {
    match clause {
        AxisClause::Travel(from, to) => format!("travel {} .. {}", expression(from), expression(to)),
        AxisClause::Unlimited => "turns unlimited".to_owned(),
        AxisClause::Rapid(speed) => format!("rapid {}", expression(speed)),
    }
}

fn link(link: &Link) -> String {
    match link {
        Link::Workpiece(_) => "w".to_owned(),
        Link::Bed(_) => "b".to_owned(),
        Link::Tool(_) => "t".to_owned(),
        Link::Axis { name, primed } => format!("{}{}", name.value, prime(*primed)),
    }
}

fn word(strictness: &Spanned<Strictness>) -> &'static str {
    match strictness.value {
        Strictness::Error => "error",
        Strictness::Warn => "warn",
    }
}

/// The parameters in columns, each with the comma behind it.
fn dh_row(row: &DhRow) -> StatementText {
    let DhRow::Link { axis, parameters } = row else { return StatementText::row(Table::Links, vec!["bed".to_owned()]) };
    let axis = axis.as_ref().map_or(String::new(), |axis| format!("{}{}:", axis.name.value, prime(axis.primed)));
    let last = parameters.len() - 1;
    let parameters = parameters.iter().enumerate();
    let cells = parameters.map(|(i, parameter)| expression(parameter) + if i == last { "" } else { "," });
    StatementText::row(Table::Links, ["link".to_owned(), axis].into_iter().chain(cells).collect())
}

fn error_row(row: &ErrorRow) -> StatementText {
    StatementText::row(Table::ErrorRows, vec![format!("at {}:", expression(&row.position)), expression(&row.error)])
}

fn prime(primed: bool) -> &'static str {
    if primed { "'" } else { "" }
}

fn branch(statement: &BranchStatement) -> StatementText {
    let row = |keyword: &str, rest: String| StatementText::row(Table::Branch, vec![keyword.to_owned(), rest]);
    let listed =
        |preferences: &[Spanned<Preference>]| preferences.iter().map(preference).collect::<Vec<_>>().join(", ");
    match statement {
        BranchStatement::Start(preferences) => row("start", listed(preferences)),
        BranchStatement::Then(preferences) => row("then", listed(preferences)),
        BranchStatement::Lock { axis, value } => row("lock", format!("{} {}", axis.value, expression(value))),
        BranchStatement::Prefer { axis, value } => row("prefer", format!("{} {}", axis.value, expression(value))),
        BranchStatement::Free(axis) => row("free", axis.value.clone()),
        BranchStatement::Reposition(strictness) => StatementText::plain(format!("reposition {}", word(strictness))),
    }
}

fn preference(preference: &Spanned<Preference>) -> String {
    match &preference.value {
        Preference::Least(axis) => format!("least |{}|", axis.value),
        Preference::Positive(axis) => format!("positive {}", axis.value),
        Preference::Negative(axis) => format!("negative {}", axis.value),
        Preference::Nearest => "nearest".to_owned(),
    }
}
