//! The text of a block with sample values.

use super::super::ControlledAxis;
use mach_runtime::dialect::meaning::FeedMode;
use mach_runtime::machine::{Axis, Motion, Rule, Travel, Written};
use mach_runtime::nc::dialect::{Block, Dialect, Trigger};
use mach_runtime::nc::writer::{Values, Writer};
use mach_runtime::toolpath::{Approach, Feed, LoadedTool};
use mach_runtime::unit::LengthUnit;

/// The number of the tool and of its register, revolutions a minute and a dwell in seconds, in the trial.
pub(super) const TOOL: u64 = 7;
pub(super) const SPEED_RPM: f64 = 1234.0;
pub(super) const DWELL_S: f64 = 1.5;

/// Where the axes of the trial go, how far words in inches may round that, and where they come from.
pub(super) const TARGET: f64 = 0.5;
pub(super) const ROUNDED: f64 = 0.01;
pub(super) const START: f64 = 2.0;

/// The axes of the trial: each can be told from where it was, and the last linear one is the way out.
pub(super) fn axes(named: &[ControlledAxis<'_>]) -> Vec<Axis> {
    let last = named.iter().rposition(|axis| axis.motion == Motion::Linear);
    let axis = |(index, axis): (usize, &ControlledAxis<'_>)| Axis {
        name: axis.name.to_owned(),
        motion: axis.motion,
        travel: Travel { lower: -5.0, upper: 5.0 },
        written: Written::Unwound,
        zero: 0.0,
        rule: Rule::Pose,
        length_share: if Some(index) == last { 1.0 } else { 0.0 },
        rapid_per_min: None,
    };
    named.iter().enumerate().map(axis).collect()
}

/// The kinds of feed that programs of the dialect have.
pub(super) fn feed_modes(dialect: &Dialect) -> impl Iterator<Item = FeedMode> {
    let per_revolution = dialect.codes.per_revolution.as_ref().map(|_| FeedMode::PerRevolution);
    [FeedMode::PerMinute].into_iter().chain(per_revolution)
}

/// The text of a block with sample values and this kind of feed; none where it cannot be printed, which is another's business.
pub(super) fn print(dialect: &Dialect, axes: &[Axis], block: &Block, mode: FeedMode) -> Option<String> {
    let block = Block { trigger: plain(block.trigger), ..block.clone() };
    let mut text = Vec::new();
    let cut = Approach::Feed(Some(feed(dialect, mode)));
    match block.trigger {
        Trigger::Rapid => {
            writer(dialect, axes, vec![block]).motion(Approach::Rapid, &to(axes), 0.0, &mut text).map(drop).ok()?
        }
        Trigger::Feed => writer(dialect, axes, vec![block]).motion(cut, &to(axes), 0.0, &mut text).map(drop).ok()?,
        Trigger::Start => writer(dialect, axes, vec![block]).command(Trigger::Start, &SAMPLE, &mut text).ok()?,
        trigger => {
            let mut writer = writer(dialect, axes, vec![dialect.block(Trigger::Feed)?.clone(), block]);
            writer.motion(cut, &to(axes), 0.0, &mut Vec::new()).ok()?;
            writer.command(trigger, &SAMPLE, &mut text).ok()?;
        }
    }
    Some(String::from_utf8_lossy(&text).into_owned())
}

/// A writer of these blocks, with the tool of the trial in the spindle.
fn writer(dialect: &Dialect, axes: &[Axis], blocks: Vec<Block>) -> Writer {
    let mut writer = Writer::new(Dialect { blocks, ..dialect.clone() }, axes);
    writer.load(LOADED);
    writer
}

fn to(axes: &[Axis]) -> Vec<f64> {
    vec![TARGET; axes.len()]
}

const LOADED: LoadedTool = LoadedTool { number: TOOL, register: TOOL };

const SAMPLE: Values<'_> = Values {
    program: "PROGRAM",
    machine: "MACHINE",
    operation: "OPERATION",
    tool_name: "NAME",
    text: "TEXT",
    tool: Some(LOADED),
    speed_rpm: SPEED_RPM,
    dwell_s: DWELL_S,
};

/// An approach is printed as the motion that it stands for.
fn plain(trigger: Trigger) -> Trigger {
    match trigger {
        Trigger::Approach => Trigger::Rapid,
        Trigger::ApproachFeed => Trigger::Feed,
        other => other,
    }
}

fn feed(dialect: &Dialect, mode: FeedMode) -> Feed {
    match mode {
        FeedMode::PerRevolution => Feed::PerRevolution(feed_mm(dialect)),
        FeedMode::PerMinute | FeedMode::Inverse => Feed::PerMinute(feed_mm(dialect)),
    }
}

/// A feed a minute or a revolution that any picture prints.
pub(super) fn feed_mm(dialect: &Dialect) -> f64 {
    if dialect.units == LengthUnit::Inch { 12.7 } else { 0.5 }
}
