//! How units are written.

use super::tree::Unit;

/// Every unit and how it is written.
pub const UNITS: [(&str, Unit); 16] = [
    ("mm", Unit::Millimetre),
    ("um", Unit::Micrometre),
    ("m", Unit::Metre),
    ("in", Unit::Inch),
    ("deg", Unit::Degree),
    ("rad", Unit::Radian),
    ("mrad", Unit::Milliradian),
    ("urad", Unit::Microradian),
    ("arcsec", Unit::Arcsecond),
    ("rpm", Unit::RevolutionPerMinute),
    ("mm/min", Unit::MillimetrePerMinute),
    ("m/min", Unit::MetrePerMinute),
    ("mm/s", Unit::MillimetrePerSecond),
    ("in/min", Unit::InchPerMinute),
    ("deg/min", Unit::DegreePerMinute),
    ("deg/s", Unit::DegreePerSecond),
];

/// What people write for a unit, and the unit they mean.
pub(super) const SYNONYMS: [(&str, &str); 24] = [
    ("°", "deg"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("′", "deg"),
    ("″", "arcsec"),
    ("radian", "rad"),
    ("radians", "rad"),
    ("inch", "in"),
    ("inches", "in"),
    ("millimetre", "mm"),
    ("millimeter", "mm"),
    ("cm", "mm"),
    ("metre", "m"),
    ("meter", "m"),
    ("µm", "um"),
    ("μm", "um"),
    ("micron", "um"),
    ("microns", "um"),
    ("ipm", "in/min"),
    ("inch/min", "in/min"),
    ("mmpm", "mm/min"),
    ("°/min", "deg/min"),
    ("°/s", "deg/s"),
    ("rev/min", "rpm"),
];

impl Unit {
    /// As it is written in a `.mach` file.
    pub fn symbol(self) -> &'static str {
        UNITS.iter().find(|(_, unit)| *unit == self).map(|(symbol, _)| *symbol).expect("UNITS lists every unit")
    }

    /// The unit that is written like this.
    pub fn from_symbol(symbol: &str) -> Option<Self> {
        UNITS.iter().find(|(written, _)| *written == symbol).map(|(_, unit)| *unit)
    }
}
