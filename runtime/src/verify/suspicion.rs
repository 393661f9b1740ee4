//! What is suspicious in a program: legal, and probably not meant.

use crate::diagnostic::{Code, Diagnostic, Place};

/// A kind of suspicion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Suspicion {
    StandingSpindle,
    NoFeed,
    PowerOn(&'static str),
    LongWay(usize),
    BelowTheCut,
    OutOfTravel(usize),
    BehindTheEnd,
}

/// Where it was met first, and how often.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Met {
    pub(super) line: u64,
    pub(super) blocks: u64,
}

static STANDING_SPINDLE: Code = Code {
    id: "W1201",
    title: "a cut while the spindle stands",
    explanation: "\
A block moves at feed while nothing has switched the spindle on, or something has switched it off: a tool change, say, after
which the speed is not said again.",
};

static NO_FEED: Code = Code {
    id: "W1202",
    title: "a cut without a feed",
    explanation: "\
A block moves at feed before any feed word, or behind a code that changes what the feed counts. Most controls stop there with an
alarm, others go on with the feed of the program before.",
};

static POWER_ON: Code = Code {
    id: "W1203",
    title: "the program takes for granted what the control does when it is switched on",
    explanation: "\
The program moves before it has said whether words are absolute, what the unit of length is, or what the feed counts. It then
means what the control was left at, or what its parameters say.",
};

static LONG_WAY: Code = Code {
    id: "W1204",
    title: "a rotary axis turns by more than half a turn in one block",
    explanation: "\
The axis could get to the same angle the other way round, on a shorter way. In a cut the tool sweeps over the part.",
};

static BELOW_THE_CUT: Code = Code {
    id: "W1205",
    title: "a rapid motion ends deeper than the cut before it",
    explanation: "\
Along the tool, a block in rapid traverse goes below where the last cut was. There may be material.",
};

static OUT_OF_TRAVEL: Code = Code {
    id: "W1206",
    title: "the program goes beyond the travel of an axis",
    explanation: "\
The control would stop at the limit. Either the program is for another set-up, or the machine file's `zero`, tool length or
`travel` is not that of the machine.",
};

static BEHIND_THE_END: Code = Code {
    id: "W1207",
    title: "text behind the end of the program",
    explanation: "\
The program says that it is over, and blocks or other text stand behind that, comments and the tape's mark aside. The control does
not run it, and neither does `verify`: nothing of it is in what is told. A second program of the same file is looked at in a file of
its own.",
};

/// All of them.
pub static SUSPICIONS: [&Code; 7] =
    [&STANDING_SPINDLE, &NO_FEED, &POWER_ON, &LONG_WAY, &BELOW_THE_CUT, &OUT_OF_TRAVEL, &BEHIND_THE_END];

impl Suspicion {
    /// What is told of it. `axes` are the names of the machine's axes.
    pub(super) fn diagnostic(self, met: Met, file: &str, axes: &[String]) -> Diagnostic {
        let (code, message): (&'static Code, String) = match self {
            Self::StandingSpindle => (&STANDING_SPINDLE, "a cut while the spindle stands".to_owned()),
            Self::NoFeed => (&NO_FEED, "a cut without a feed".to_owned()),
            Self::PowerOn(what) => (&POWER_ON, format!("the program moves before it has said {what}")),
            Self::LongWay(axis) => (&LONG_WAY, format!("{} turns by more than half a turn in one block", axes[axis])),
            Self::BelowTheCut => (&BELOW_THE_CUT, "a rapid motion ends deeper than the cut before it".to_owned()),
            Self::OutOfTravel(axis) => {
                (&OUT_OF_TRAVEL, format!("the program goes beyond the travel of {}", axes[axis]))
            }
            Self::BehindTheEnd => (&BEHIND_THE_END, "text behind the end of the program".to_owned()),
        };
        let label = match (self, met.blocks) {
            (Self::BehindTheEnd, 1) => "this line is not run".to_owned(),
            (Self::BehindTheEnd, lines) => format!("here first; {lines} lines are not run"),
            (_, 1) => "in this block".to_owned(),
            (_, blocks) => format!("here first, in {blocks} blocks"),
        };
        Diagnostic::warning(code, message).at(Place::line(file, met.line), label)
    }
}
