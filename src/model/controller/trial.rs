//! A trial: one motion of each kind is printed and read back, so that no program is written that cannot be proved.

use super::lowering::Lowering;
use crate::syntax::tree::{ControllerStatement, Span};
use mach_runtime::diagnostic::Code;
use mach_runtime::machine::{Axis, Motion, Rule, Travel, Written};
use mach_runtime::nc::dialect::{Dialect, Trigger};
use mach_runtime::nc::writer::Writer;
use mach_runtime::readback::ReadBack;
use mach_runtime::toolpath::{Approach, Feed, LoadedTool};
use mach_runtime::unit::LengthUnit;

/// A motion block that cannot be read back.
pub(super) static UNREADABLE_MOTION: Code = Code {
    id: "E0530",
    title: "the motion block cannot be read back",
    explanation: "\
Every program is read back and compared with the CL data. In motion blocks only words can be read (`G1`, `F500.`,
`SUPA`, `S1=3000`) and comments, and an axis word only once.

    on feed { \"G1 {axes} {feed} #1=5\" }         // an assignment is no word
    on feed { \"G1 {axes} X0. {feed}\" }          // X twice

Put anything else into the blocks of other events.
",
};

/// Reports a kind of motion whose block cannot be read back.
pub(super) fn read_back(lowering: &mut Lowering<'_>, dialect: &Dialect) {
    let feed = Approach::Feed(Some(Feed::PerMinute(one_half_mm(dialect))));
    for (trigger, approach) in [
        (Trigger::Rapid, Approach::Rapid),
        (Trigger::Feed, feed),
        (Trigger::Approach, Approach::Rapid),
        (Trigger::ApproachFeed, feed),
    ] {
        let blocks = dialect.block(trigger).into_iter().cloned().collect();
        let Some(text) = unreadable(&Dialect { blocks, ..dialect.clone() }, approach) else { continue };
        let said = lowering.last(|statement| match statement {
            ControllerStatement::On { event: said, .. } if said.value == trigger => Some(&said.span),
            _ => None,
        });
        let (index, span): (usize, &Span) = said.expect("the dialect has this block of the statement");
        let message = format!("the text of this motion cannot be read back: `{}`", text.trim_end());
        lowering.report(&UNREADABLE_MOTION, message, index, span, "only words, and each axis once");
    }
}

/// The text of a motion by the dialect's only block, if it cannot be read.
fn unreadable(dialect: &Dialect, approach: Approach) -> Option<String> {
    let axes: Vec<Axis> = dialect.axes.iter().map(|word| any_axis(&word.name)).collect();
    let joints = vec![0.5; axes.len()];
    let mut text = Vec::new();
    let mut writer = Writer::new(dialect.clone(), &axes);
    writer.load(LoadedTool { number: 1, register: 1 });
    writer.motion(approach, &joints, 0.0, &mut text).ok()?;
    let unreadable = ReadBack::new(dialect, &axes, 0.0).read(&text, 0..text.len()).is_err();
    unreadable.then(|| String::from_utf8_lossy(&text).into_owned())
}

/// A feed that any picture prints.
fn one_half_mm(dialect: &Dialect) -> f64 {
    if dialect.units == LengthUnit::Inch { 12.7 } else { 0.5 }
}

fn any_axis(name: &str) -> Axis {
    Axis {
        name: name.to_owned(),
        motion: Motion::Rotary,
        travel: Travel::UNLIMITED,
        written: Written::Unwound,
        zero: 0.0,
        rule: Rule::Pose,
        length_share: 0.0,
        rapid_per_min: None,
    }
}
