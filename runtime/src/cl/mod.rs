//! CL data: NX CLSF text in, a toolpath out, as a stream.
//!
//! [`Reader`] takes the text apart: bytes to lines (`source`), lines to records (`record`, `argument`), records to motion
//! (`motion`) and settings (`setting`). What each record means stands in one list (`words`); those that ask in vain
//! are told (`not_used`). Lines that hold a GOTO and nothing else, the bulk of every file, take a shortcut (`plain`).

mod arc;
mod argument;
mod free_text;
mod motion;
mod not_used;
mod number;
mod once;
mod plain;
mod quote;
mod range;
mod reader;
mod record;
mod setting;
mod source;
mod told;
mod toolpath;
mod words;

use crate::diagnostic::Code;

pub use quote::quote;
pub use reader::{Next, Reader, ReaderOptions};
pub use toolpath::Toolpath;

/// Every kind of diagnostic that reading CL text raises.
pub static CODES: &[&Code] = &[
    &record::NOT_TEXT,
    &record::TOO_LONG,
    &record::CUT_RECORD,
    &reader::CUT_OPERATION,
    &reader::NO_MOTION,
    &reader::BEHIND_FINI,
    &told::TOO_MANY,
    &words::UNKNOWN_RECORD,
    &words::NOT_SUPPORTED,
    &argument::MISSING_ARGUMENT,
    &argument::NOT_A_NUMBER,
    &setting::UNKNOWN_WORD,
    &range::OUT_OF_RANGE,
    &motion::pose::ZERO_VECTOR,
    &motion::circle::OFF_CIRCLE,
    &motion::circle::OPEN_ARC,
    &motion::circle::TILTING_ARC,
    &motion::FLAT_FRAME,
    &motion::pose::NOT_UNIT,
    &setting::MIXED_UNITS,
    &setting::OTHER_UNITS,
    &once::INSERTED,
    &told::MANY_WARNINGS,
    &words::UNKNOWN_RECORD_LEFT_OUT,
    &not_used::NOT_USED,
];
