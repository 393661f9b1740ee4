//! A controller's dialect as tables: words, modal groups, blocks, and what their texts mean.

use crate::dialect::table::Table;
use crate::number::Picture;
use crate::unit::LengthUnit;

/// An address and how its number is printed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Word {
    /// The axis or register it stands for (`X`, `F`).
    pub name: String,
    /// What is printed before the number (`X`, `C1=`).
    pub address: String,
    /// For this program's unit of length.
    pub picture: Picture,
}

/// Sequence numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sequence {
    /// Before the number (`N`).
    pub address: String,
    /// The first number.
    pub start: u64,
    /// From one block to the next.
    pub step: u64,
    /// After the greatest, numbering begins again at `start`.
    pub greatest: u64,
}

/// One piece of a line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Piece {
    /// Printed as it is.
    Text(String),
    /// A code of a modal group: in motion blocks printed only when the group's state changes.
    Modal {
        /// Index into [`Dialect::modal_groups`].
        group: usize,
        /// Index into the group.
        code: usize,
    },
    /// The words of these axes (indices into [`Dialect::axes`], ascending), as far as they change.
    Axes(Vec<usize>),
    /// The feed word when it changes, behind the code of its kind when that changes.
    Feed,
    /// A value of the program's, printed by the picture or plainly.
    Value(Value, Option<Picture>),
}

/// What a `{placeholder}` stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Value {
    /// `{program}`: the program's name, upper case, letters, digits and underscores.
    Program,
    /// `{machine}`: the machine's name.
    Machine,
    /// `{operation}`: the CL's operation name.
    Operation,
    /// `{tool}`: the tool's number.
    Tool,
    /// `{tool_name}`: the CL's tool name.
    ToolName,
    /// `{register}`: the tool's length register (the tool's number where the CL gives none).
    Register,
    /// `{speed}`: spindle speed in revolutions a minute.
    Speed,
    /// `{seconds}`: a dwell.
    Seconds,
    /// `{milliseconds}`: a dwell.
    Milliseconds,
    /// `{text}`: a message or a comment.
    Text,
    /// `{offset}`: the work offset's code.
    Offset,
    /// `{units}`: the code of the program's unit of length.
    Units,
    /// `{feed_mode}`: the code of the feed's kind.
    FeedMode,
    /// `{retract}`: the word that takes the tool to its way out ([`crate::machine::Retract`]), in machine coordinates.
    Retract,
}

/// What makes the writer print a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Trigger {
    /// `start`: the head of the program.
    Start,
    /// `end`: its foot.
    End,
    /// `operation`: a new operation of the CL.
    Operation,
    /// `tool`: a tool change.
    Tool,
    /// `spindle clockwise`.
    SpindleClockwise,
    /// `spindle counterclockwise`.
    SpindleCounterclockwise,
    /// `spindle off`.
    SpindleOff,
    /// `coolant flood` (and plain ON).
    CoolantFlood,
    /// `coolant mist`.
    CoolantMist,
    /// `coolant through`: through the tool.
    CoolantThrough,
    /// `coolant off`.
    CoolantOff,
    /// `stop`: a programmed stop.
    Stop,
    /// `optional stop`.
    OptionalStop,
    /// `dwell`.
    Dwell,
    /// `message`: text for the operator.
    Message,
    /// `approach`: the first motion of a program or after a tool change, when it is a rapid one.
    Approach,
    /// `approach feed`: the same at feed.
    ApproachFeed,
    /// `rapid`: a rapid motion.
    Rapid,
    /// `feed`: a motion at feed.
    Feed,
}

impl Trigger {
    /// All of them, in their order.
    pub const ALL: [Self; 19] = [
        Self::Start,
        Self::End,
        Self::Operation,
        Self::Tool,
        Self::SpindleClockwise,
        Self::SpindleCounterclockwise,
        Self::SpindleOff,
        Self::CoolantFlood,
        Self::CoolantMist,
        Self::CoolantThrough,
        Self::CoolantOff,
        Self::Stop,
        Self::OptionalStop,
        Self::Dwell,
        Self::Message,
        Self::Approach,
        Self::ApproachFeed,
        Self::Rapid,
        Self::Feed,
    ];

    /// As a controller's description names it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::End => "end",
            Self::Operation => "operation",
            Self::Tool => "tool",
            Self::SpindleClockwise => "spindle clockwise",
            Self::SpindleCounterclockwise => "spindle counterclockwise",
            Self::SpindleOff => "spindle off",
            Self::CoolantFlood => "coolant flood",
            Self::CoolantMist => "coolant mist",
            Self::CoolantThrough => "coolant through",
            Self::CoolantOff => "coolant off",
            Self::Stop => "stop",
            Self::OptionalStop => "optional stop",
            Self::Dwell => "dwell",
            Self::Message => "message",
            Self::Approach => "approach",
            Self::ApproachFeed => "approach feed",
            Self::Rapid => "rapid",
            Self::Feed => "feed",
        }
    }

    /// The one that is named like this, with one blank between its words.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|trigger| trigger.name() == name)
    }

    /// Whether a controller may have no block for it, because nothing the CL asks for gets lost.
    pub fn may_lack_a_block(self) -> bool {
        matches!(self, Self::Start | Self::End | Self::Operation | Self::Approach | Self::ApproachFeed)
    }

    /// Whether it is a motion of the CL, whose block prints axis words.
    pub fn is_motion(self) -> bool {
        matches!(self, Self::Approach | Self::ApproachFeed | Self::Rapid | Self::Feed)
    }

    /// Whether it is a motion at feed, whose block prints the feed.
    pub fn is_feed(self) -> bool {
        matches!(self, Self::ApproachFeed | Self::Feed)
    }
}

/// One line of a block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line {
    /// Whether it takes a sequence number.
    pub numbered: bool,
    /// Its pieces, printed one after the other; blanks left by pieces that print nothing are dropped.
    pub pieces: Vec<Piece>,
}

/// A block template.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Block {
    /// When it is printed.
    pub trigger: Trigger,
    /// Its lines.
    pub lines: Vec<Line>,
}

/// A controller's dialect, resolved for one machine and one unit of length.
#[derive(Debug, Clone, PartialEq)]
pub struct Dialect {
    /// The controller's name.
    pub name: String,
    /// The program's unit of length.
    pub units: LengthUnit,
    /// The program file's extension, without the dot.
    pub extension: String,
    /// What opens and closes a comment; an empty close means the end of the line.
    pub comment: (String, String),
    /// Sequence numbers, if any.
    pub sequence: Option<Sequence>,
    /// The work offset's code.
    pub offset: String,
    /// What `{retract}` prints, where it is not the end of the travel.
    pub retract: Option<String>,
    /// The codes for the program's unit of length, feed a minute and feed a revolution.
    pub codes: Codes,
    /// The words of the machine's axes, in the machine's order.
    pub axes: Vec<Word>,
    /// The feed word.
    pub feed: Word,
    /// The feed word in millimetres or inches a revolution; the same word where the controller makes no difference.
    pub feed_per_revolution: Word,
    /// Codes that replace each other.
    pub modal_groups: Vec<Vec<String>>,
    /// At most one block a trigger.
    pub blocks: Vec<Block>,
    /// What the texts mean, for reading.
    pub table: Table,
}

/// Codes that follow from the program's state.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Codes {
    /// For the program's unit of length (`G21`).
    pub units: String,
    /// Feed a minute (`G94`).
    pub per_minute: String,
    /// Feed a revolution (`G95`), where the control has it.
    pub per_revolution: Option<String>,
}

impl Dialect {
    /// What one of the feed word is, in millimetres a minute.
    pub fn feed_unit_mm(&self) -> f64 {
        match self.units {
            LengthUnit::Millimetre => 1.0,
            LengthUnit::Inch => self.table.inch_feed_mm,
        }
    }

    /// The block that a trigger prints, if the controller has one.
    pub fn block(&self, trigger: Trigger) -> Option<&Block> {
        self.blocks.iter().find(|block| block.trigger == trigger)
    }
}
