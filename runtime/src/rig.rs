//! A machine that can be posted for, as one value.

use crate::certificate::Certificate;
use crate::cl::{Reader, ReaderOptions, quote};
use crate::diagnostic::Diagnostic;
use crate::kinematics::Kinematics;
use crate::machine::Machine;
use crate::nc::dialect::Dialect;
use crate::post::{Job, post};
use std::io::{self, Read, Write};
use std::num::NonZeroUsize;
use std::path::Path;

/// How a CL file is read that is posted for this machine.
pub fn reader_options(machine: &Machine) -> ReaderOptions {
    ReaderOptions {
        chord_tolerance_mm: machine.chord_tolerance_mm,
        unknown_records: machine.unknown_records,
        ..ReaderOptions::default()
    }
}

/// A machine, who solves for it, and how its controller wants to be written to.
#[derive(Debug, Clone)]
pub struct Rig<K> {
    /// The machine's tables.
    pub machine: Machine,
    /// Who solves for the machine without its position-dependent errors.
    pub kinematics: K,
    /// The controller's dialect.
    pub dialect: Dialect,
}

/// What posting CL text has given.
#[derive(Debug, Clone)]
pub struct Posted {
    /// The NC text; worth nothing without a certificate.
    pub nc: Vec<u8>,
    /// There when the input had no errors.
    pub certificate: Option<Certificate>,
    /// With the CL lines they speak of.
    pub diagnostics: Vec<Diagnostic>,
}

impl<K: Kinematics + Clone + Send> Rig<K> {
    /// Posts a CL file to `nc`; the user calls the file `file`, and the control the program `program`. Diagnostics go to
    /// `tell` as they come. The certificate is there when the input had no errors; without it what was written is worth
    /// nothing. What comes out does not depend on the number of threads. Two have work: one reads, reads back and compares,
    /// the other solves and prints.
    ///
    /// # Errors
    /// When the CL cannot be read or the NC text cannot be written.
    ///
    /// # Panics
    /// When the printed text cannot be read back: a defect of this program.
    pub fn post<R: Read>(
        &self,
        (file, program): (&str, &str),
        reader: Reader<R>,
        nc: &mut dyn Write,
        threads: NonZeroUsize,
        tell: &mut dyn FnMut(Diagnostic),
    ) -> io::Result<Option<Certificate>> {
        let job = Job { file, program, machine: &self.machine, dialect: &self.dialect };
        post(job, &self.kinematics, reader, nc, threads, tell)
    }

    /// Posts CL text; lengths without a unit are in millimetres. The program has the name of the file, without folder and
    /// extension, or the machine's where the file has none.
    pub fn post_text(&self, file: &str, cl: &[u8]) -> Posted {
        self.post_text_by(file, cl, NonZeroUsize::MIN)
    }

    /// The same on so many threads.
    ///
    /// # Panics
    /// See [`Self::post`].
    pub fn post_text_by(&self, file: &str, cl: &[u8], threads: NonZeroUsize) -> Posted {
        let program = Path::new(file).file_stem().and_then(|stem| stem.to_str()).unwrap_or(&self.machine.name);
        let reader = Reader::new(file, cl, reader_options(&self.machine));
        let (mut nc, mut diagnostics) = (Vec::new(), Vec::new());
        let mut tell = |diagnostic| diagnostics.push(diagnostic);
        let certificate = self
            .post((file, program), reader, &mut nc, threads, &mut tell)
            .expect("reading from and writing to memory does not fail");
        quote(&mut diagnostics, file, cl).expect("reading from memory does not fail");
        Posted { nc, certificate, diagnostics }
    }
}
