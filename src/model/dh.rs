//! `dh { … }`: a Denavit–Hartenberg table as the chain, and the directions and points of its axes.
//!
//! The table leads from the workpiece, whose frame is the machine's, to the tool. A link is
//! `Rz(θ) Trans(a, b, l) Rx(α)`; a rotary axis adds to θ, a linear one to l, so that either acts along z of the frame
//! before its link.

use super::draft::{AxisDraft, Draft, ToolDraft};
use super::evaluate::Evaluator;
use super::field::{Field, Sign};
use super::source::{Located, Location};
use crate::diagnostic::{Code, Diagnostic};
use crate::plan::{cos_constant, sin_constant, snap};
use crate::syntax::tree::{Body, DhAxis, DhRow, Expression, Link, MachineStatement};
use mach_runtime::machine::Motion;
use nalgebra::{Matrix3, Vector3};

/// A chain and a table.
pub(crate) static SAID_BY_BOTH: Code = Code {
    id: "E0222",
    title: "a `dh` table says what another statement says too",
    explanation: "\
A `dh` table is the chain, and says where the axes lie. Beside it there is no `chain`, and the axes' own statements have no
direction:

    dh {
        link C: 0, 0, 0, -20 mm, 0
        bed
        link Z: 0, 0, 0, 0, 0
    }
    rotary C turns unlimited        // not: rotary C about +z
    linear Z travel -450 .. 60
",
};

/// An axis that lies nowhere.
pub(crate) static NO_LINE: Code = Code {
    id: "E0223",
    title: "nothing says where an axis lies",
    explanation: "\
A linear axis has a direction, a rotary one a direction and a point, with every axis at zero:

    linear X along +x  travel -355 .. 355
    rotary A about +x through (0, 0, -20)

Only where a `dh` table is the chain they are left out.
",
};

/// Puts the table, if there is one, in the place of a chain and of directions.
pub(super) fn lower(evaluator: &mut Evaluator<'_>, draft: &mut Draft<'_>, statements: &[Located<MachineStatement>]) {
    let table = statements.iter().find_map(|statement| match &statement.value {
        MachineStatement::Dh(body) => Some((body, &statement.at)),
        _ => None,
    });
    let axes = statements.iter().filter_map(|statement| match &statement.value {
        MachineStatement::Linear { name, along, .. } => Some((name, along.as_ref(), &statement.at)),
        MachineStatement::Rotary { name, about, .. } => Some((name, about.as_ref(), &statement.at)),
        _ => None,
    });
    for (name, direction, at) in axes {
        match (table, direction) {
            (None, None) if !draft.lost.may_be(&["dh"]) => {
                let message = format!("nothing says where {} lies", name.value);
                evaluator.report(&NO_LINE, at.source, &name.span, message, "in which direction?");
            }
            (Some((_, table)), Some(direction)) => {
                let what = format!("the direction of {}", name.value);
                report_both(evaluator, &what, &at.with(&direction.span), table);
            }
            _ => {}
        }
    }
    if let Some((body, at)) = table {
        if let Some(chain) = &draft.chain {
            report_both(evaluator, "the chain", &chain.at, at);
        }
        replace(evaluator, draft, body, at);
    }
}

fn report_both(evaluator: &mut Evaluator<'_>, what: &str, at: &Location, table: &Location) {
    let table = table.with(&(table.span.start..table.span.start + "dh".len()));
    let diagnostic = Diagnostic::error(&SAID_BY_BOTH, format!("{what} is said here and by the `dh` table"))
        .at(evaluator.sources.place(at), "leave this out")
        .at(evaluator.sources.place(&table), "the table");
    evaluator.diagnostics.push(diagnostic);
}

/// Walks along the table.
fn replace(evaluator: &mut Evaluator<'_>, draft: &mut Draft<'_>, body: &Body<DhRow>, at: &Location) {
    let mut links = vec![Link::Workpiece(at.span.clone())];
    let mut frame = Some(Frame { axes: Matrix3::identity(), origin_mm: Vector3::zeros() });
    draft.is_chain_whole = body.broken.is_empty();
    for row in &body.statements {
        // Behind a link that was not understood nobody knows where the next one begins.
        frame = frame.filter(|_| body.broken.iter().all(|broken| row.span.start < broken.span.start));
        match &row.node {
            DhRow::Bed(span) => links.push(Link::Bed(span.clone())),
            DhRow::Link { axis, parameters } => {
                if let Some(DhAxis { name, primed }) = axis {
                    links.push(Link::Axis { name: name.clone(), primed: *primed });
                    let line = draft.axes.iter_mut().find(|declared| declared.name.value == name.value);
                    line.into_iter().for_each(|line| lay(line, frame.as_ref(), &at.with(&name.span)));
                }
                let parameters = evaluate(evaluator, at, parameters);
                frame = frame.zip(parameters).map(|(frame, parameters)| frame.beyond(parameters));
            }
        }
    }
    frame = frame.filter(|_| body.broken.is_empty());
    links.push(Link::Tool(at.span.clone()));
    draft.chain = Some(Located { value: links, at: at.clone() });
    draft.is_chain_of_a_table = true;
    if draft.tool.is_none() {
        let last = body.statements.last().map_or(&at.span, |row| &row.span);
        draft.tool = Some(ToolDraft {
            at: at.with(last),
            along: frame.as_ref().map(|frame| Located { value: frame.z(), at: at.clone() }),
            gauge_mm: frame.map(|frame| frame.origin_mm),
            length_mm: Some(0.0),
        });
    }
}

/// An axis lies along z of the frame before its link.
fn lay(axis: &mut AxisDraft, frame: Option<&Frame>, at: &Location) {
    axis.direction = frame.map(|frame| Located { value: frame.z(), at: at.clone() });
    if axis.motion == Motion::Rotary {
        axis.point_mm = frame.map(|frame| frame.origin_mm);
    }
}

/// θ and α in degrees, a, b and l in millimetres; every one is looked at.
fn evaluate(evaluator: &mut Evaluator<'_>, at: &Location, parameters: &[Expression; 5]) -> Option<[f64; 5]> {
    let fields = [Field::Angle, Field::Length, Field::Length, Field::Length, Field::Angle];
    let values: [Option<f64>; 5] =
        std::array::from_fn(|i| evaluator.number(at.source, &parameters[i], fields[i], Sign::Any));
    let values: Option<Vec<f64>> = values.into_iter().collect();
    values.map(|values| values.try_into().expect("five of five"))
}

/// A frame of the table, as seen in the machine's.
struct Frame {
    /// Its x, y and z as columns.
    axes: Matrix3<f64>,
    origin_mm: Vector3<f64>,
}

impl Frame {
    fn z(&self) -> Vector3<f64> {
        self.axes.column(2).into_owned()
    }

    /// The frame behind a link.
    fn beyond(self, [theta_deg, a, b, l, alpha_deg]: [f64; 5]) -> Self {
        let turned = self.axes * about_z(theta_deg.to_radians());
        let origin_mm = self.origin_mm + turned * Vector3::new(a, b, l);
        Self { axes: (turned * about_x(alpha_deg.to_radians())).map(snap), origin_mm }
    }
}

fn about_x(angle_rad: f64) -> Matrix3<f64> {
    let (s, c) = (sin_constant(angle_rad), cos_constant(angle_rad));
    Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c)
}

fn about_z(angle_rad: f64) -> Matrix3<f64> {
    let (s, c) = (sin_constant(angle_rad), cos_constant(angle_rad));
    Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)
}
