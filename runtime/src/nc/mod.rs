//! NC text: the dialect's tables (`dialect`), and the writer that prints by them (`writer`).
//!
//! What a motion prints is prepared when the program begins: its block (`motion_block`), its axes (`written_axes`), and of
//! each the word (`axis_word`, `printed_word`). Nearly all numbers are short and take a way without loops (`short_word`), as
//! sequence numbers do (`numbering`). Lines are put together in one place (`line`) and moved into the program as a whole.

pub mod axis_word;
pub mod dialect;
mod feed_word;
mod line;
mod motion_block;
pub mod moves;
mod numbering;
mod printed_word;
mod short_word;
pub mod text;
mod values;
pub mod write_error;
pub mod writer;
mod written_axes;
