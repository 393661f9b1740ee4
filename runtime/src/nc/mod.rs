//! NC text: the dialect's tables (`dialect`), and the writer that prints by them (`writer`).
//!
//! What a motion prints is prepared when the program begins: its block (`motion_block`), its axes (`written_axes`), and of
//! each the word (`axis_word`, `printed_word`). Nearly all numbers are short and take a way without loops (`short_word`), as
//! sequence numbers do (`numbering`). Lines are put together in one place (`line_buffer`) and moved into the program as a
//! whole.
//!
//! What the block of a command does beside what it is for is found by its words: whether it moves an axis (`moves`), and
//! whether it switches off the spindle or the coolant (`switches_off`).

pub mod axis_word;
pub mod dialect;
mod feed_word;
mod line_buffer;
mod motion_block;
pub mod moves;
mod numbering;
mod printed_word;
mod short_word;
mod switches_off;
pub mod text;
mod values;
pub mod write_error;
pub mod writer;
mod written_axes;
