//! What a post knows of its machine, apart from its inverse: axes, travel, written range, policies, the chain.

mod chain;
mod error_table;

pub(crate) use chain::turned;
pub use chain::{Chain, Joint};
pub use error_table::{Component, ErrorTable};

pub use crate::strictness::Strictness;
pub use crate::tool::ToolGeometry;

/// One machine axis. A linear joint value is in millimetres, a rotary one in degrees, both in machine
/// coordinates: zero where the machine file's frame has the axis at zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// The axis letter (ISO 841), which is also its address in the program.
    pub name: String,
    /// How it moves.
    pub motion: Motion,
    /// How far it can go, in machine coordinates.
    pub travel: Travel,
    /// What decides where it stands.
    pub rule: Rule,
    /// How its value is written.
    pub written: Written,
    /// The joint value at which the program reads zero: the axis' share of the program zero.
    pub zero: f64,
    /// How much of each millimetre of tool length the control takes into this axis (its length compensation along
    /// the tool axis at home): written value = joint - zero - share × tool length.
    pub length_share: f64,
    /// Rapid traverse in mm/min or deg/min, where the machine file gives it.
    pub rapid_per_min: Option<f64>,
}

/// The way out: where one linear axis takes the tool farthest from the workpiece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Retract {
    /// The axis that moves most along the tool axis at home, as an index.
    pub axis: usize,
    /// The end of its travel on the tool's side, in machine coordinates and millimetres; infinite without a limit.
    pub end_mm: f64,
    /// Whether that is the upper end.
    pub is_upper: bool,
}

impl Retract {
    /// The way out of a machine with these axes; none when no axis moves along the tool axis.
    pub fn of(axes: &[Axis]) -> Option<Self> {
        let share = |index: &usize| axes[*index].length_share.abs();
        let axis = (0..axes.len()).rev().max_by(|a, b| share(a).total_cmp(&share(b)))?;
        let Axis { length_share, travel, .. } = &axes[axis];
        let is_upper = *length_share > 0.0;
        let end_mm = if is_upper { travel.upper } else { travel.lower };
        (*length_share != 0.0).then_some(Self { axis, end_mm, is_upper })
    }
}

/// How an axis moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Motion {
    /// Along a line; values in millimetres.
    Linear,
    /// About a line; values in degrees.
    Rotary,
}

impl Motion {
    /// The unit of its values, as it is printed.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Linear => "mm",
            Self::Rotary => "deg",
        }
    }
}

/// The physical travel; infinite bounds where there is none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Travel {
    /// The least joint value.
    pub lower: f64,
    /// The greatest joint value.
    pub upper: f64,
}

impl Travel {
    /// No limit at either end.
    pub const UNLIMITED: Self = Self { lower: f64::NEG_INFINITY, upper: f64::INFINITY };

    /// Whether a value is inside.
    #[inline]
    pub fn contains(self, value: f64) -> bool {
        self.lower <= value && value <= self.upper
    }

    /// The numbers in it: infinity is beyond every travel.
    pub fn numbers(self) -> Self {
        Self { lower: self.lower.max(f64::MIN), upper: self.upper.min(f64::MAX) }
    }
}

/// What decides where an axis stands. Values are in millimetres or degrees, within its travel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rule {
    /// The pose of the tool.
    Pose,
    /// The machine file, for good.
    Locked(f64),
    /// The machine file: this value wherever the machine has a way with it, else the nearest sample that has one.
    Preferred(f64),
    /// It stays where it is while the machine has a way with that, else it goes to the nearest sample that has one.
    Free,
}

impl Rule {
    /// Whether the pose leaves the axis open, so that its value has to be chosen.
    pub fn is_surplus(self) -> bool {
        matches!(self, Self::Preferred(_) | Self::Free)
    }
}

/// How a rotary value is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Written {
    /// As it is, whole turns included.
    Unwound,
    /// Reduced to one turn: `from_deg <= value < from_deg + 360`.
    Wrapped {
        /// The least value written.
        from_deg: f64,
    },
}

/// One way to prefer a candidate; lists of them are compared in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Preference {
    /// The smaller magnitude of this axis.
    Least(usize),
    /// This axis at or above zero.
    Positive(usize),
    /// This axis at or below zero.
    Negative(usize),
    /// The least sum of rotary travel from the previous position.
    Nearest,
}

/// How one of the candidates is chosen at each point.
#[derive(Debug, Clone, PartialEq)]
pub struct BranchPolicy {
    /// At the first point of a program.
    pub start: Vec<Preference>,
    /// At every further point.
    pub then: Vec<Preference>,
    /// When the travel forces another branch or a turn back in the middle of a cut.
    pub reposition: Strictness,
}

/// The machine's tables.
#[derive(Debug, Clone, PartialEq)]
pub struct Machine {
    /// The name in the machine file.
    pub name: String,
    /// In the order in which their words are written.
    pub axes: Vec<Axis>,
    /// How they follow one another from the workpiece to the tool, location errors included.
    pub chain: Chain,
    /// How candidates are chosen.
    pub branch: BranchPolicy,
    /// How far the tool axis may be from the wanted one, in radians, before a direction counts as out of reach.
    pub axis_tolerance_rad: f64,
    /// How far the tip may be from what two linear axes and a rotary one reach, in millimetres.
    pub plane_tolerance_mm: f64,
    /// How far a segment may leave an arc of the CL, in millimetres.
    pub chord_tolerance_mm: f64,
    /// What a CL record that nobody knows does.
    pub unknown_records: Strictness,
    /// The program zero in the machine frame with every axis at zero, in millimetres.
    pub zero_mm: [f64; 3],
    /// The tools that it may have in its spindle; one at least.
    pub tools: Vec<ToolGeometry>,
    /// The errors that depend on where an axis is; the kinematics' inputs are in this order.
    pub errors: Vec<ErrorTable>,
}

impl Machine {
    /// The tool in the spindle: the first one.
    ///
    /// # Panics
    /// When the machine has none.
    pub fn tool(&self) -> ToolGeometry {
        *self.tools.first().expect("a machine has a tool")
    }
}
