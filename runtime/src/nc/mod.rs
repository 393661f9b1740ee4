//! NC text: the dialect's tables, and the writer that prints by them.

pub mod axis_word;
pub mod dialect;
mod digits;
mod feed_word;
mod line;
mod motion_block;
mod moves;
mod numbering;
pub mod picture;
mod printed_word;
mod rounding;
mod short_word;
pub mod text;
mod values;
pub mod write_error;
pub mod writer;
mod written_axes;
