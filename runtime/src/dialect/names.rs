//! How a controller's description names the meanings.

use super::meaning::{
    CentreMode, Coolant, Distance, FeedMode, Meaning, MotionCode, Once, PathMode, Plane, Side, Spindle, Switch, Wrap,
};
use super::table::FormMeaning;
use crate::unit::LengthUnit;

/// The group of a meaning, its name there, and what it is. What happens once is in the group `once`; the members of `offset` are
/// numbers.
pub const NAMES: &[(&str, &str, Meaning)] = &[
    ("motion", "rapid", Meaning::Motion(MotionCode::Rapid)),
    ("motion", "line", Meaning::Motion(MotionCode::Line)),
    ("motion", "arc clockwise", Meaning::Motion(MotionCode::ArcClockwise)),
    ("motion", "arc counterclockwise", Meaning::Motion(MotionCode::ArcCounterclockwise)),
    ("plane", "xy", Meaning::Plane(Plane::Xy)),
    ("plane", "zx", Meaning::Plane(Plane::Zx)),
    ("plane", "yz", Meaning::Plane(Plane::Yz)),
    ("distance", "absolute", Meaning::Distance(Distance::Absolute)),
    ("distance", "incremental", Meaning::Distance(Distance::Incremental)),
    ("units", "mm", Meaning::Units(LengthUnit::Millimetre)),
    ("units", "inch", Meaning::Units(LengthUnit::Inch)),
    ("feed", "minute", Meaning::FeedMode(FeedMode::PerMinute)),
    ("feed", "revolution", Meaning::FeedMode(FeedMode::PerRevolution)),
    ("feed", "inverse", Meaning::FeedMode(FeedMode::Inverse)),
    ("centre", "from start", Meaning::Centre(CentreMode::FromStart)),
    ("centre", "absolute", Meaning::Centre(CentreMode::Absolute)),
    ("side", "off", Meaning::Side(Side::Off)),
    ("side", "left", Meaning::Side(Side::Left)),
    ("side", "right", Meaning::Side(Side::Right)),
    ("length", "off", Meaning::Length(Switch::Off)),
    ("length", "on", Meaning::Length(Switch::On)),
    ("tip", "off", Meaning::Tip(Switch::Off)),
    ("tip", "on", Meaning::Tip(Switch::On)),
    ("frame", "off", Meaning::Frame(Switch::Off)),
    ("frame", "on", Meaning::Frame(Switch::On)),
    ("cycle", "off", Meaning::Cycle(Switch::Off)),
    ("cycle", "on", Meaning::Cycle(Switch::On)),
    ("path", "exact", Meaning::Path(PathMode::Exact)),
    ("path", "blend", Meaning::Path(PathMode::Blend)),
    ("wrap", "counted", Meaning::Wrap(Wrap::Counted)),
    ("wrap", "shortest", Meaning::Wrap(Wrap::Shortest)),
    ("spindle", "off", Meaning::Spindle(Spindle::Off)),
    ("spindle", "clockwise", Meaning::Spindle(Spindle::Clockwise)),
    ("spindle", "counterclockwise", Meaning::Spindle(Spindle::Counterclockwise)),
    ("coolant", "off", Meaning::Coolant(Coolant::Off)),
    ("coolant", "flood", Meaning::Coolant(Coolant::Flood)),
    ("coolant", "mist", Meaning::Coolant(Coolant::Mist)),
    ("coolant", "through", Meaning::Coolant(Coolant::Through)),
    ("once", "machine coordinates", Meaning::Once(Once::MachineCoordinates)),
    ("once", "reference point", Meaning::Once(Once::ReferencePoint)),
    ("once", "retract along tool", Meaning::Once(Once::RetractAlongTool)),
    ("once", "pole", Meaning::Once(Once::Pole)),
    ("once", "stock", Meaning::Once(Once::Stock)),
    ("once", "tool change", Meaning::Once(Once::ToolChange)),
    ("once", "preselect", Meaning::Once(Once::Preselect)),
    ("once", "dwell", Meaning::Once(Once::Dwell)),
    ("once", "stop", Meaning::Once(Once::Stop)),
    ("once", "optional stop", Meaning::Once(Once::OptionalStop)),
    ("once", "end", Meaning::Once(Once::End)),
    ("once", "program", Meaning::Once(Once::Program)),
    ("once", "program end", Meaning::Once(Once::ProgramEnd)),
    ("once", "message", Meaning::Once(Once::Message)),
];

/// The groups, in their order.
pub fn groups() -> impl Iterator<Item = &'static str> {
    let first = |index: &usize| *index == 0 || NAMES[index - 1].0 != NAMES[*index].0;
    (0..NAMES.len()).filter(first).map(|index| NAMES[index].0).chain(["offset"])
}

/// The names in a group.
pub fn members(group: &str) -> impl Iterator<Item = &'static str> {
    NAMES.iter().filter(move |(its, ..)| *its == group).map(|(_, member, _)| *member)
}

/// What a name means in a group; the members of `offset` are whole numbers.
pub fn meaning(group: &str, member: &str) -> Option<(Meaning, Option<u32>)> {
    if group == "offset" {
        return member.parse().ok().map(|number| (Meaning::Offset, Some(number)));
    }
    NAMES.iter().find(|(its, name, _)| (*its, *name) == (group, member)).map(|(.., meaning)| (*meaning, None))
}

/// The name of a meaning in its group; an offset, which has a number, and what is plain have none.
pub fn name(meaning: Meaning) -> Option<&'static str> {
    NAMES.iter().find(|(.., its)| *its == meaning).map(|(_, member, _)| *member)
}

/// How the number of an axis word can be meant, by name.
pub const FORMS: [(&str, FormMeaning); 5] = [
    ("absolute", FormMeaning::Absolute),
    ("incremental", FormMeaning::Incremental),
    ("shortest", FormMeaning::Shortest),
    ("positive", FormMeaning::Positive),
    ("negative", FormMeaning::Negative),
];

/// The name of a form.
pub fn form_name(form: FormMeaning) -> &'static str {
    let named = FORMS.iter().find(|(_, meaning)| *meaning == form);
    named.map(|(name, _)| *name).expect("every form has a name")
}
