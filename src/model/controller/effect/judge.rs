//! Whether a block has done what its event says, and nothing else that lasts.

use super::run::Run;
use super::sample::{DWELL_S, ROUNDED, SPEED_RPM, TARGET, TOOL, feed_mm};
use mach_runtime::dialect::meaning::{Coolant, Distance, FeedMode, Meaning, Spindle, Switch};
use mach_runtime::motion::{Coolants, Event, Feed, Law, State, What};
use mach_runtime::nc::dialect::{Dialect, Trigger};

/// What is wrong with what a block has done.
pub(super) fn judge(run: &Run, dialect: &Dialect, (trigger, mode): (Trigger, FeedMode)) -> Option<String> {
    left_behind(run, dialect, (trigger, mode))
        .or_else(|| shifted(run, trigger))
        .or_else(|| events(run, trigger))
        .or_else(|| if trigger.is_motion() { motion(run, dialect, (trigger, mode)) } else { no_motion(run, trigger) })
        .or_else(|| switched(run, trigger))
}

/// What no block may leave behind, and what the head of a program must have said.
fn left_behind(run: &Run, dialect: &Dialect, (trigger, mode): (Trigger, FeedMode)) -> Option<String> {
    let after = &run.after;
    let can_say = |pick: fn(&Meaning) -> bool| dialect.table.patterns.iter().flat_map(|it| &it.meanings).any(pick);
    let is_unsaid = |said: bool, pick: fn(&Meaning) -> bool| trigger == Trigger::Start && !said && can_say(pick);
    if after.distance == Some(Distance::Incremental) {
        return Some("leaves incremental words in force".to_owned());
    }
    if is_unsaid(after.distance.is_some(), |it| matches!(it, Meaning::Distance(_))) {
        return Some("does not say that words are absolute".to_owned());
    }
    if is_unsaid(after.units.is_some(), |it| matches!(it, Meaning::Units(_))) {
        return Some("does not say the unit of length".to_owned());
    }
    if is_unsaid(after.feed_mode.is_some(), |it| matches!(it, Meaning::FeedMode(_))) {
        return Some("does not say what the feed counts".to_owned());
    }
    if after.units.is_some_and(|units| units != dialect.units) {
        return Some("leaves another unit of length in force than the program's".to_owned());
    }
    if trigger != Trigger::Start && after.feed_mode != Some(mode) {
        return Some("leaves another kind of feed in force".to_owned());
    }
    let State { tip, side, .. } = after.state;
    let on = Some(Switch::On);
    if tip || after.frame == on || after.cycle == on || side != State::default().side {
        return Some("leaves a function of the control on that the writer does not know of".to_owned());
    }
    None
}

/// What words count from is changed only where a program begins or ends, an operation or a tool; a tool's length comes into
/// force on its approach.
fn shifted(run: &Run, trigger: Trigger) -> Option<String> {
    use Trigger::{Approach, ApproachFeed, End, Operation, Start, Tool};
    let (before, after) = (&run.before.state, &run.after.state);
    if before.offset != after.offset && !matches!(trigger, Start | Operation | Tool | End) {
        return Some("leaves another work offset in force".to_owned());
    }
    let is_as_long = before.length_register == after.length_register;
    (!is_as_long && !matches!(trigger, Start | Tool | Approach | ApproachFeed | End))
        .then(|| "leaves another length of the tool in force".to_owned())
}

fn events(run: &Run, trigger: Trigger) -> Option<String> {
    let found: Vec<Event> = run.motion.items().iter().filter_map(|item| event(&item.what)).collect();
    let wanted: &[Event] = match trigger {
        Trigger::Tool => &[Event::ToolChange(TOOL as u32)],
        Trigger::Stop => &[Event::Stop],
        Trigger::OptionalStop => &[Event::OptionalStop],
        Trigger::Dwell => &[Event::Dwell(DWELL_S)],
        Trigger::End => &[Event::End],
        _ => &[],
    };
    if found == wanted {
        return None;
    }
    let what = |events: &[Event]| events.iter().map(|event| named(*event)).collect::<Vec<_>>().join(", ");
    Some(match (found.is_empty(), wanted.is_empty()) {
        (true, _) => format!("does nothing of what it says: there should be {}", what(wanted)),
        (_, true) => format!("does more than it says: {}", what(&found)),
        _ => format!("does {} instead of {}", what(&found), what(wanted)),
    })
}

fn event(what: &What) -> Option<Event> {
    match what {
        What::Event(event) => Some(*event),
        What::Move(_) => None,
    }
}

fn named(event: Event) -> String {
    match event {
        Event::ToolChange(tool) => format!("a change to tool {tool}"),
        Event::Dwell(seconds) => format!("a dwell of {seconds} s"),
        Event::Stop => "a stop".to_owned(),
        Event::OptionalStop => "an optional stop".to_owned(),
        Event::End => "the end of the program".to_owned(),
    }
}

/// A motion gets all axes where they are sent, the way it says, and with its feed.
fn motion(run: &Run, dialect: &Dialect, (trigger, mode): (Trigger, FeedMode)) -> Option<String> {
    let is_feed = trigger.is_feed();
    let moves: Vec<_> = run
        .motion
        .items()
        .iter()
        .filter_map(|item| match item.what {
            What::Move(it) => Some((it, run.motion.state(item))),
            What::Event(_) => None,
        })
        .collect();
    if let Some((it, _)) = moves.iter().find(|(it, _)| (it.law == Law::Rapid) == is_feed) {
        let is = if it.law == Law::Rapid { "moves in rapid traverse" } else { "moves at feed" };
        return Some(is.to_owned());
    }
    if moves.iter().any(|(it, _)| it.is_machine || matches!(it.law, Law::Arc(_))) {
        return Some("does not move on a straight line to the programmed point".to_owned());
    }
    let is_there =
        run.joints_at_end.as_ref().is_some_and(|joints| joints.iter().all(|it| (it - TARGET).abs() < ROUNDED));
    if !is_there {
        return Some("does not take every axis where it is sent".to_owned());
    }
    if is_feed && moves.iter().any(|(_, state)| !is_fed(state.feed, dialect, mode)) {
        return Some("does not cut at the feed that it is given".to_owned());
    }
    (!is_feed && run.after.feed != run.before.feed)
        .then(|| "has a feed, which the next cut would take for its own".to_owned())
}

/// Whether a feed is that of the trial. A picture without decimals rounds it up to twice what it is; what was in force before is
/// far from it.
fn is_fed(feed: Option<Feed>, dialect: &Dialect, mode: FeedMode) -> bool {
    let found = match (feed, mode) {
        (Some(Feed::PerMinute(found)), FeedMode::PerMinute) => found,
        (Some(Feed::PerRevolution(found)), FeedMode::PerRevolution) => found,
        _ => return false,
    };
    0.0 < found && found <= 2.0 * feed_mm(dialect)
}

/// Another block moves only to the way out, and only where that is expected.
fn no_motion(run: &Run, trigger: Trigger) -> Option<String> {
    let moves = run.motion.items().iter().filter_map(|item| match item.what {
        What::Move(it) => Some(it),
        What::Event(_) => None,
    });
    let may_move = matches!(trigger, Trigger::Start | Trigger::End | Trigger::Tool | Trigger::Operation);
    let mut any = false;
    for it in moves {
        any = true;
        if !may_move {
            return Some("moves an axis".to_owned());
        }
        if !it.is_machine || it.law != Law::Rapid {
            return Some("goes to its way out otherwise than in rapid traverse and machine coordinates".to_owned());
        }
    }
    if !any && trigger != Trigger::Start && run.after.motion != run.before.motion {
        return Some("has the code of a motion, which the next motion would take for its own".to_owned());
    }
    (run.after.feed != run.before.feed && trigger != Trigger::Start)
        .then(|| "has a feed, which the next cut would take for its own".to_owned())
}

/// Spindle and coolant are switched by their own events; others may switch them off where the writer has them on again before
/// the next cut.
fn switched(run: &Run, trigger: Trigger) -> Option<String> {
    let (before, after) = (&run.before.state, &run.after.state);
    let spindle = match trigger {
        Trigger::SpindleClockwise => Some((Spindle::Clockwise, SPEED_RPM)),
        Trigger::SpindleCounterclockwise => Some((Spindle::Counterclockwise, SPEED_RPM)),
        Trigger::SpindleOff => Some((Spindle::Off, after.speed_rpm)),
        _ if may_switch_off(trigger) && after.spindle == Spindle::Off => None,
        _ => Some((before.spindle, before.speed_rpm)),
    };
    if spindle.is_some_and(|wanted| wanted != (after.spindle, after.speed_rpm)) {
        return Some(format!("leaves the spindle {}", turning(after.spindle, after.speed_rpm)));
    }
    let coolant = match trigger {
        Trigger::CoolantFlood => before.coolant.with(Coolant::Flood),
        Trigger::CoolantMist => before.coolant.with(Coolant::Mist),
        Trigger::CoolantThrough => before.coolant.with(Coolant::Through),
        Trigger::CoolantOff => Coolants::OFF,
        _ if may_switch_off(trigger) && after.coolant == Coolants::OFF => Coolants::OFF,
        _ => before.coolant,
    };
    (coolant != after.coolant).then(|| "switches the coolant otherwise than it says".to_owned())
}

fn may_switch_off(trigger: Trigger) -> bool {
    use Trigger::{End, Operation, OptionalStop, Start, Stop, Tool};
    matches!(trigger, Start | End | Tool | Operation | Stop | OptionalStop)
}

fn turning(spindle: Spindle, speed_rpm: f64) -> String {
    match spindle {
        Spindle::Off => "standing".to_owned(),
        Spindle::Clockwise => format!("turning clockwise at {speed_rpm} revolutions a minute"),
        Spindle::Counterclockwise => format!("turning counterclockwise at {speed_rpm} revolutions a minute"),
    }
}
