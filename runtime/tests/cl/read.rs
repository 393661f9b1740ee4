//! Reads a whole CL text for the tests.

use mach_runtime::cl::{Next, Reader, ReaderOptions};
use mach_runtime::diagnostic::Diagnostic;
use mach_runtime::toolpath::{Command, Point};

/// All that a CL text gives.
#[derive(Default)]
pub(crate) struct Read {
    pub(crate) points: Vec<Point>,
    pub(crate) from: Vec<Point>,
    pub(crate) commands: Vec<Command>,
    pub(crate) diagnostics: Vec<Diagnostic>,
}

impl Read {
    pub(crate) fn codes(&self) -> Vec<&'static str> {
        self.diagnostics.iter().map(|diagnostic| diagnostic.code.id).collect()
    }

    pub(crate) fn tips(&self) -> Vec<[f64; 3]> {
        self.points.iter().map(|point| point.tip_mm).collect()
    }
}

pub(crate) fn read(text: impl AsRef<[u8]>) -> Read {
    read_with(text, ReaderOptions::default())
}

pub(crate) fn read_with(text: impl AsRef<[u8]>, options: ReaderOptions) -> Read {
    let mut reader = Reader::new("part.cls", text.as_ref(), options);
    let mut all = Read::default();
    loop {
        match reader.next_into(&mut all.points, 64).expect("a slice can be read") {
            Next::Full => {}
            Next::From(point) => all.from.push(point),
            Next::Command(command, _) => all.commands.push(command),
            Next::Diagnostic(diagnostic) => all.diagnostics.push(diagnostic),
            Next::End => return all,
        }
    }
}
