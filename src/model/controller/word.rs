//! Formats and words of a controller.

use super::lowering::{Lowering, inside};
use super::picture::{self, BAD_PICTURE, PictureError};
use super::{Axis, LACKING};
use crate::syntax::spelling::nearest;
use crate::syntax::tree::{ControllerStatement, Name, Text};
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

/// An address that could be read as something else.
pub(super) static BAD_ADDRESS: Code = Code {
    id: "E0522",
    title: "an address that cannot be read",
    explanation: "\
The address of a word is one capital letter, or capital letters and digits with `=` behind them: with `C1` as the
address, `C15` could be `C1` with the number 5 or `C` with the number 15. No two words of a block can have one address.

    word X Y Z length
    word C1 angle as \"C1=\"
",
};

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
pub(super) fn axes(lowering: &mut Lowering<'_>, formats: &Formats<'_>, axes: &[Axis<'_>]) -> Vec<Word> {
    check_words(lowering, formats);
    let words: Vec<Word> = axes.iter().filter_map(|axis| required(lowering, formats, axis.name, axis.name)).collect();
    let mut first: BTreeMap<&str, &str> = BTreeMap::new();
    for word in words.iter().filter(|word| !word.address.is_empty()) {
        if let Some(other) = first.insert(&word.address, &word.name) {
            let message = format!("{other} and {} have the same address `{}`", word.name, word.address);
            let place = lowering.controller.at.clone();
            lowering.diagnostics.push(Diagnostic::error(&BAD_ADDRESS, message).at(place, "in this controller"));
        }
    }
    words
}

/// The feed word.
pub(super) fn feed(lowering: &mut Lowering<'_>, formats: &Formats<'_>) -> Word {
    required(lowering, formats, "F", "the feed").unwrap_or_else(|| nothing("F"))
}

/// The feed word a revolution, where the controller makes a difference.
pub(super) fn feed_per_revolution(lowering: &mut Lowering<'_>, formats: &Formats<'_>) -> Option<Word> {
    find(lowering, formats, "F_revolution")
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
fn find(lowering: &Lowering<'_>, formats: &Formats<'_>, name: &str) -> Option<Word> {
    let (_, (format, address)) = lowering.last(|statement| match statement {
        ControllerStatement::Word { names, format, address } => {
            names.iter().any(|said| said.value == name).then_some((format, address))
        }
        _ => None,
    })?;
    let plain = if name == "F_revolution" { "F" } else { name };
    let address = address.as_ref().map_or(plain, |address| address.value.as_str());
    let picture = formats.get(format.value.as_str()).cloned().flatten();
    Some(Word { name: plain.into(), address: address.into(), picture: picture.unwrap_or(Picture::WHOLE) })
}

/// Stands for a word that has been reported.
fn nothing(name: &str) -> Word {
    Word { name: name.into(), address: String::new(), picture: Picture::WHOLE }
}

/// Checks every word: its format is known, its address can be read.
fn check_words(lowering: &mut Lowering<'_>, formats: &Formats<'_>) {
    for (index, statement) in lowering.statements() {
        let ControllerStatement::Word { names, format, address: said } = statement else { continue };
        if !formats.contains_key(format.value.as_str()) {
            report_unknown(lowering, formats, index, format);
        }
        match said {
            Some(said) => address(lowering, index, said),
            None => names.iter().for_each(|name| own_name(lowering, index, name)),
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

/// Checks an address as it was said.
pub(super) fn address(lowering: &mut Lowering<'_>, index: usize, said: &Text) {
    if !is_readable(&said.value) {
        let message = format!("`{}` cannot be read as an address", said.value);
        lowering.report(&BAD_ADDRESS, message, index, &said.span, "one capital letter, or a longer name and `=`");
    }
}

/// Checks the name of an axis as its own address.
fn own_name(lowering: &mut Lowering<'_>, index: usize, name: &Name) {
    if !is_readable(&name.value) && name.value != "F_revolution" {
        let message = format!("`{}` cannot be read as an address", name.value);
        let label = format!("`as \"{}=\"` would be one", name.value.to_uppercase());
        lowering.report(&BAD_ADDRESS, message, index, &name.span, label);
    }
}

/// One capital letter, or more (with digits) before an equals sign.
fn is_readable(address: &str) -> bool {
    let name = address.strip_suffix('=').unwrap_or(address);
    let letter = name.starts_with(|c: char| c.is_ascii_uppercase());
    let rest = name.bytes().skip(1).all(|byte| byte.is_ascii_uppercase() || byte.is_ascii_digit());
    letter && rest && (name.len() == 1 || address.ends_with('='))
}
