//! Placeholders: what `{tool}` and the others stand for, and in which blocks.

use super::ControlledAxis;
use mach_runtime::diagnostic::Code;
use mach_runtime::machine::Motion;
use mach_runtime::nc::dialect::{Piece, Trigger, Value};

/// A placeholder that does not exist.
pub(super) static UNKNOWN_PLACEHOLDER: Code = Code {
    id: "E0524",
    title: "unknown placeholder",
    explanation: "\
| placeholder | stands for | in |
| --- | --- | --- |
| `{axes}`, `{linear}`, `{rotary}` | the words of the axes that change: all, the linear ones, the rotary ones | motions |
| `{X}` | the word of one axis, when it changes | motions |
| `{feed}` | the feed word, when it changes | `feed`, `approach feed` |
| `{retract}` | the axis word that takes the tool out, in machine coordinates | all but motions |
| `{program}`, `{machine}` | the program's and the machine's name | all but motions |
| `{offset}`, `{units}`, `{feed_mode}` | the codes of the work offset, the unit of length, the kind of feed | all |
| `{operation}` | the operation of the CL | `operation`, `tool` |
| `{tool}`, `{register}` | the numbers of the tool and its length register | `tool`, `approach`, `approach feed` |
| `{tool_name}` | the tool's name in the CL | `operation`, `tool` |
| `{speed}` | revolutions a minute | `spindle clockwise`, `spindle counterclockwise` |
| `{seconds}`, `{milliseconds}` | the time | `dwell` |
| `{text}` | the text for the operator | `message` |

Motions are `rapid`, `feed`, `approach` and `approach feed`. A number may have a picture: `H{register:00}` prints `H07`. A brace that is to be printed is written twice.
",
};

/// A placeholder in a block that has nothing for it.
pub(super) static PLACEHOLDER_ELSEWHERE: Code = Code {
    id: "E0525",
    title: "the placeholder has no value in this block",
    explanation: "\
A placeholder stands for something that the event brings along: a tool change knows its tool, a dwell its time.

    on start { \"T{tool} M6\" }        // which tool?
    on tool  { \"T{tool} M6\" }

Only numbers take a picture: `{tool:00}` is right and `{units:00}` is not. `machc explain E0524` lists all placeholders
with their blocks.
",
};

/// What a placeholder stands for, before its picture is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Meaning<'t> {
    Axes,
    Linear,
    Rotary,
    /// The axis of this name.
    Axis(&'t str),
    Feed,
    Value(Value),
}

/// Every placeholder but the names of axes.
pub(super) const PLACEHOLDERS: [(&str, Meaning<'_>); 18] = [
    ("axes", Meaning::Axes),
    ("linear", Meaning::Linear),
    ("rotary", Meaning::Rotary),
    ("feed", Meaning::Feed),
    ("program", Meaning::Value(Value::Program)),
    ("machine", Meaning::Value(Value::Machine)),
    ("operation", Meaning::Value(Value::Operation)),
    ("tool", Meaning::Value(Value::Tool)),
    ("tool_name", Meaning::Value(Value::ToolName)),
    ("register", Meaning::Value(Value::Register)),
    ("speed", Meaning::Value(Value::Speed)),
    ("seconds", Meaning::Value(Value::Seconds)),
    ("milliseconds", Meaning::Value(Value::Milliseconds)),
    ("text", Meaning::Value(Value::Text)),
    ("offset", Meaning::Value(Value::Offset)),
    ("units", Meaning::Value(Value::Units)),
    ("feed_mode", Meaning::Value(Value::FeedMode)),
    ("retract", Meaning::Value(Value::Retract)),
];

impl<'t> Meaning<'t> {
    /// What the placeholder of this name stands for; a name with a capital is an axis'.
    pub(super) fn of(name: &'t str) -> Option<Self> {
        if name.starts_with(|c: char| c.is_ascii_uppercase()) {
            return Some(Self::Axis(name));
        }
        PLACEHOLDERS.iter().find(|(known, _)| *known == name).map(|(_, meaning)| *meaning)
    }

    /// Whether the event brings it along.
    pub(super) fn is_known_in(self, trigger: Trigger) -> bool {
        let motion = trigger.is_motion();
        match self {
            Self::Axes | Self::Linear | Self::Rotary | Self::Axis(_) => motion,
            Self::Feed => trigger.is_feed(),
            Self::Value(Value::Offset | Value::Units | Value::FeedMode) => true,
            Self::Value(Value::Program | Value::Machine | Value::Retract) => !motion,
            Self::Value(Value::Operation | Value::ToolName) => matches!(trigger, Trigger::Operation | Trigger::Tool),
            Self::Value(Value::Tool | Value::Register) => {
                matches!(trigger, Trigger::Tool | Trigger::Approach | Trigger::ApproachFeed)
            }
            Self::Value(Value::Speed) => {
                matches!(trigger, Trigger::SpindleClockwise | Trigger::SpindleCounterclockwise)
            }
            Self::Value(Value::Seconds | Value::Milliseconds) => trigger == Trigger::Dwell,
            Self::Value(Value::Text) => trigger == Trigger::Message,
        }
    }

    /// Whether a picture can print it.
    pub(super) fn is_a_number(self) -> bool {
        use Value::{Milliseconds, Register, Seconds, Speed, Tool};
        matches!(self, Self::Value(Tool | Register | Speed | Seconds | Milliseconds))
    }

    /// The piece without a picture, for a machine with these axes.
    pub(super) fn piece(self, axes: &[ControlledAxis<'_>]) -> Piece {
        let those = |wanted: &dyn Fn(&ControlledAxis<'_>) -> bool| {
            Piece::Axes((0..axes.len()).filter(|index| wanted(&axes[*index])).collect())
        };
        match self {
            Self::Axes => those(&|_| true),
            Self::Linear => those(&|axis| axis.motion == Motion::Linear),
            Self::Rotary => those(&|axis| axis.motion == Motion::Rotary),
            Self::Axis(name) => those(&|axis| axis.name == name),
            Self::Feed => Piece::Feed,
            Self::Value(value) => Piece::Value(value, None),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_explanation_lists_every_placeholder() {
        for (name, meaning) in PLACEHOLDERS {
            assert!(UNKNOWN_PLACEHOLDER.explanation.contains(&format!("`{{{name}}}`")), "{name}");
            assert!(Trigger::ALL.iter().any(|trigger| meaning.is_known_in(*trigger)), "{name}");
        }
    }
}
