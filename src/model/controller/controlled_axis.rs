//! What a controller has to know of an axis.

use mach_runtime::machine::Motion;

/// An axis of its machine.
#[derive(Debug, Clone, Copy)]
pub struct ControlledAxis<'a> {
    /// Its name.
    pub name: &'a str,
    /// How it moves.
    pub motion: Motion,
}
