//! CL data: NX CLSF text in, a toolpath of events out, as a stream.
//!
//! [`Reader`] takes the text apart: bytes to lines (`source`), lines to records (`record`), records to motion (`motion`,
//! `arc`) and settings (`setting`). What each record means stands in one list (`words`).

mod arc;
pub mod event;
mod motion;
mod number;
mod plain;
mod quote;
mod reader;
mod record;
mod setting;
mod source;
mod words;

use crate::diagnostic::Code;

pub use quote::quote;
pub use reader::{Next, Reader, ReaderOptions};

/// Every kind of diagnostic that reading CL text raises.
pub static CODES: &[&Code] = &[
    &record::NOT_TEXT,
    &record::TOO_LONG,
    &record::CUT_RECORD,
    &reader::CUT_OPERATION,
    &reader::NO_MOTION,
    &reader::TOO_MANY,
    &words::UNKNOWN_RECORD,
    &words::NOT_SUPPORTED,
    &record::MISSING_ARGUMENT,
    &record::NOT_A_NUMBER,
    &setting::UNKNOWN_WORD,
    &motion::OUT_OF_RANGE,
    &motion::ZERO_VECTOR,
    &motion::OFF_CIRCLE,
    &motion::OPEN_ARC,
    &motion::TILTING_ARC,
    &motion::FLAT_FRAME,
    &motion::ODD_FRAME,
    &motion::NOT_UNIT,
    &setting::MIXED_UNITS,
    &motion::INSERTED,
    &reader::MANY_WARNINGS,
    &words::UNKNOWN_RECORD_LEFT_OUT,
];
