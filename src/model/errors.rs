//! The measured errors of a machine, by their names of ISO 230-1 and ISO 230-7.

use mach_runtime::machine::{Component, ErrorTable};

/// Everything that was measured.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Errors {
    /// Where the lines of the axes are: these do not depend on positions.
    pub locations: Vec<LocationError>,
    /// What depends on where an axis is; axes are indices into [`Model::axes`](super::machine::Model::axes).
    pub tables: Vec<ErrorTable>,
}

/// A measured location error: one component of how the line of an axis lies beside where it should be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocationError {
    /// Index into [`Model::axes`](super::machine::Model::axes).
    pub axis: usize,
    /// Along or about which direction of the frame.
    pub component: Component,
    /// Millimetres or radians.
    pub value: f64,
}
