//! Statements to a draft: every expression evaluated, every field in its unit.

use super::draft::{AxisDraft, Draft, RuleDraft, ToolDraft, WrittenDraft};
use super::evaluate::Evaluator;
use super::family::{Controller, Said};
use super::field::{Field, Sign};
use super::library::{Entry, Library};
use super::lost::Lost;
use super::parameter::{self, Parameter};
use super::source::{Located, Location, SourceMap};
use super::subject::AXIS;
use super::{dh, measured};
use crate::diagnostic::{Code, Diagnostic};
use crate::syntax::tree::{
    AxisClause, BranchStatement, Broken, ControllerStatement, Expression, MachineStatement, Name, Preference, Spanned,
    ToleranceKind,
};
use mach_runtime::machine::{Motion, Rule, Travel};
use nalgebra::Vector3;

/// A linear axis that turns.
pub(crate) static DOES_NOT_TURN: Code = Code {
    id: "E0214",
    title: "a linear axis does not turn",
    explanation: "\
`turns unlimited` is said of a rotary axis without end stops. A linear axis without a `travel` has no limits either, as
far as machc is concerned.

    linear X along +x turns unlimited
    linear X along +x                   // no travel: no limit
",
};

/// Evaluates a machine's statements.
pub(crate) fn describe<'a>(
    library: &Library<'a>,
    machine: &Entry<'_, MachineStatement>,
    said: &Said<MachineStatement>,
    controller: Option<&Controller<'_>>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Draft<'a> {
    let statements = &said.statements[..];
    let mut evaluator = Evaluator::new(library.sources, &said.lost);
    let parameters = parameters(statements);
    parameter::define(&mut evaluator, &parameters);
    let mut draft = empty(library.sources, machine);
    draft.parameters = parameters.iter().filter_map(|parameter| shown(&evaluator, parameter)).collect();
    for statement in statements {
        statement_into(&mut evaluator, &mut draft, statement);
    }
    lost_axes(&mut draft, said.lost.clone());
    dh::lower(&mut evaluator, &mut draft, statements);
    draft.ruled = ruled(&mut evaluator, &draft, statements);
    measured::errors(&mut evaluator, &mut draft, statements);
    if let Some(controller) = controller {
        // A controller's definition stands alone: its expressions know no machine's parameters.
        let nothing = Lost::default();
        let mut alone = Evaluator::new(library.sources, &nothing);
        draft.written.extend(controller.family.iter().filter_map(|said| written_by(&mut alone, said, false)));
        draft.written.extend(controller.own.iter().filter_map(|said| written_by(&mut evaluator, said, true)));
        diagnostics.append(&mut alone.diagnostics);
        draft.lost_of_controller = controller.said.lost.clone();
    }
    diagnostics.append(&mut evaluator.diagnostics);
    draft
}

/// A parameter's name and value for people.
fn shown(evaluator: &Evaluator<'_>, parameter: &Parameter<'_>) -> Option<(String, String)> {
    let name = &parameter.name.value.value;
    let value = evaluator.parameters.get(name)?.value?;
    Some((name.clone(), value.display()))
}

fn empty<'a>(sources: &'a SourceMap, machine: &Entry<'_, MachineStatement>) -> Draft<'a> {
    Draft {
        sources,
        name: Located { value: machine.definition.name.value.clone(), at: machine.at() },
        title: machine.definition.title.as_ref().map(|title| title.value.clone()),
        parameters: Vec::new(),
        chain: None,
        is_chain_of_a_table: false,
        is_chain_whole: true,
        axes: Vec::new(),
        tool: None,
        errors: Vec::new(),
        zero_mm: None,
        axis_tolerance_deg: None,
        chord_tolerance_mm: None,
        plane_tolerance_mm: None,
        unknown_records: None,
        start: Vec::new(),
        then: Vec::new(),
        reposition: None,
        ruled: Vec::new(),
        written: Vec::new(),
        lost: Lost::default(),
        lost_of_controller: Lost::default(),
    }
}

fn parameters(statements: &[Located<MachineStatement>]) -> Vec<Parameter<'_>> {
    let lets = statements.iter().filter_map(|statement| match &statement.value {
        MachineStatement::Let { name, value } => {
            Some(Parameter { name: Located { value: name, at: statement.at.with(&name.span) }, value })
        }
        _ => None,
    });
    lets.collect()
}

fn statement_into(evaluator: &mut Evaluator<'_>, draft: &mut Draft<'_>, statement: &Located<MachineStatement>) {
    let source = statement.at.source;
    match &statement.value {
        MachineStatement::Let { .. } | MachineStatement::Controller { .. } => {}
        // These need the axes.
        MachineStatement::Dh(_) | MachineStatement::Error { .. } | MachineStatement::ErrorTable { .. } => {}
        MachineStatement::Chain(links) => {
            draft.chain = Some(Located { value: links.clone(), at: statement.at.clone() });
        }
        MachineStatement::Linear { name, along, clauses } => {
            draft.axes.push(axis(evaluator, Motion::Linear, (name, along.as_ref(), None, clauses), &statement.at));
        }
        MachineStatement::Rotary { name, about, through, clauses } => {
            draft.axes.push(axis(
                evaluator,
                Motion::Rotary,
                (name, about.as_ref(), through.as_ref(), clauses),
                &statement.at,
            ));
        }
        MachineStatement::Tool { along, at, length } => {
            draft.tool = Some(tool(evaluator, &statement.at, along, at.as_ref(), length.as_ref()));
        }
        MachineStatement::Zero(point) => draft.zero_mm = evaluator.point(source, point),
        MachineStatement::Tolerance { kind, value } => match kind.value {
            ToleranceKind::Axis => {
                draft.axis_tolerance_deg = evaluator.number(source, value, Field::Angle, Sign::Positive);
            }
            ToleranceKind::Chord => {
                draft.chord_tolerance_mm = evaluator.number(source, value, Field::Length, Sign::Positive);
            }
            ToleranceKind::Plane => {
                draft.plane_tolerance_mm = evaluator.number(source, value, Field::Length, Sign::Positive);
            }
        },
        MachineStatement::Records(said) => draft.unknown_records = Some(said.value),
        MachineStatement::Branch(body) => {
            body.statements.iter().for_each(|stated| branch_into(draft, &stated.node, &statement.at));
        }
    }
}

fn branch_into(draft: &mut Draft<'_>, statement: &BranchStatement, at: &Location) {
    let located = |said: &[Spanned<Preference>]| -> Vec<Located<Preference>> {
        said.iter().map(|it| Located { value: it.value.clone(), at: at.with(&it.span) }).collect()
    };
    match statement {
        BranchStatement::Start(preferences) => draft.start = located(preferences),
        BranchStatement::Then(preferences) => draft.then = located(preferences),
        BranchStatement::Reposition(said) => draft.reposition = Some(said.value),
        // Their values are measured as the axes' travel is: once these are known.
        BranchStatement::Lock { .. } | BranchStatement::Prefer { .. } | BranchStatement::Free(_) => {}
    }
}

/// What is said of axes that the pose does not decide.
fn ruled(evaluator: &mut Evaluator<'_>, draft: &Draft<'_>, statements: &[Located<MachineStatement>]) -> Vec<RuleDraft> {
    let bodies = statements.iter().filter_map(|statement| match &statement.value {
        MachineStatement::Branch(body) => Some((body, &statement.at)),
        _ => None,
    });
    let said = bodies.flat_map(|(body, at)| body.statements.iter().map(move |said| (&said.node, at.with(&said.span))));
    said.filter_map(|(said, at)| rule(evaluator, draft, said, at)).collect()
}

fn rule(evaluator: &mut Evaluator<'_>, draft: &Draft<'_>, said: &BranchStatement, at: Location) -> Option<RuleDraft> {
    let (axis, value, rule): (_, _, fn(f64) -> Rule) = match said {
        BranchStatement::Lock { axis, value } => (axis, Some(value), Rule::Locked),
        BranchStatement::Prefer { axis, value } => (axis, Some(value), Rule::Preferred),
        BranchStatement::Free(axis) => (axis, None, |_| Rule::Free),
        _ => return None,
    };
    let value = match (value, draft.axis(&axis.value)) {
        (Some(value), Some((_, axis))) => evaluator.number(at.source, value, Field::travel(axis.motion), Sign::Any),
        // That there is no such axis is found later.
        _ => Some(0.0),
    };
    let axis = Located { value: axis.clone(), at: at.with(&axis.span) };
    Some(RuleDraft { axis, rule: value.map(rule), at })
}

fn tool(
    evaluator: &mut Evaluator<'_>,
    at: &Location,
    along: &Expression,
    gauge: Option<&Expression>,
    length: Option<&Expression>,
) -> ToolDraft {
    let gauge_mm = gauge.map_or(Some(Vector3::zeros()), |point| evaluator.point(at.source, point));
    let length_mm = |length| evaluator.number(at.source, length, Field::Length, Sign::NotNegative);
    let length_mm = length.map_or(Some(0.0), length_mm);
    ToolDraft { at: at.clone(), along: direction(evaluator, at, along), gauge_mm, length_mm }
}

fn direction(evaluator: &mut Evaluator<'_>, at: &Location, said: &Expression) -> Option<Located<Vector3<f64>>> {
    let value = evaluator.direction(at.source, said)?;
    Some(Located { value, at: at.with(&said.span) })
}

/// Draws axes of what was not understood, where that is only about them.
fn lost_axes(draft: &mut Draft<'_>, mut lost: Lost) {
    for axis in lost.take(lost_axis) {
        if draft.axis(&axis.name.value).is_none() {
            draft.axes.push(axis);
        }
    }
    draft.lost = lost;
}

/// An axis of which no more was understood than that it is there.
fn lost_axis(lost: &Located<Broken>) -> Option<AxisDraft> {
    let (keyword, name) = lost.value.only_meaning()?;
    let motion = AXIS.iter().zip([Motion::Linear, Motion::Rotary]).find(|(axis, _)| **axis == keyword)?.1;
    Some(AxisDraft {
        at: lost.at.clone(),
        name: Located { value: name.to_owned(), at: lost.at.clone() },
        motion,
        direction: None,
        point_mm: None,
        travel: None,
        rapid_per_min: None,
    })
}

type AxisParts<'t> = (&'t Name, Option<&'t Expression>, Option<&'t Expression>, &'t [Spanned<AxisClause>]);

fn axis(
    evaluator: &mut Evaluator<'_>,
    motion: Motion,
    (name, along, through, clauses): AxisParts<'_>,
    at: &Location,
) -> AxisDraft {
    let mut axis = AxisDraft {
        at: at.clone(),
        name: Located { value: name.value.clone(), at: at.with(&name.span) },
        motion,
        direction: along.and_then(|along| direction(evaluator, at, along)),
        point_mm: through.map_or(Some(Vector3::zeros()), |point| evaluator.point(at.source, point)),
        travel: None,
        rapid_per_min: None,
    };
    for clause in clauses {
        match &clause.value {
            AxisClause::Travel(lower, upper) => {
                let travel = evaluator.range(at.source, [lower, upper], Field::travel(motion));
                axis.travel = travel.map(|value| Located { value, at: at.with(&clause.span) });
            }
            AxisClause::Unlimited => {
                if motion == Motion::Linear {
                    let message = format!("{} is a linear axis and does not turn", name.value);
                    evaluator.report(&DOES_NOT_TURN, at.source, &clause.span, message, "only a rotary axis turns");
                }
                let value = [Travel::UNLIMITED.lower, Travel::UNLIMITED.upper];
                axis.travel = Some(Located { value, at: at.with(&clause.span) });
            }
            AxisClause::Rapid(speed) => {
                axis.rapid_per_min = evaluator.number(at.source, speed, Field::rapid(motion), Sign::Positive);
            }
        }
    }
    axis
}

fn written_by(
    evaluator: &mut Evaluator<'_>,
    statement: &Located<ControllerStatement>,
    of_the_machine: bool,
) -> Option<WrittenDraft> {
    let source = statement.at.source;
    let located = |axis: &Name| Located { value: axis.clone(), at: statement.at.with(&axis.span) };
    match &statement.value {
        ControllerStatement::WriteRange { axis, from, to } => {
            let value = evaluator.range(source, [from, to], Field::Angle)?;
            let at = statement.at.with(&(from.span.start..to.span.end));
            Some(WrittenDraft { axis: located(axis), range_deg: Some(Located { value, at }), of_the_machine })
        }
        ControllerStatement::WriteUnwound(axis) => {
            Some(WrittenDraft { axis: located(axis), range_deg: None, of_the_machine })
        }
        _ => None,
    }
}
