//! The names of errors in ISO 230-1 and ISO 230-7: `EXX`, `EBC`, `EX0C`, `EC(0X)Y`.

use mach_runtime::machine::Component;

/// A name, taken apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ErrorName<'a> {
    /// What the axis does: shift along, or turn about, a direction of the frame.
    pub(crate) component: Component,
    /// Whether it is told with a zero: where the axis lies, at whatever position.
    pub(crate) is_location: bool,
    /// The axis that does it.
    pub(crate) axis: &'a str,
}

impl<'a> ErrorName<'a> {
    /// Reads a name. The zero may be written as the letter O, and may stand in parentheses with the axis it refers to
    /// (`EC(0X)Y`): the reference is the frame all the same.
    pub(crate) fn read(name: &'a str) -> Option<Self> {
        let mut letters = name.strip_prefix('E')?.chars();
        let letter = letters.next()?;
        let component = Component::ALL.into_iter().find(|component| component.letter() == letter)?;
        let rest = letters.as_str();
        let behind_zero = |text: &'a str| text.strip_prefix(['0', 'O']);
        let behind_reference = || behind_zero(rest.strip_prefix('(')?).and_then(|text| Some(text.split_once(')')?.1));
        let location = behind_reference().or_else(|| behind_zero(rest)).filter(|axis| !axis.is_empty());
        let axis = location.unwrap_or(rest);
        let is_axis = axis.starts_with(|c: char| c.is_ascii_uppercase()) && !axis.contains(['(', ')']);
        is_axis.then_some(Self { component, is_location: location.is_some(), axis })
    }

    /// The name as this project writes it.
    pub(crate) fn canonical(&self) -> String {
        let zero = if self.is_location { "0" } else { "" };
        format!("E{}{zero}{}", self.component.letter(), self.axis)
    }
}

#[cfg(test)]
mod tests {
    use super::ErrorName;

    #[test]
    fn a_name_is_read_however_its_zero_is_written() {
        let canonical = |name| ErrorName::read(name).map(|name| name.canonical());
        for (written, meant) in [
            ("EXX", "EXX"),
            ("EBC1", "EBC1"),
            ("EX0C", "EX0C"),
            ("EXOC", "EX0C"),
            ("EC(0X)Y", "EC0Y"),
            ("EA(OY)C", "EA0C"),
            ("EXO", "EXO"),
        ] {
            assert_eq!(canonical(written).as_deref(), Some(meant), "{written}");
        }
        for wrong in ["E", "EX", "EX0", "EDX", "XOC", "EX(0Y)", "EX(0Y", "EXx", "EX0c"] {
            assert_eq!(canonical(wrong), None, "{wrong}");
        }
    }
}
