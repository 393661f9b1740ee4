//! The records the reader knows, and what each of them means to it.

use crate::cl::argument::shortened;
use crate::cl::not_used;
use crate::cl::record::Record;
use crate::diagnostic::{Code, Diagnostic, Severity, Suggestion};
use crate::strictness::Strictness;

/// A record with an effect that the reader does not know how to carry out.
pub(super) static NOT_SUPPORTED: Code = Code {
    id: "E1011",
    title: "a record is not supported",
    explanation: "\
The record is known, and it changes where the tool goes or what the machine does, but it cannot be carried out. Leaving it
out would give another part, so the program is refused.

Let the CAM system put out plain motion instead: drilling cycles as single moves, curves as lines and circles, and no
cutter compensation.
",
};

/// A record that nobody knows.
pub(super) static UNKNOWN_RECORD: Code = Code {
    id: "E1010",
    title: "a record is not known",
    explanation: "\
The record's word is not in the reader's list, so nobody can say what leaving it out would do.

If it is misspelt, correct it. If it may be left out, say so in the machine file, and each is then only a warning:

    records unknown warn
",
};

/// A record that nobody knows, left out.
pub(super) static UNKNOWN_RECORD_LEFT_OUT: Code = Code {
    id: "W1010",
    title: "a record that is not known is left out",
    explanation: "\
The record's word is not in the reader's list, and the machine file says `records unknown warn`: the record has been left
out. Check that it has no effect on the motion. Each word is reported once.
",
};

/// What a record means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Meaning {
    Operation,
    EndOfPath,
    Frame,
    Units,
    From,
    Goto,
    Godlta,
    Gohome,
    Rapid,
    Circle,
    Feed,
    Spindle,
    Coolant,
    Load,
    Dwell,
    Stop,
    OptionalStop,
    Message,
    Insert,
    Fini,
    /// Without effect on the program: display, headings, tool data.
    Skipped,
    /// Without effect when it has no arguments but these; else not supported.
    SkippedWith(&'static [&'static str], &'static str),
    /// Known, with an effect (the text says what it is), and not supported.
    NotSupported(&'static str),
}

impl Meaning {
    /// Whether the tool goes somewhere by it, or is somewhere.
    pub(super) fn is_motion(self) -> bool {
        matches!(self, Self::From | Self::Goto | Self::Godlta | Self::Gohome | Self::Circle)
    }
}

use Meaning::{NotSupported, Skipped, SkippedWith};

const DRIVE: Meaning = NotSupported("motion along drive geometry");
const OTHER_ARC: Meaning = NotSupported("an arc in another system's notation");
const TURN: Meaning = NotSupported("a rotary move of its own");
const OTHER_TOOL: Meaning = NotSupported("a tool change in another system's notation");
const CURVE: Meaning = NotSupported("a spline");

/// In order of the words.
static RECORDS: &[(&str, Meaning)] = &[
    ("ARCDAT", OTHER_ARC),
    ("ARCMOV", OTHER_ARC),
    ("ARCSLP", OTHER_ARC),
    ("AUTOPS", DRIVE),
    ("AUXFUN", NotSupported("an auxiliary function")),
    ("CALSUB", NotSupported("a subroutine")),
    ("CCW", OTHER_ARC),
    ("CIRCLE", Meaning::Circle),
    ("CLAMP", NotSupported("clamping of an axis")),
    ("CLRSRF", Skipped),
    ("CNTRL", CURVE),
    ("COOLNT", Meaning::Coolant),
    ("COPY", NotSupported("a transformation of the motion")),
    ("COUPLE", NotSupported("coupled axes")),
    ("CUTCOM", SkippedWith(&["OFF"], "cutter compensation")),
    ("CUTTER", Skipped),
    ("CW", OTHER_ARC),
    ("CYCLE", SkippedWith(&["OFF"], "a drilling cycle")),
    ("DELAY", Meaning::Dwell),
    ("DISPLAY", Skipped),
    ("DRAW", Skipped),
    ("END", Skipped),
    ("END-OF-PATH", Meaning::EndOfPath),
    ("FEDRAT", Meaning::Feed),
    ("FINI", Meaning::Fini),
    ("FROM", Meaning::From),
    ("GO", DRIVE),
    ("GOBACK", DRIVE),
    ("GOCCLW", OTHER_ARC),
    ("GOCLW", OTHER_ARC),
    ("GODLTA", Meaning::Godlta),
    ("GODOWN", DRIVE),
    ("GOFWD", DRIVE),
    ("GOHOME", Meaning::Gohome),
    ("GOLFT", DRIVE),
    ("GORGT", DRIVE),
    ("GOTO", Meaning::Goto),
    ("GOUP", DRIVE),
    ("HEAD", NotSupported("a choice of head")),
    ("HELICAL", NotSupported("a helix in another system's notation")),
    ("INDIRP", DRIVE),
    ("INDIRV", DRIVE),
    ("INSERT", Meaning::Insert),
    ("INTOL", Skipped),
    ("KNOT", CURVE),
    ("LEADER", Skipped),
    ("LETTER", Skipped),
    ("LINTOL", Skipped),
    ("LOAD", Meaning::Load),
    ("LOADTL", OTHER_TOOL),
    ("LOCK_AXIS", NotSupported("a locked axis")),
    ("LPRINT", Skipped),
    ("MACHIN", Skipped),
    ("MODE", SkippedWith(&["MILL"], "a mode of the machine")),
    ("MODIFY", NotSupported("a change to other records")),
    ("MOVARC", OTHER_ARC),
    ("MSYS", Meaning::Frame),
    ("MULTAX", Skipped),
    ("NURBS", CURVE),
    ("OPSKIP", SkippedWith(&["OFF"], "optional blocks")),
    ("OPSTOP", Meaning::OptionalStop),
    ("ORIGIN", NotSupported("a shift of the motion")),
    ("OUTTOL", Skipped),
    ("PAINT", Skipped),
    ("PARTNO", Skipped),
    ("PEN", Skipped),
    ("PIVOTZ", NotSupported("a pivot length")),
    ("PLOT", Skipped),
    ("PLUNGE", NotSupported("a move of its own")),
    ("PPFUN", NotSupported("a post function")),
    ("PPRINT", Meaning::Message),
    ("PREFUN", NotSupported("a preparatory function")),
    ("PSIS", DRIVE),
    ("RAPID", Meaning::Rapid),
    ("REMARK", Skipped),
    ("RETRCT", NotSupported("a move of its own")),
    ("REWIND", NotSupported("a rewind of a rotary")),
    ("ROTABL", TURN),
    ("ROTATE", TURN),
    ("ROTHED", TURN),
    ("SELCTL", Skipped),
    ("SELECT", Skipped),
    ("SEQNO", Skipped),
    ("SET", SkippedWith(&["MODE", "ABSOL", "MILL", "LINEAR"], "a mode of the machine")),
    ("SPINDL", Meaning::Spindle),
    ("STOP", Meaning::Stop),
    ("SWITCH", NotSupported("another tracking point of the tool")),
    ("THREAD", NotSupported("thread cutting")),
    ("TLAXIS", NotSupported("a tool axis of its own")),
    ("TLDATA", Skipped),
    ("TLLFT", DRIVE),
    ("TLON", DRIVE),
    ("TLRGT", DRIVE),
    ("TMARK", Skipped),
    ("TOLER", Skipped),
    ("TOOL PATH", Meaning::Operation),
    ("TOOLNO", OTHER_TOOL),
    ("TPRINT", Skipped),
    ("TRACUT", NotSupported("a transformation of the motion")),
    ("TRANS", NotSupported("a transformation of the motion")),
    ("TURRET", OTHER_TOOL),
    ("UNIT", Meaning::Units),
    ("UNITS", Meaning::Units),
    ("UNLOAD", NotSupported("taking the tool out")),
    ("VCUT", Skipped),
    ("ZERO", NotSupported("a choice of work offset")),
];

/// What the record means; an error or a warning where nobody knows or nobody can do it.
pub(super) fn meaning(record: &Record, unknown: Strictness) -> Result<Meaning, Diagnostic> {
    let word = record.word();
    let Ok(index) = RECORDS.binary_search_by_key(&word.as_str(), |entry| entry.0) else {
        // What NX prints under a listing.
        return if word.starts_with("TOOL PATH LISTING HAS ") {
            Ok(Skipped)
        } else {
            Err(unknown_record(record, &word, unknown))
        };
    };
    let is_skipped = match RECORDS[index].1 {
        Skipped => true,
        SkippedWith(words, _) => (0..record.len()).all(|index| words.contains(&record.argument(index))),
        _ => false,
    };
    match RECORDS[index].1 {
        _ if is_skipped => not_used::warning(record, &word).map_or(Ok(Skipped), Err),
        SkippedWith(_, what) | NotSupported(what) => Err(not_supported(record, &word, what)),
        meaning => Ok(meaning),
    }
}

fn not_supported(record: &Record, word: &str, what: &str) -> Diagnostic {
    let message = format!("{word} is not supported: {what}");
    Diagnostic::error(&NOT_SUPPORTED, message).at(record.place(), "cannot be left out either")
}

fn unknown_record(record: &Record, word: &str, unknown: Strictness) -> Diagnostic {
    let message = match word {
        "" => "a record begins without a word".to_owned(),
        _ => format!("`{}` is not a record that is known", shortened(word)),
    };
    let diagnostic = match unknown {
        Strictness::Error => Diagnostic::error(&UNKNOWN_RECORD, message),
        Strictness::Warn => Diagnostic::warning(&UNKNOWN_RECORD_LEFT_OUT, message),
    };
    let label = if diagnostic.severity == Severity::Warning { "left out" } else { "not known" };
    let diagnostic = diagnostic.at(record.place(), label);
    match closest(word, RECORDS.iter().map(|entry| entry.0)) {
        Some(near) => diagnostic.suggest(Suggestion {
            text: format!("did you mean `{near}`?"),
            place: record.place(),
            replacement: near.to_owned(),
        }),
        None => diagnostic,
    }
}

/// The one of the known words that `word` may be a slip of.
pub(super) fn closest<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let most = if word.len() < 4 { 1 } else { 2 };
    if word.len() > 16 {
        return None;
    }
    let distances = known.map(|other| (strsim::damerau_levenshtein(word, other), other));
    distances.filter(|(distance, other)| *distance <= most && *distance < other.len()).min().map(|(_, other)| other)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_is_in_order() {
        assert!(RECORDS.is_sorted_by(|a, b| a.0 < b.0));
    }

    #[test]
    fn slips_are_recognised() {
        let known = || RECORDS.iter().map(|entry| entry.0);
        assert_eq!(closest("GOTP", known()), Some("GOTO"));
        assert_eq!(closest("FEDART", known()), Some("FEDRAT"));
        assert_eq!(closest("SIPNDL", known()), Some("SPINDL"));
        assert_eq!(closest("XYZZY", known()), None);
    }
}
