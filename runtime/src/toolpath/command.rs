//! What is said between the points.

/// Which way the spindle turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spindle {
    /// Clockwise.
    Clockwise,
    /// Counter-clockwise.
    Counterclockwise,
}

/// Which coolant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coolant {
    /// Flood, also plain ON.
    Flood,
    /// Mist.
    Mist,
    /// Through the tool.
    Through,
}

/// Something between the points.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// `TOOL PATH/`: an operation begins.
    Operation {
        /// Its name.
        name: String,
        /// Its tool's name.
        tool: String,
    },
    /// `LOAD/TOOL`: a tool change.
    Tool {
        /// The tool's number.
        number: u64,
        /// Its length register.
        register: Option<u64>,
    },
    /// `SPINDL/`: the spindle turns.
    SpindleOn(Spindle, f64),
    /// `SPINDL/OFF`.
    SpindleOff,
    /// `COOLNT/`.
    CoolantOn(Coolant),
    /// `COOLNT/OFF`.
    CoolantOff,
    /// `STOP`.
    Stop,
    /// `OPSTOP`.
    OptionalStop,
    /// `DELAY/`: seconds.
    Dwell(f64),
    /// `PPRINT`, `INSERT` and the like: text for the operator.
    Message(String),
}
