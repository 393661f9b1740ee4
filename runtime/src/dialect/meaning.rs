//! What the codes of a program can mean: a fixed list. A dialect gives each meaning its text; nothing else in the runtime
//! knows a code.

use crate::unit::LengthUnit;

/// What a code means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Meaning {
    /// How the axis words of the block, and of those after it, are gone to.
    Motion(MotionCode),
    /// The plane of arcs.
    Plane(Plane),
    /// What axis words count from.
    Distance(Distance),
    /// The unit of lengths.
    Units(LengthUnit),
    /// What the feed word counts.
    FeedMode(FeedMode),
    /// Where the arc's centre words count from.
    Centre(CentreMode),
    /// Compensation of the cutter's radius.
    Side(Side),
    /// The work offset whose number is in the pattern.
    Offset,
    /// Tool length compensation, on with the register that is in the pattern, or off.
    Length(Switch),
    /// The tip follows the program while the rotary axes move.
    Tip(Switch),
    /// A turned working plane.
    Frame(Switch),
    /// Canned cycles; only `off` is read and written so far.
    Cycle(Switch),
    /// How corners are passed.
    Path(PathMode),
    /// How the word of a rotary axis is taken that is written within a turn.
    Wrap(Wrap),
    /// The spindle.
    Spindle(Spindle),
    /// The coolant; all kinds but `off` may be on together.
    Coolant(Coolant),
    /// Something that happens once, in its block.
    Once(Once),
    /// The machine's builder gave it, and it moves nothing.
    Plain,
}

/// How axis words are gone to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MotionCode {
    /// In rapid traverse.
    Rapid,
    /// On a line, at feed.
    Line,
    /// On an arc, clockwise as seen against the plane's normal.
    ArcClockwise,
    /// On an arc, the other way round.
    ArcCounterclockwise,
}

/// The plane of an arc: its first and second axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Plane {
    /// X and Y, the normal along Z.
    Xy,
    /// Z and X, the normal along Y.
    Zx,
    /// Y and Z, the normal along X.
    Yz,
}

/// What axis words count from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Distance {
    /// From the zero in force.
    Absolute,
    /// From where the axis is.
    Incremental,
}

/// What the feed word counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FeedMode {
    /// Length a minute.
    PerMinute,
    /// Length a revolution of the spindle.
    PerRevolution,
    /// Blocks a minute.
    Inverse,
}

/// Where an arc's centre words count from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CentreMode {
    /// From the start of the arc.
    FromStart,
    /// From the zero in force.
    Absolute,
}

/// On which side of its path the cutter is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// On the path.
    Off,
    /// Left of it.
    Left,
    /// Right of it.
    Right,
}

/// A function that is on or off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Switch {
    /// Off.
    Off,
    /// On.
    On,
}

/// How corners are passed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathMode {
    /// The axes stop at the end of each block.
    Exact,
    /// They go on to the next block.
    Blend,
}

/// How a control takes the word of a rotary axis that is written within a turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wrap {
    /// As a number: 10 comes before 350.
    Counted,
    /// The shortest way.
    Shortest,
    /// The sign says the sense, the number the place.
    Signed,
}

/// What the spindle does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spindle {
    /// It stands.
    Off,
    /// It turns clockwise.
    Clockwise,
    /// It turns counter-clockwise.
    Counterclockwise,
}

/// What the coolant does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coolant {
    /// All of it is off.
    Off,
    /// Flood.
    Flood,
    /// Mist.
    Mist,
    /// Through the tool.
    Through,
}

/// What happens once.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Once {
    /// The axis words of this block count from the machine's own zero: no offset, no length, absolute.
    MachineCoordinates,
    /// The axes that the block names go to the machine's reference point, by way of the words.
    ReferencePoint,
    /// The tool goes out along its axis, as far as the machine lets it.
    RetractAlongTool,
    /// The axis words of the block are the centre of the arcs that follow.
    Pole,
    /// The axis words of the block say where the stock is.
    Stock,
    /// The tool in the pattern, or the one that was called last, comes into the spindle.
    ToolChange,
    /// The tool in the pattern is made ready.
    Preselect,
    /// A pause.
    Dwell,
    /// The program stops until it is started again.
    Stop,
    /// The same, where the operator wants it.
    OptionalStop,
    /// The program is over.
    End,
    /// The program's name or number.
    Program,
    /// The end of the program's text, where it runs no further.
    ProgramEnd,
    /// Text for the operator.
    Message,
}

impl Meaning {
    /// Whether two codes cannot be in force together: other members of one group.
    pub fn excludes(self, other: Self) -> bool {
        match (self, other) {
            (Self::Coolant(a), Self::Coolant(b)) => (a == Coolant::Off) != (b == Coolant::Off),
            (Self::Offset, Self::Offset) => true,
            (Self::Once(_) | Self::Plain, _) | (_, Self::Once(_) | Self::Plain) => false,
            (a, b) => std::mem::discriminant(&a) == std::mem::discriminant(&b),
        }
    }
}
