//! Formats and words of a controller.

use super::lowering::{Lowering, inside};
use super::picture::{self, BAD_PICTURE, PictureError};
use super::{ControlledAxis, LACKING};
use crate::syntax::spelling::nearest;
use crate::syntax::tree::{ControllerStatement, Expression, Name, Span, Text};
use mach_runtime::diagnostic::{Code, Diagnostic, Suggestion};
use mach_runtime::nc::dialect::Word;
use mach_runtime::number::Picture;
use mach_runtime::unit::LengthUnit;
use std::collections::BTreeMap;

/// A format that does not exist.
pub(super) static UNKNOWN_FORMAT: Code = Code {
    id: "E0521",
    title: "unknown format",
    explanation: "\
A word is printed by a format, which the controller (or the one it is like) must define.

    format length \"####.###\"
    word X Y Z length
    word A B C angle           // no `format angle`
",
};

/// The names that are no axes': of the feed a minute and a revolution.
pub(super) const FEED: &str = "F";
pub(super) const FEED_PER_REVOLUTION: &str = "F_revolution";

/// What is said of a word.
pub(super) struct Said<'a> {
    /// The statement's index.
    pub(super) index: usize,
    pub(super) name: &'a Name,
    pub(super) format: &'a Name,
    /// Where it is not the name.
    address: Option<&'a Text>,
    /// What one is in a program in inches, where that is said.
    pub(super) inch: Option<&'a Expression>,
}

impl<'a> Said<'a> {
    /// The last that is said of the word of this name.
    pub(super) fn last(lowering: &Lowering<'a>, name: &str) -> Option<Self> {
        let (index, (name, format, address, inch)) = lowering.last(|statement| match statement {
            ControllerStatement::Word { names, format, address, inch } => {
                let name = names.iter().find(|said| said.value == name)?;
                Some((name, format, address.as_ref(), inch.as_ref()))
            }
            _ => None,
        })?;
        Some(Self { index, name, format, address, inch })
    }

    /// What is printed before the number.
    pub(super) fn address(&self) -> &'a str {
        self.address.map_or(plain(&self.name.value), |address| &address.value)
    }

    /// Where that is said.
    pub(super) fn address_span(&self) -> &'a Span {
        self.address.map_or(&self.name.span, |address| &address.span)
    }
}

/// The name as it is printed.
fn plain(name: &str) -> &str {
    if name == FEED_PER_REVOLUTION { FEED } else { name }
}

/// The pictures by their formats' names, for the program's unit of length; `None` where the picture is wrong.
pub(super) type Formats<'a> = BTreeMap<&'a str, Option<Picture>>;

/// The formats.
pub(super) fn formats<'a>(lowering: &mut Lowering<'a>, units: LengthUnit) -> Formats<'a> {
    let mut formats = BTreeMap::new();
    for (index, statement) in lowering.statements() {
        let ControllerStatement::Format { name, picture, inch, zero } = statement else { continue };
        let metric = parsed(lowering, index, picture, picture::parse);
        let inch = inch.as_ref().map(|inch| parsed(lowering, index, inch, picture::parse));
        let zero = zero.as_ref().and_then(|zero| parsed(lowering, index, zero, picture::parse_zero));
        let picture = if units == LengthUnit::Inch { inch.unwrap_or(metric) } else { metric };
        formats.insert(name.value.as_str(), picture.map(|picture| Picture { zero, ..picture }));
    }
    formats
}

/// What a text says, or a report of the part of it that is wrong.
fn parsed<T>(
    lowering: &mut Lowering<'_>,
    index: usize,
    text: &Text,
    parse: fn(&str) -> Result<T, PictureError>,
) -> Option<T> {
    let error = match parse(&text.value) {
        Ok(value) => return Some(value),
        Err(error) => error,
    };
    let message = format!("`{}` is no picture of a number", text.value);
    lowering.report(&BAD_PICTURE, message, index, &inside(text, error.at), error.message);
    None
}

/// The words of the machine's axes. Words of axes that the machine does not have are only checked.
pub(super) fn axes(lowering: &mut Lowering<'_>, formats: &Formats<'_>, axes: &[ControlledAxis<'_>]) -> Vec<Word> {
    check_formats(lowering, formats);
    axes.iter().filter_map(|axis| required(lowering, formats, axis.name, axis.name)).collect()
}

/// The feed word.
pub(super) fn feed(lowering: &mut Lowering<'_>, formats: &Formats<'_>) -> Word {
    required(lowering, formats, FEED, "the feed").unwrap_or_else(|| nothing(FEED))
}

/// The feed word a revolution, where the controller makes a difference.
pub(super) fn feed_per_revolution(lowering: &mut Lowering<'_>, formats: &Formats<'_>) -> Option<Word> {
    find(lowering, formats, FEED_PER_REVOLUTION)
}

/// A word that must be there; a report, and a word that prints nothing sensible, where it is not.
fn required(lowering: &mut Lowering<'_>, formats: &Formats<'_>, name: &str, whose: &str) -> Option<Word> {
    let found = find(lowering, formats, name);
    if found.is_none() {
        let message = format!("the controller `{}` has no word for {whose}", lowering.controller.name);
        let place = lowering.controller.at.clone();
        let diagnostic = Diagnostic::error(&LACKING, message).at(place, format!("no `word {name} …` in it"));
        lowering.diagnostics.push(diagnostic);
    }
    found
}

/// The word of this name.
pub(super) fn find(lowering: &Lowering<'_>, formats: &Formats<'_>, name: &str) -> Option<Word> {
    let said = Said::last(lowering, name)?;
    let picture = formats.get(said.format.value.as_str()).cloned().flatten();
    Some(Word { name: plain(name).into(), address: said.address().into(), picture: picture.unwrap_or(Picture::WHOLE) })
}

/// Stands for a word that has been reported.
fn nothing(name: &str) -> Word {
    Word { name: name.into(), address: String::new(), picture: Picture::WHOLE }
}

/// Checks that the format of every word is known.
fn check_formats(lowering: &mut Lowering<'_>, formats: &Formats<'_>) {
    for (index, statement) in lowering.statements() {
        let ControllerStatement::Word { format, .. } = statement else { continue };
        if !formats.contains_key(format.value.as_str()) {
            report_unknown(lowering, formats, index, format);
        }
    }
}

fn report_unknown(lowering: &mut Lowering<'_>, formats: &Formats<'_>, index: usize, format: &Name) {
    let known: Vec<&str> = formats.keys().copied().collect();
    let label = if known.is_empty() { "none is defined".to_owned() } else { format!("known: {}", known.join(", ")) };
    let place = lowering.place(index, &format.span);
    let message = format!("no format is called `{}`", format.value);
    let mut diagnostic = Diagnostic::error(&UNKNOWN_FORMAT, message).at(place.clone(), label);
    if let Some(meant) = nearest(&format.value, known) {
        let text = format!("did you mean `{meant}`?");
        diagnostic = diagnostic.suggest(Suggestion { text, place, replacement: meant.to_owned() });
    }
    lowering.diagnostics.push(diagnostic);
}
