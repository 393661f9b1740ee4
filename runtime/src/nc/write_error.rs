//! What can keep a block from being printed, as data and as diagnostics.

use super::dialect::{Trigger, Word};
use crate::diagnostic::{Code, Diagnostic};
use std::fmt;

/// Why a block was not printed.
#[derive(Debug, Clone, PartialEq)]
pub enum WriteError {
    /// The controller has no block for it.
    NoBlock(Trigger),
    /// A number has more digits than its word, or is not finite.
    TooLarge {
        /// The word's name, such as `X`, or the placeholder's.
        word: String,
        /// The number, in the word's unit.
        value: f64,
        /// The least number that is too large.
        limit: f64,
    },
    /// A feed rate that is not above zero once it is rounded.
    NoFeed {
        /// The feed rate, in the word's unit.
        value: f64,
    },
    /// A speed or a time that is not zero, and would be once it is rounded.
    Zero {
        /// The placeholder.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// The number or the register of a tool in a motion, and none is in the spindle, or one with register zero.
    NoTool {
        /// The placeholder.
        name: &'static str,
    },
    /// The program's name has no letter or digit.
    NoProgramName,
    /// A feed a revolution, and the controller has no code for it.
    NoFeedPerRevolution,
}

/// Every kind of it.
pub static CODES: [&Code; 7] =
    [&NO_BLOCK, &TOO_LARGE, &NO_FEED, &NO_PROGRAM_NAME, &NO_FEED_PER_REVOLUTION, &ZERO, &NO_TOOL];

static NO_BLOCK: Code = Code {
    id: "E1160",
    title: "the controller has no block for this",
    explanation: "\
The CL asks for something that the controller's description does not say how to write.

    controller plain {
        on feed { \"G1 {axes} {feed}\" }
    }

cannot write a `COOLNT/MIST`. Add the block to the controller, or to the machine's own `controller` block:

    on coolant mist { \"M7\" }

An empty block, `on coolant mist { }`, says that nothing is to be written.",
};

static TOO_LARGE: Code = Code {
    id: "E1161",
    title: "a number has too many digits for its word",
    explanation: "\
The picture of a word says how many digits the control takes before the point: `###.###` ends at 999.999. A greater
number is never cut: the control would go elsewhere.

If the control takes more digits, give the format more `#`:

    format length \"#####.###\"

If it does not, the program asks for a point that the machine cannot reach.",
};

static NO_FEED: Code = Code {
    id: "E1162",
    title: "the feed rate is zero once it is rounded",
    explanation: "\
A feed rate of zero stops the machine in the middle of the cut. Either the CL gives no feed rate before its first
cut, or the rate is so small that the feed word's picture rounds it to zero: 0.04 written by `####.#` is `0.0`.

Give the feed's format more decimals:

    format feed \"#####.###\"",
};

static NO_PROGRAM_NAME: Code = Code {
    id: "E1163",
    title: "the program has no name",
    explanation: "\
The head of the program prints `{program}`, which is made of the letters, digits and underscores of the name the
program is posted under. Nothing is left of a name such as `-` or `...`. Post to a file whose name has letters or digits.",
};

static NO_FEED_PER_REVOLUTION: Code = Code {
    id: "E1164",
    title: "the controller has no feed per revolution",
    explanation: "\
The CL gives a feed in millimetres a revolution (`FEDRAT/MMPR,0.1`), and the controller knows a code for feed a
minute only. If the control has one, name it:

    code feed minute \"G94\" revolution \"G95\"

If not, choose feed rates a minute in the CAM system.",
};

static ZERO: Code = Code {
    id: "E1165",
    title: "a speed or a time is zero once it is rounded",
    explanation: "\
`SPINDL/RPM,0.3` would be written as `S0`: the spindle stands, and the cut goes on. The speed may be in another unit, or come
of a division by a diameter of zero. A dwell of less than half of the last digit of its word would be none.

Mend the CL, or give the placeholder a picture with more decimals:

    on spindle clockwise { \"S{speed:####0[.##]} M3\" }",
};

static NO_TOOL: Code = Code {
    id: "E1166",
    title: "no tool is in the spindle",
    explanation: "\
The controller's block for this motion prints the tool's number or its length register, and the CL has loaded no tool before
it, or one with register zero. With that the control would compensate no length: it takes the spindle's nose for the tip, and
the tool goes deeper by all of its length.

Have the CAM system put out the tool change, with the register if it is not the tool's number:

    LOAD/TOOL,1,ADJUST,1",
};

impl WriteError {
    /// A number that has too many digits for its word.
    #[cold]
    pub(super) fn too_large(word: &Word, value: f64) -> Self {
        let limit = word.picture.value(word.picture.too_many_units());
        Self::TooLarge { word: word.name.clone(), value, limit }
    }

    /// Its kind.
    pub fn code(&self) -> &'static Code {
        match self {
            Self::NoBlock(_) => &NO_BLOCK,
            Self::TooLarge { .. } => &TOO_LARGE,
            Self::NoFeed { .. } => &NO_FEED,
            Self::Zero { .. } => &ZERO,
            Self::NoTool { .. } => &NO_TOOL,
            Self::NoProgramName => &NO_PROGRAM_NAME,
            Self::NoFeedPerRevolution => &NO_FEED_PER_REVOLUTION,
        }
    }

    /// The diagnostic, without a place: the caller knows the line of the CL.
    pub fn diagnostic(&self) -> Diagnostic {
        let diagnostic = Diagnostic::error(self.code(), self.to_string());
        match self {
            Self::NoTool { .. } => diagnostic.note("the CL has no LOAD/TOOL before it, or one with register zero"),
            _ => diagnostic,
        }
    }
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoBlock(trigger) => write!(f, "the controller has no block `on {}`", trigger.name()),
            Self::TooLarge { word, value, .. } if !value.is_finite() => write!(f, "{word} is not a finite number"),
            Self::TooLarge { word, value, limit } => {
                write!(f, "{word} would be {value:.4}, and its word takes numbers below {limit}")
            }
            Self::NoFeed { value } => write!(f, "the feed rate {value} is zero once it is rounded"),
            Self::Zero { name, value } => write!(f, "the value {value} of `{{{name}}}` is zero once it is rounded"),
            Self::NoTool { name } => write!(f, "the block prints `{{{name}}}`, and no tool is in the spindle"),
            Self::NoProgramName => write!(f, "no letter or digit is in the program's name"),
            Self::NoFeedPerRevolution => write!(f, "the controller has no code for a feed per revolution"),
        }
    }
}

impl std::error::Error for WriteError {}
