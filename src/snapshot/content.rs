//! What is locked of a program on a machine: the machine file, what was told, the certificate, the NC text.

use crate::plan::Interpreter;
use mach_runtime::diagnostic::Diagnostic;
use mach_runtime::rig::{Posted, Rig};

/// A program and the machine that it is posted for.
#[derive(Debug, Clone, Copy)]
pub struct Program<'a> {
    /// The machine file's name.
    pub machine_file: &'a str,
    /// Its text.
    pub machine_text: &'a str,
    /// The machine.
    pub rig: &'a Rig<Interpreter>,
    /// The CL file's name; without folder and extension it is the program's name.
    pub cl_file: &'a str,
    /// What the CL file holds.
    pub cl: &'a [u8],
    /// How diagnostics are told, as plain text.
    pub told: fn(&[Diagnostic]) -> String,
}

/// Posts the program, and says what came out: a refusal is as good as a program.
pub fn content(program: &Program<'_>) -> String {
    let Program { machine_file, machine_text, rig, cl_file, cl, told } = *program;
    let Posted { nc, certificate, diagnostics } = rig.post_text(cl_file, cl);
    let mut text = format!("==== {machine_file}\n{machine_text}\n==== {cl_file}\n{}", told(&diagnostics));
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
