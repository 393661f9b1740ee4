//! Values of a machine's axes as a JSON object.

use mach_runtime::machine::Axis;
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

/// Axis names with their values, in the machine's order; `null` where a value is not known.
pub(super) struct AxisValues<'a> {
    pub(super) axes: &'a [Axis],
    pub(super) values: &'a [f64],
    /// The axes whose value is known, the first one in the lowest bit.
    pub(super) known: u64,
}

impl Serialize for AxisValues<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { axes, values, known } = self;
        let mut map = serializer.serialize_map(Some(values.len()))?;
        for (index, (axis, value)) in axes.iter().zip(*values).enumerate() {
            // Adding zero turns -0 into 0.
            let value = (known & 1 << index != 0).then_some(value + 0.0);
            map.serialize_entry(&axis.name, &value)?;
        }
        map.end()
    }
}
