//! Settings: feed, spindle, coolant, units, tools.

use crate::cl::argument::shortened;
use crate::cl::range::out_of_range;
use crate::cl::record::Record;
use crate::cl::words::closest;
use crate::diagnostic::{Code, Diagnostic, Suggestion};
use crate::toolpath::{Command, Coolant, Feed, Spindle};
use crate::unit::LengthUnit;

/// The greatest feed, spindle speed and dwell that are believed.
const GREATEST_SETTING: f64 = 1e7;

/// A word that the record does not have.
pub(super) static UNKNOWN_WORD: Code = Code {
    id: "E1014",
    title: "a record has a word that is not known there",
    explanation: "\
Words such as units, senses and modes are fixed for each record:

    FEDRAT/MMPM,250.0        MMPM IPM MMPR IPR
    SPINDL/RPM,8000,CLW      RPM CLW CCLW ON OFF
    COOLNT/FLOOD             ON OFF FLOOD MIST THRU
    UNITS/MM                 MM INCHES
",
};

/// Inch feeds with lengths that are taken as millimetres.
pub(super) static MIXED_UNITS: Code = Code {
    id: "W1003",
    title: "feed in inches, lengths in millimetres",
    explanation: "\
The feed is in inches a minute or a revolution, the file has no UNITS record, and lengths are taken as millimetres. CLSF of
NX does not say its unit: if the part is in inches, give the option

    --cl-units inch
",
};

/// A unit of lengths that comes late.
pub(super) static OTHER_UNITS: Code = Code {
    id: "W1004",
    title: "the unit of lengths changes behind the first motion",
    explanation: "\
A UNITS record gives another unit than the motion before it was read in. What follows is read in the new unit, what came
before is not read again. If all of the file is in one unit, UNITS belongs before the first motion.
",
};

/// How a feed is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FeedUnit {
    MmPerMinute,
    MmPerRevolution,
    InchPerMinute,
    InchPerRevolution,
}

const FEED_UNITS: [(&str, FeedUnit); 4] = [
    ("MMPM", FeedUnit::MmPerMinute),
    ("MMPR", FeedUnit::MmPerRevolution),
    ("IPM", FeedUnit::InchPerMinute),
    ("IPR", FeedUnit::InchPerRevolution),
];

impl FeedUnit {
    pub(super) fn is_inch(self) -> bool {
        matches!(self, Self::InchPerMinute | Self::InchPerRevolution)
    }

    /// The feed unit that goes with a unit of length.
    pub(super) fn per_minute(length: LengthUnit) -> Self {
        match length {
            LengthUnit::Millimetre => Self::MmPerMinute,
            LengthUnit::Inch => Self::InchPerMinute,
        }
    }

    fn feed(self, value: f64) -> Feed {
        match self {
            Self::MmPerMinute => Feed::PerMinute(value),
            Self::MmPerRevolution => Feed::PerRevolution(value),
            Self::InchPerMinute => Feed::PerMinute(LengthUnit::Inch.mm() * value),
            Self::InchPerRevolution => Feed::PerRevolution(LengthUnit::Inch.mm() * value),
        }
    }
}

/// `FEDRAT/value[,unit]` or `FEDRAT/unit,value`; `last` holds where no unit is given.
pub(super) fn feed(record: &Record, last: FeedUnit) -> Result<(Feed, FeedUnit), Diagnostic> {
    let known = |index| FEED_UNITS.iter().find(|entry| entry.0 == record.argument(index)).map(|entry| entry.1);
    let (unit, index) = match (record.len(), known(0), known(1)) {
        (1, None, _) => (last, 0),
        (2, Some(unit), _) => (unit, 1),
        (2, None, Some(unit)) => (unit, 0),
        (2, None, None) => {
            let index = usize::from(!starts_word(record.argument(0)));
            return Err(unknown_word(record, index, &FEED_UNITS.map(|entry| entry.0)));
        }
        _ => return Err(record.missing(2, "expected a feed rate and its unit")),
    };
    let value = positive(record, index, "a feed rate is positive")?;
    Ok((unit.feed(value), unit))
}

/// `SPINDL/…`: speed and words in any order.
pub(super) fn spindle(record: &Record) -> Result<Command, Diagnostic> {
    const WORDS: [&str; 5] = ["RPM", "CLW", "CCLW", "ON", "OFF"];
    let mut speed = None;
    let mut sense = Spindle::Clockwise;
    for index in 0..record.len() {
        match record.argument(index) {
            "RPM" | "ON" | "CLW" => {}
            "CCLW" => sense = Spindle::Counterclockwise,
            "OFF" if record.len() == 1 => return Ok(Command::SpindleOff),
            "OFF" => return Err(record.missing(index, "`OFF` stands alone")),
            word if starts_word(word) => return Err(unknown_word(record, index, &WORDS)),
            _ if speed.is_some() => return Err(record.missing(index, "expected one speed")),
            _ => speed = Some(positive(record, index, "a speed is positive")?),
        }
    }
    match speed {
        Some(speed_per_min) => Ok(Command::SpindleOn(sense, speed_per_min)),
        None => Err(record.missing(record.len(), "expected a speed, or `OFF`")),
    }
}

/// `COOLNT/…`.
pub(super) fn coolant(record: &Record) -> Result<Command, Diagnostic> {
    match only_argument(record)? {
        "ON" | "FLOOD" => Ok(Command::CoolantOn(Coolant::Flood)),
        "MIST" => Ok(Command::CoolantOn(Coolant::Mist)),
        "THRU" => Ok(Command::CoolantOn(Coolant::Through)),
        "OFF" => Ok(Command::CoolantOff),
        _ => Err(unknown_word(record, 0, &["ON", "OFF", "FLOOD", "MIST", "THRU"])),
    }
}

/// `UNITS/MM` or `UNITS/INCHES`.
pub(super) fn units(record: &Record) -> Result<LengthUnit, Diagnostic> {
    match only_argument(record)? {
        "MM" => Ok(LengthUnit::Millimetre),
        "INCHES" | "INCH" | "IN" => Ok(LengthUnit::Inch),
        _ => Err(unknown_word(record, 0, &["MM", "INCHES"])),
    }
}

/// `LOAD/TOOL,n[,ADJUST,register]`.
pub(super) fn load(record: &Record) -> Result<Command, Diagnostic> {
    if record.argument(0) != "TOOL" {
        return Err(unknown_word(record, 0, &["TOOL"]));
    }
    let number = whole(record, 1)?;
    let register = match (record.len(), record.argument(2)) {
        (2, _) => None,
        (4, "ADJUST") => Some(whole(record, 3)?),
        (4, _) => return Err(unknown_word(record, 2, &["ADJUST"])),
        _ => return Err(record.missing(4, "expected `TOOL`, a number, and perhaps `ADJUST` and a register")),
    };
    Ok(Command::Tool { number, register })
}

/// `DELAY/[DWELL,]seconds`.
pub(super) fn dwell(record: &Record) -> Result<Command, Diagnostic> {
    let index = usize::from(record.argument(0) == "DWELL");
    if let Some(extra) = (0..record.len()).find(|at| *at != index && !(*at == 0 && index == 1)) {
        return Err(unknown_word(record, extra, &["DWELL"]));
    }
    Ok(Command::Dwell(positive(record, index, "a dwell is positive")?))
}

/// `TOOL PATH/operation[,TOOL,tool]`.
pub(super) fn operation(record: &Record) -> Command {
    let tool = (1..record.len()).rev().find(|index| record.argument(*index) == "TOOL");
    match tool {
        Some(at) => {
            Command::Operation { name: record.name(0..at), tool: record.name(at + 1..record.len().max(at + 2)) }
        }
        None => Command::Operation { name: record.name(0..record.len()), tool: String::new() },
    }
}

/// The text of `PPRINT text`, `PPRINT/text`, `PPRINT / text`.
pub(super) fn message(record: &Record) -> String {
    let text = record.name(0..1);
    let text = text.trim_start();
    text.strip_prefix('/').unwrap_or(text).trim_start().to_owned()
}

/// The argument of a record that has one, or none.
fn only_argument(record: &Record) -> Result<&str, Diagnostic> {
    if record.len() > 1 { Err(record.missing(1, "expected nothing more")) } else { Ok(record.argument(0)) }
}

fn starts_word(argument: &str) -> bool {
    argument.starts_with(|first: char| first.is_ascii_alphabetic())
}

fn positive(record: &Record, index: usize, text: &str) -> Result<f64, Diagnostic> {
    let value = record.number(index)?;
    if value > 0.0 && value <= GREATEST_SETTING { Ok(value) } else { Err(out_of_range(record, index, text)) }
}

fn whole(record: &Record, index: usize) -> Result<u64, Diagnostic> {
    let value = record.number(index)?;
    let usual = (0.0..=GREATEST_SETTING).contains(&value) && value.fract() == 0.0;
    if usual { Ok(value as u64) } else { Err(out_of_range(record, index, "expected a whole number")) }
}

fn unknown_word(record: &Record, index: usize, known: &[&str]) -> Diagnostic {
    let word = record.argument(index);
    if word.is_empty() {
        return record.missing(index, &format!("expected one of {}", known.join(", ")));
    }
    let message = format!("`{}` is not known in {}", shortened(word), record.word());
    let error = Diagnostic::error(&UNKNOWN_WORD, message);
    let error = error.at(record.place_of(index), format!("expected one of {}", known.join(", ")));
    match closest(word, known.iter().copied()) {
        Some(near) => error.suggest(Suggestion {
            text: format!("did you mean `{near}`?"),
            place: record.place_of(index),
            replacement: near.to_owned(),
        }),
        None => error,
    }
}
