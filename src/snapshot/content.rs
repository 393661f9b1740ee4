//! What is locked of a program on a machine: the machine file, what was told, the certificate, the NC text.

use crate::plan::{Interpreter, Plan};
use mach_runtime::cl::{Reader, ReaderOptions, quote};
use mach_runtime::machine::Machine;
use mach_runtime::nc::dialect::Dialect;
use mach_runtime::post::{Job, post};
use mach_runtime::render::{Style, render};
use std::num::NonZeroUsize;
use std::path::Path;

/// A program and the machine that it is posted for.
#[derive(Debug, Clone, Copy)]
pub struct Program<'a> {
    /// The machine file's name.
    pub machine_file: &'a str,
    /// Its text.
    pub machine_text: &'a str,
    /// The machine's tables.
    pub machine: &'a Machine,
    /// What was derived of it.
    pub plan: &'a Plan,
    /// Its controller.
    pub dialect: &'a Dialect,
    /// The CL file's name; without folder and extension it is the program's name.
    pub cl_file: &'a str,
    /// What the CL file holds.
    pub cl: &'a [u8],
}

/// Posts the program, and says what came out: a refusal is as good as a program.
pub fn content(program: &Program<'_>) -> String {
    let Program { machine_file, machine_text, machine, plan, dialect, cl_file, cl } = *program;
    let name = Path::new(cl_file).file_stem().and_then(|stem| stem.to_str()).unwrap_or(&machine.name);
    let options = ReaderOptions::of(machine);
    let job = Job { file: cl_file, program: name, machine, dialect };
    let (mut nc, mut diagnostics) = (Vec::new(), Vec::new());
    let mut tell = |diagnostic| diagnostics.push(diagnostic);
    let (kinematics, reader) = (Interpreter::new(plan), Reader::new(cl_file, cl, options));
    let certificate = post(job, &kinematics, reader, &mut nc, NonZeroUsize::MIN, &mut tell)
        .expect("reading from and writing to memory does not fail");
    quote(&mut diagnostics, cl_file, cl).expect("reading from memory does not fail");
    let told = render(&diagnostics, Style::PLAIN);
    let mut text = format!("==== {machine_file}\n{machine_text}\n==== {cl_file}\n{told}");
    if let Some(certificate) = certificate {
        let (bytes, fingerprint) = (nc.len(), fingerprint(&nc));
        let nc = String::from_utf8_lossy(&nc);
        text += &format!("{certificate}\n==== NC, {bytes} bytes, FNV-1a {fingerprint:016x}\n{nc}");
    }
    text
}

/// FNV-1a: tells line ends apart, which the comparison of snapshots does not.
fn fingerprint(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}
