//! A controller that prints `{retract}` for a machine without an end to retract to. Looks at the finished tables.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::Draft;
use crate::model::machine::Model;
use crate::model::source::{Located, Location};
use crate::model::tables;
use crate::syntax::tree::{ControllerStatement, TemplatePiece};
use mach_runtime::machine::Retract;

/// An axis without the end that `{retract}` stands for.
pub(crate) static NO_WAY_OUT: Code = Code {
    id: "W0554",
    title: "there is no travel limit to retract to",
    explanation: "\
`{retract}` stands for the axis word that takes the tool out: the linear axis that moves most along the tool axis with
every axis at zero, at the end of its travel that is farthest from the workpiece, in machine coordinates. An axis without
limits has no such end, and `{retract}` is zero, where many controls have it.

    linear Z along +z                          // how far is up?
    linear Z along +z travel -450 .. 60        // `{retract}` is Z60.

Give the axis its travel, counted as the control counts it, or say what is to be printed:

    controller syntec {
        retract \"Z0.\"
    }
",
};

/// The first `{retract}` of the controller's, if the machine has no end for it.
pub(crate) fn check(
    model: &Model,
    draft: &Draft<'_>,
    statements: &[Located<ControllerStatement>],
) -> Option<Diagnostic> {
    if statements.iter().any(|statement| matches!(statement.value, ControllerStatement::Retract(_))) {
        return None;
    }
    let at = statements.iter().find_map(placeholder)?;
    let axes = tables::machine(model).axes;
    let retract = Retract::of(&axes).filter(|retract| retract.end_mm.is_infinite())?;
    let name = &axes[retract.axis].name;
    let end = if retract.is_upper { "upper" } else { "lower" };
    let message = format!("`{{retract}}` needs the {end} end of the travel of {name}");
    let diagnostic = super::warning(draft, &NO_WAY_OUT, message, &at, "prints zero here");
    let axis = draft.axis(name).map(|(_, axis)| draft.sources.place(&axis.name.at));
    Some(axis.into_iter().fold(diagnostic, |diagnostic, at| diagnostic.at(at, "has no limits")))
}

/// Where the statement says `{retract}`.
fn placeholder(statement: &Located<ControllerStatement>) -> Option<Location> {
    let ControllerStatement::On { body, .. } = &statement.value else { return None };
    let mut pieces = body.statements.iter().flat_map(|line| &line.node.pieces);
    let said =
        pieces.find(|piece| matches!(&piece.value, TemplatePiece::Placeholder { name, .. } if name == "retract"));
    said.map(|piece| statement.at.with(&piece.span))
}
