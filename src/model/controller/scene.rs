//! Where a line of a block stands.

use super::ControlledAxis;
use mach_runtime::nc::dialect::Trigger;

/// What a line stands in.
pub(super) struct Scene<'a> {
    /// The statement's index.
    pub(super) index: usize,
    pub(super) trigger: Trigger,
    pub(super) axes: &'a [ControlledAxis<'a>],
    pub(super) modal_groups: &'a [Vec<String>],
    pub(super) comment: &'a (String, String),
}
