//! The dialect of a machine: its controller's statements, lowered for its axes.

use super::controller;
use super::draft::Draft;
use super::family::Controller;
use super::source::Location;
use crate::diagnostic::Diagnostic;
use crate::syntax::tree::Span;
use mach_runtime::nc::dialect::Dialect;

/// Lowers the statements that hold for this machine; `None` when something was wrong, which has been said, or was not understood.
pub(crate) fn dialect(
    controller: &Controller<'_>,
    draft: &Draft<'_>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<Dialect> {
    if !controller.said.lost.is_empty() || draft.may_lack_axes() {
        return None;
    }
    let (nodes, places): (Vec<_>, Vec<Location>) =
        controller.said.statements.iter().map(|statement| (statement.value.clone(), statement.at.clone())).unzip();
    let axes = draft.axes.iter().map(|axis| controller::ControlledAxis { name: &axis.name.value, motion: axis.motion });
    let axes: Vec<_> = axes.collect();
    let controller = controller::Controller {
        name: &controller.name.value.value,
        at: draft.sources.place(&controller.name.at),
        statements: &nodes,
        place: &|index: usize, span: &Span| draft.sources.place(&places[index].with(span)),
    };
    controller::lower(&controller, &axes).map_err(|found| diagnostics.extend(found)).ok()
}
