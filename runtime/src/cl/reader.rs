//! The reader: records in, points and commands out, one after the other.

use std::io::{self, Read};
use std::mem;

use crate::cl::arc::ArcPoints;
use crate::cl::motion::{Motion, Moved};
use crate::cl::plain::plain_goto;
use crate::cl::record::{Outcome, Record};
use crate::cl::setting::{self, FeedUnit, MIXED_UNITS};
use crate::cl::source::Source;
use crate::cl::told::Told;
use crate::cl::words::{Meaning, meaning};
use crate::diagnostic::{Code, Diagnostic, Place};
use crate::place::Frame;
use crate::strictness::Strictness;
use crate::toolpath::{Command, Point};
use crate::unit::LengthUnit;

/// The file ends too early.
pub(super) static CUT_OPERATION: Code = Code {
    id: "E1004",
    title: "an operation does not end",
    explanation: "\
Every `TOOL PATH/…` is closed by an `END-OF-PATH`. This one is not: the file, or a file that went into it, was cut off,
perhaps while it was being written or copied. Export it again.
",
};

/// Nothing to do.
pub(super) static NO_MOTION: Code = Code {
    id: "E1005",
    title: "the file has no motion",
    explanation: "\
There is no GOTO in the file: it is empty, or it is not the CL file that was meant.
",
};

/// Motion where none can be.
pub(super) static BEHIND_FINI: Code = Code {
    id: "E1007",
    title: "motion behind the end of the program",
    explanation: "\
FINI ends the program, and the file goes on with motion. Two files may have been joined, or FINI stands where it should not.
Nobody can say whether the motion behind it is meant: take it out, or FINI.
",
};

/// What the file does not say itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReaderOptions {
    /// The unit of lengths where the file has no UNITS record.
    pub length_unit: LengthUnit,
    /// How far a segment may leave an arc, in millimetres.
    pub chord_tolerance_mm: f64,
    /// What a record that nobody knows does.
    pub unknown_records: Strictness,
}

impl Default for ReaderOptions {
    /// Millimetres, arcs to 0.01 mm, unknown records refused.
    fn default() -> Self {
        Self { length_unit: LengthUnit::Millimetre, chord_tolerance_mm: 0.01, unknown_records: Strictness::Error }
    }
}

/// What comes after the points of one call.
#[derive(Debug, Clone, PartialEq)]
pub enum Next {
    /// As many points as were asked for; there may be more.
    Full,
    /// `FROM/`: where the tool stands; no motion.
    From(Point),
    /// A command, with the place it stands at.
    Command(Command, Place),
    /// A mistake or a warning. After an error, reading goes on so that further ones are found.
    Diagnostic(Diagnostic),
    /// The end of the file.
    End,
}

/// Reads CL text as a stream: memory does not grow with the file.
#[derive(Debug)]
pub struct Reader<R> {
    source: Source<R>,
    record: Record,
    motion: Motion,
    options: ReaderOptions,
    feed_unit: FeedUnit,
    has_units: bool,
    /// The rest of an arc, and the point it ends in.
    arc: Option<(ArcPoints, Point)>,
    /// Where the operation that is under way began.
    operation: Option<Place>,
    any_motion: bool,
    /// Where FINI stands, until motion behind it has been told.
    fini: Option<Place>,
    told: Told,
    /// The frames that the last call has met, each with the number of points before it, and its line.
    frames: Vec<(usize, u64, Frame)>,
    /// Diagnostics for the end of the file, last one first; there once the end is reached.
    last_words: Option<Vec<Diagnostic>>,
}

impl<R: Read> Reader<R> {
    /// A reader of the file that the user named so.
    pub fn new(file_name: &str, input: R, options: ReaderOptions) -> Self {
        Self {
            source: Source::new(input),
            record: Record::new(file_name),
            motion: Motion::new(options.length_unit, options.chord_tolerance_mm.max(1e-6)),
            options,
            feed_unit: FeedUnit::per_minute(options.length_unit),
            has_units: false,
            arc: None,
            operation: None,
            any_motion: false,
            fini: None,
            told: Told::default(),
            frames: Vec::new(),
            last_words: None,
        }
    }

    /// Appends up to `limit` points to `points`, and says what comes after them.
    ///
    /// # Errors
    /// When the input cannot be read.
    pub fn next_into(&mut self, points: &mut Vec<Point>, limit: usize) -> io::Result<Next> {
        let full = points.len() + limit;
        self.frames.clear();
        loop {
            if let Some(last_words) = &mut self.last_words {
                return Ok(last_words.pop().map_or(Next::End, Next::Diagnostic));
            }
            self.arc_points(points, full);
            self.plain_gotos(points, full)?;
            if points.len() >= full {
                return Ok(Next::Full);
            }
            let found = match self.record.read(&mut self.source)? {
                Outcome::Record => self.carry_out(points),
                Outcome::Fault(error) => Err(error),
                Outcome::Stop(error) => {
                    self.last_words = Some(Vec::new());
                    Err(error)
                }
                Outcome::End => {
                    self.last_words = Some(self.at_end());
                    Ok(None)
                }
            };
            match found {
                Ok(None) => {}
                Ok(Some(next)) => return Ok(next),
                Err(diagnostic) => {
                    let Some(diagnostic) = self.told.count(diagnostic, || self.record.word()) else { continue };
                    if let Some(last) = self.told.enough(&diagnostic) {
                        self.last_words = Some(vec![last]);
                    }
                    return Ok(Next::Diagnostic(diagnostic));
                }
            }
        }
    }

    /// The frames that the last call has met, in that of the program zero: each with how many points there were before it, and
    /// the line of its MSYS.
    pub fn frames(&self) -> &[(usize, u64, Frame)] {
        &self.frames
    }

    fn arc_points(&mut self, points: &mut Vec<Point>, full: usize) {
        let Some((arc, last)) = &mut self.arc else { return };
        while points.len() < full {
            let Some(tip_mm) = arc.next() else {
                self.arc = None;
                return;
            };
            points.push(Point { tip_mm, ..*last });
        }
    }

    /// The bulk of every file: lines that hold a GOTO and nothing else, taken without a copy.
    fn plain_gotos(&mut self, points: &mut Vec<Point>, full: usize) -> io::Result<()> {
        if self.motion.has_circle() || self.fini.is_some() {
            return Ok(());
        }
        while points.len() < full {
            let Some((tip, axis, length)) = plain_goto(self.source.whole_lines()?) else { break };
            let Some(point) = self.motion.plain_goto(tip, axis, self.source.line() + 1) else { break };
            self.source.take_line(length);
            points.push(point);
            self.any_motion = true;
        }
        Ok(())
    }

    /// Does what the record says. An error may be a warning: then the record has been carried out all the same.
    fn carry_out(&mut self, points: &mut Vec<Point>) -> Result<Option<Next>, Diagnostic> {
        let meaning = meaning(&self.record, self.options.unknown_records)?;
        if meaning.is_motion() {
            self.fini.take().map_or(Ok(()), |fini| Err(behind_fini(&self.record, fini)))?;
        }
        if self.motion.has_circle() && !matches!(meaning, Meaning::Goto | Meaning::Skipped) {
            self.motion.take_circle().map_or(Ok(()), Err)?;
        }
        let record = &self.record;
        let moved = match meaning {
            Meaning::Goto => self.motion.goto(record)?,
            Meaning::Godlta => self.motion.godlta(record)?,
            Meaning::Gohome => self.motion.gohome(record)?,
            Meaning::From => return self.motion.from(record).map(|point| Some(Next::From(point))),
            _ => {
                self.set(meaning)?;
                if meaning == Meaning::Frame {
                    self.frames.push((points.len(), self.record.last_line(), self.motion.placement.current()));
                }
                let command = self.command(meaning)?;
                return Ok(command.map(|command| Next::Command(command, self.record.place())));
            }
        };
        self.any_motion = true;
        match moved {
            Moved::To(point) => points.push(point),
            Moved::Along(arc, last) => self.arc = Some((arc, last)),
        }
        Ok(None)
    }

    /// What a record changes for those that follow it.
    fn set(&mut self, meaning: Meaning) -> Result<(), Diagnostic> {
        match meaning {
            Meaning::Circle => self.motion.circle(&self.record),
            Meaning::Frame => self.motion.frame(&self.record),
            Meaning::Feed => self.feed(),
            Meaning::Units => self.units(),
            Meaning::Rapid => {
                self.motion.rapid = true;
                Ok(())
            }
            Meaning::Operation => self.begin_operation(),
            Meaning::EndOfPath => {
                self.operation = None;
                Ok(())
            }
            Meaning::Fini => {
                self.fini = Some(self.record.place());
                Ok(())
            }
            Meaning::Insert => {
                self.motion.once.inserted(&self.record);
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// What a record hands on.
    fn command(&self, meaning: Meaning) -> Result<Option<Command>, Diagnostic> {
        let record = &self.record;
        Ok(Some(match meaning {
            Meaning::Operation => setting::operation(record),
            Meaning::Spindle => setting::spindle(record)?,
            Meaning::Coolant => setting::coolant(record)?,
            Meaning::Load => setting::load(record)?,
            Meaning::Dwell => setting::dwell(record)?,
            Meaning::Stop => Command::Stop,
            Meaning::OptionalStop => Command::OptionalStop,
            Meaning::Message | Meaning::Insert => Command::Message(setting::message(record)),
            _ => return Ok(None),
        }))
    }

    fn begin_operation(&mut self) -> Result<(), Diagnostic> {
        let place = self.record.place();
        let Some(open) = self.operation.replace(place.clone()) else { return Ok(()) };
        let error = Diagnostic::error(&CUT_OPERATION, "an operation begins inside another one");
        Err(error.at(place, "begins here").at(open, "this operation has no END-OF-PATH"))
    }

    fn feed(&mut self) -> Result<(), Diagnostic> {
        let (feed, unit) = setting::feed(&self.record, self.feed_unit)?;
        self.motion.feed = Some(feed);
        self.feed_unit = unit;
        let mixed = unit.is_inch() && !self.has_units && self.options.length_unit == LengthUnit::Millimetre;
        if !mixed {
            return Ok(());
        }
        let message = "the feed is in inches, and lengths are taken as millimetres";
        let warning = Diagnostic::warning(&MIXED_UNITS, message).at(self.record.place_of_all(), "a feed in inches");
        Err(warning.note("if the file's lengths are inches, give `--cl-units inch`"))
    }

    fn units(&mut self) -> Result<(), Diagnostic> {
        let unit = setting::units(&self.record)?;
        let changes = mem::replace(&mut self.motion.unit_mm, unit.mm()) != unit.mm();
        self.feed_unit = FeedUnit::per_minute(unit);
        self.has_units = true;
        if !(changes && self.any_motion) {
            return Ok(());
        }
        let warning = Diagnostic::warning(&setting::OTHER_UNITS, "the unit of lengths changes behind the first motion");
        Err(warning.at(self.record.place_of_all(), "lengths from here on"))
    }

    /// What is to be said at the end of the file, last one first.
    fn at_end(&mut self) -> Vec<Diagnostic> {
        let mut found = Vec::new();
        found.extend(self.motion.take_circle());
        if let Some(place) = self.operation.take() {
            let message = format!("the file ends at line {} inside an operation", self.source.line());
            let error = Diagnostic::error(&CUT_OPERATION, message);
            found.push(error.at(place, "this operation has no END-OF-PATH"));
        }
        if !self.any_motion && self.told.errors() == 0 && found.is_empty() {
            let error = Diagnostic::error(&NO_MOTION, "there is no motion in this file");
            found.push(error.at(self.record.place(), "the file ends here"));
        }
        found.extend(self.motion.once.take());
        found.reverse();
        found
    }
}

fn behind_fini(record: &Record, fini: Place) -> Diagnostic {
    let error = Diagnostic::error(&BEHIND_FINI, format!("{} stands behind FINI", record.word()));
    error.at(record.place(), "motion").at(fini, "the program ends here")
}
