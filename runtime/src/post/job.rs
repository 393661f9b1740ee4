//! What is posted, and for whom.

use crate::machine::Machine;
use crate::nc::dialect::Dialect;

/// A program for a machine.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Job<'a> {
    /// The CL file as the user named it.
    pub(crate) file: &'a str,
    /// The program's name.
    pub(crate) program: &'a str,
    /// The machine.
    pub(crate) machine: &'a Machine,
    /// Its controller.
    pub(crate) dialect: &'a Dialect,
}
