//! The blocks of a controller: one an event, its lines lowered, the motions complete.

use super::LACKING;
use super::lowering::Lowering;
use super::template::{self, Scene};
use crate::syntax::tree::{Body, ControllerStatement, Event, LineTemplate, Span, TemplatePiece};
use mach_runtime::diagnostic::{Code, Diagnostic};
use mach_runtime::nc::dialect::{Block, Piece, Trigger};

/// A motion block that does not print the motion.
pub(super) static INCOMPLETE_MOTION: Code = Code {
    id: "E0526",
    title: "a motion block prints its words not exactly once",
    explanation: "\
`on rapid` and `on feed` print the words of the axes by `{axes}`, once; `on feed` prints the feed word by `{feed}`.

    on rapid { \"G0 {axes}\" }
    on feed  { \"G1 {axes} {feed}\" }

Without `{axes}` the machine would stand still, without `{feed}` it would cut with the last feed.
",
};

/// The blocks, in the order of their triggers.
pub(super) fn blocks(
    lowering: &mut Lowering<'_>,
    modal_groups: &[Vec<String>],
    comment: &(String, String),
) -> Vec<Block> {
    let mut blocks = Vec::new();
    for trigger in Trigger::ALL {
        let said = lowering.last(|statement| match statement {
            ControllerStatement::On { event, body } if self::trigger(event.value) == trigger => Some((event, body)),
            _ => None,
        });
        let Some((index, (event, body))) = said else {
            report_missing_motion(lowering, trigger);
            continue;
        };
        let scene = Scene { index, trigger, modal_groups, comment };
        let templates = body.statements.iter().map(|line| &line.node);
        let lines = templates.map(|line| template::line(lowering, &scene, line)).collect();
        let block = Block { trigger, lines };
        check_motion(lowering, index, &block, &event.span);
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

/// A motion prints its axes once, and a feed motion its feed.
fn check_motion(lowering: &mut Lowering<'_>, index: usize, block: &Block, span: &Span) {
    let count = |wanted: &Piece| block.lines.iter().flat_map(|line| &line.pieces).filter(|it| *it == wanted).count();
    let mut require = |name: &str, piece: &Piece| {
        let message = match count(piece) {
            0 => format!("`on {}` does not print `{{{name}}}`", block.trigger.name()),
            1 => return,
            _ => format!("`on {}` prints `{{{name}}}` more than once", block.trigger.name()),
        };
        lowering.report(&INCOMPLETE_MOTION, message, index, span, format!("exactly one `{{{name}}}` is needed"));
    };
    if matches!(block.trigger, Trigger::Rapid | Trigger::Feed) {
        require("axes", &Piece::Axes);
    }
    if block.trigger == Trigger::Feed {
        require("feed", &Piece::Feed);
    }
}

/// A code that a block prints must have been given.
fn check_codes(lowering: &mut Lowering<'_>, index: usize, body: &Body<LineTemplate>) {
    use ControllerStatement::{FeedCode, Offset, UnitsCode};
    let said = |pick: fn(&ControllerStatement) -> bool| lowering.controller.statements.iter().any(pick);
    let lacking = [
        ("offset", "offset \"G54\"", said(|it| matches!(it, Offset(_)))),
        ("units", "code units mm \"G21\" inch \"G20\"", said(|it| matches!(it, UnitsCode { .. }))),
        ("feed_mode", "code feed minute \"G94\"", said(|it| matches!(it, FeedCode { .. }))),
    ];
    for piece in body.statements.iter().flat_map(|line| &line.node.pieces) {
        let TemplatePiece::Placeholder { name, .. } = &piece.value else { continue };
        if let Some((_, example, _)) = lacking.iter().find(|(known, _, said)| known == name && !said) {
            let message = format!("the controller does not say what `{{{name}}}` is");
            lowering.report(&LACKING, message, index, &piece.span, format!("needs a statement such as `{example}`"));
        }
    }
}

/// What the runtime calls an event.
fn trigger(event: Event) -> Trigger {
    match event {
        Event::Start => Trigger::Start,
        Event::End => Trigger::End,
        Event::Operation => Trigger::Operation,
        Event::Tool => Trigger::Tool,
        Event::SpindleClockwise => Trigger::SpindleClockwise,
        Event::SpindleCounterclockwise => Trigger::SpindleCounterclockwise,
        Event::SpindleOff => Trigger::SpindleOff,
        Event::CoolantFlood => Trigger::CoolantFlood,
        Event::CoolantMist => Trigger::CoolantMist,
        Event::CoolantThrough => Trigger::CoolantThrough,
        Event::CoolantOff => Trigger::CoolantOff,
        Event::Stop => Trigger::Stop,
        Event::OptionalStop => Trigger::OptionalStop,
        Event::Dwell => Trigger::Dwell,
        Event::Message => Trigger::Message,
        Event::Rapid => Trigger::Rapid,
        Event::Feed => Trigger::Feed,
    }
}
