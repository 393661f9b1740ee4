//! The blocks of a controller: one an event, its lines lowered, the motions complete.

use super::lowering::Lowering;
use super::scene::Scene;
use super::{ControlledAxis, LACKING, motion, table, template};
use crate::syntax::tree::{Body, ControllerStatement, LineTemplate, TemplatePiece};
use mach_runtime::diagnostic::Diagnostic;
use mach_runtime::dialect::meaning::Meaning;
use mach_runtime::nc::dialect::{Block, Trigger};

/// The blocks, in the order of their triggers.
pub(super) fn blocks(
    lowering: &mut Lowering<'_>,
    axes: &[ControlledAxis<'_>],
    modal_groups: &[Vec<String>],
    comment: &(String, String),
) -> Vec<Block> {
    let mut blocks = Vec::new();
    for trigger in Trigger::ALL {
        let said = lowering.last(|statement| match statement {
            ControllerStatement::On { event, body } if event.value == trigger => Some((event, body)),
            _ => None,
        });
        let Some((index, (event, body))) = said else {
            report_missing_motion(lowering, trigger);
            continue;
        };
        let scene = Scene { index, trigger, axes, modal_groups, comment };
        let found_before = lowering.diagnostics.len();
        let templates = body.statements.iter().map(|line| &line.node);
        let lines = templates.map(|line| template::line(lowering, &scene, line));
        let block = Block { trigger, lines: lines.filter(|line| !motion::is_left_out(line)).collect() };
        if lowering.diagnostics.len() == found_before {
            motion::check(lowering, index, &block, axes, &event.span);
        }
        check_codes(lowering, index, body);
        blocks.push(block);
    }
    blocks
}

fn report_missing_motion(lowering: &mut Lowering<'_>, trigger: Trigger) {
    if matches!(trigger, Trigger::Rapid | Trigger::Feed) {
        let message = format!("the controller `{}` has no block `on {}`", lowering.controller.name, trigger.name());
        let place = lowering.controller.at.clone();
        lowering.diagnostics.push(Diagnostic::error(&LACKING, message).at(place, "cannot write the motion"));
    }
}

/// A code that a block prints must have been given.
fn check_codes(lowering: &mut Lowering<'_>, index: usize, body: &Body<LineTemplate>) {
    let members = table::members(lowering);
    let said = |pick: fn(Meaning) -> bool| members.iter().any(|(_, member)| pick(member.meaning.0));
    let lacking = [
        ("offset", "group offset { 1 \"G54\" }", said(|it| it == Meaning::Offset)),
        ("units", "group units { mm \"G21\" inch \"G20\" }", said(|it| matches!(it, Meaning::Units(_)))),
        ("feed_mode", "group feed { minute \"G94\" }", said(|it| matches!(it, Meaning::FeedMode(_)))),
    ];
    for piece in body.statements.iter().flat_map(|line| &line.node.pieces) {
        let TemplatePiece::Placeholder { name, .. } = &piece.value else { continue };
        if let Some((_, example, _)) = lacking.iter().find(|(known, _, said)| known == name && !said) {
            let message = format!("the controller does not say what `{{{name}}}` is");
            lowering.report(&LACKING, message, index, &piece.span, format!("needs a statement such as `{example}`"));
        }
    }
}
