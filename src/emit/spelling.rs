//! How the parts of an equation are spelled: for a terminal, or in LaTeX.

use crate::model::number::number;

/// A way to spell equations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spelling {
    /// For a terminal: `√(x² + y²)`.
    Plain,
    /// LaTeX, for its mathematical mode: `\sqrt{x^2 + y^2}`.
    Latex,
}

impl Spelling {
    /// The name of an axis or of another symbol: a number behind letters is an index.
    pub fn name(self, name: &str) -> String {
        let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
        match self {
            Self::Latex if letters.len() < name.len() => format!("{letters}_{{{}}}", &name[letters.len()..]),
            _ => name.to_owned(),
        }
    }

    pub(super) fn number(self, value: f64) -> String {
        let text = number(value);
        match self {
            Self::Plain => text,
            Self::Latex => {
                text.replace("π/2", "\\tfrac{\\pi}{2}").replace('π', "\\pi").replace("√½", "\\sqrt{\\tfrac{1}{2}}")
            }
        }
    }

    pub(super) fn in_parentheses(self, inner: &str) -> String {
        match self {
            Self::Plain => format!("({inner})"),
            Self::Latex => format!("\\left({inner}\\right)"),
        }
    }

    /// The square of something that holds together.
    pub(super) fn square(self, base: &str) -> String {
        match self {
            Self::Plain => format!("{base}²"),
            Self::Latex => format!("{base}^2"),
        }
    }

    pub(super) fn root(self, inner: &str) -> String {
        match self {
            Self::Plain => format!("√({inner})"),
            Self::Latex => format!("\\sqrt{{{inner}}}"),
        }
    }

    /// The sine or cosine of something that holds together.
    pub(super) fn of_angle(self, function: &str, angle: &str) -> String {
        match self {
            Self::Plain => format!("{function} {angle}"),
            Self::Latex => format!("\\{function} {angle}"),
        }
    }

    /// The same of half of it.
    pub(super) fn of_half_angle(self, function: &str, angle: &str) -> String {
        match self {
            Self::Plain => format!("{function}(½ {angle})"),
            Self::Latex => format!("\\{function} \\tfrac{{1}}{{2}} {angle}"),
        }
    }

    pub(super) fn function(self, function: &str, arguments: &[String]) -> String {
        let arguments = arguments.join(", ");
        match self {
            Self::Plain => format!("{function}({arguments})"),
            Self::Latex => format!("\\operatorname{{{function}}}\\left({arguments}\\right)"),
        }
    }

    /// `b` where `a > 0`, else `c`.
    pub(super) fn choice(self, [a, b, c]: [String; 3]) -> String {
        match self {
            Self::Plain => format!("({b} if {a} > 0 else {c})"),
            Self::Latex => format!("\\begin{{cases}} {b} & {a} > 0 \\\\ {c} & \\text{{else}} \\end{{cases}}"),
        }
    }
}
