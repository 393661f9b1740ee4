//! How a program can differ from its CL.

use crate::diagnostic::{Code, Diagnostic, Place};

/// A kind of difference.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Difference {
    Elsewhere,
    Kind,
    Feed,
    Spindle,
    Coolant,
    Tool,
    Order,
    WayOut,
    State,
}

/// A difference, and how it is told.
pub(crate) type Found = (Difference, String);

static ELSEWHERE: Code = Code {
    id: "E1210",
    title: "the program goes elsewhere than the CL",
    explanation: "\
A block takes the tool to a place that the CL does not ask for there, or a point of the CL is left out. The message says how far it
is from the point that comes next in the CL. Where the program goes on with a later point, that is said too.",
};

static KIND: Code = Code {
    id: "E1211",
    title: "rapid and feed are exchanged",
    explanation: "\
The CL goes to this point at feed and the program in rapid traverse, or the other way round.",
};

static FEED: Code = Code {
    id: "E1212",
    title: "another feed than in the CL",
    explanation: "\
The feed that is in force in the program, in the unit that its feed mode says, is not the CL's, by more than the word's last digit.",
};

static SPINDLE: Code = Code {
    id: "E1213",
    title: "the spindle does something else than in the CL",
    explanation: "\
At a cut the spindle stands, turns the other way or at another speed, or at a tool change it still turns.",
};

static COOLANT: Code = Code {
    id: "E1214",
    title: "another coolant than in the CL",
    explanation: "At a cut a coolant is off that the CL has on, or the other way round.",
};

static TOOL: Code = Code {
    id: "E1215",
    title: "another tool, length register or work offset",
    explanation: "\
A point is reached with another tool in the spindle than in the CL, with the length of another register (or without length
compensation), or under another work offset than the machine's file has.",
};

static ORDER: Code = Code {
    id: "E1216",
    title: "an event is missing or too much",
    explanation: "\
Tool changes, stops and dwells are compared with the CL in their order. This one is not there in the program, or not in the CL, or
stands somewhere else.",
};

static WAY_OUT: Code = Code {
    id: "E1217",
    title: "the tool is not taken out",
    explanation: "\
The controller's description takes the tool to its way out before a tool changes and at the end, and the program does not, or goes
somewhere else.",
};

static STATE: Code = Code {
    id: "E1218",
    title: "another state of the control than the controller's description sets",
    explanation: "\
The plane of arcs, the way corners are passed, the way round of rotary axes, or the compensation of the cutter's radius is not what the head of a program has by
the controller's description.",
};

/// All of them, and what cannot be read.
pub static DIFFERENCES: [&Code; 10] =
    [&super::UNREADABLE, &ELSEWHERE, &KIND, &FEED, &SPINDLE, &COOLANT, &TOOL, &ORDER, &WAY_OUT, &STATE];

impl Difference {
    /// Whether any motion shows it; else only cuts do.
    pub(super) fn is_of_every_motion(self) -> bool {
        !matches!(self, Self::Feed | Self::Spindle | Self::Coolant)
    }

    /// Its code.
    pub(crate) fn code(self) -> &'static Code {
        match self {
            Self::Elsewhere => &ELSEWHERE,
            Self::Kind => &KIND,
            Self::Feed => &FEED,
            Self::Spindle => &SPINDLE,
            Self::Coolant => &COOLANT,
            Self::Tool => &TOOL,
            Self::Order => &ORDER,
            Self::WayOut => &WAY_OUT,
            Self::State => &STATE,
        }
    }

    /// The diagnostic, at a line of the program and perhaps one of the CL.
    pub(super) fn diagnostic(self, message: String, program: (&str, u64), cl: Option<(&str, u64)>) -> Diagnostic {
        let error = Diagnostic::error(self.code(), message).at(Place::line(program.0, program.1), "");
        match cl {
            Some((file, line)) => error.note(format!("the CL, at line {line} of {file}, says otherwise")),
            None => error,
        }
    }
}
