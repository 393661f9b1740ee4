//! A controller's description to a dialect, without a machine around it.

use mach_runtime::diagnostic::Diagnostic;
use mach_runtime::machine::Motion;
use mach_runtime::nc::dialect::Dialect;
use machc::model::controller::{ControlledAxis, Controller, lower};
use machc::syntax::parse::parse;
use machc::syntax::place::place;
use machc::syntax::tree::{ControllerStatement, Item};

const FILE: &str = "controller.mach";

/// The dialect of the last controller in `text`, for a machine with these axes; A, B and C are rotary.
pub(crate) fn dialect(text: &str, axes: &[&str]) -> Result<Dialect, Vec<Diagnostic>> {
    let file = parse(FILE, text).whole()?;
    let mut controllers = file.body.statements.into_iter().filter_map(|item| match item.node {
        Item::Controller(controller) => Some(controller),
        _ => None,
    });
    let controller = controllers.next_back().expect("a controller is described");
    let statements: Vec<ControllerStatement> = controller.body.statements.into_iter().map(|it| it.node).collect();
    let request = Controller {
        name: &controller.name.value,
        at: place(FILE, text, &controller.name.span),
        statements: &statements,
        place: &|_, span| place(FILE, text, span),
    };
    let motion = |name: &str| if name.starts_with(['A', 'B', 'C']) { Motion::Rotary } else { Motion::Linear };
    let axes: Vec<ControlledAxis<'_>> = axes.iter().map(|name| ControlledAxis { name, motion: motion(name) }).collect();
    lower(&request, &axes)
}
