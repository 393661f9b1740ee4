//! CL data: NX CLSF text in, a toolpath of events out, as a stream.

pub mod event;
