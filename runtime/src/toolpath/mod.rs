//! The toolpath, the part side: what shall be done, whoever asks. Readers of CL make it; the path, the writer and the comparison
//! see it and nothing of the CL's text.
//!
//! Lengths are in millimetres and in one frame, that of the program zero; what was modal in the CL is resolved, and each item
//! knows the line that it comes from.

mod command;
mod item;
mod point;
mod state;
mod text;

pub use command::{Command, Coolant, Spindle};
pub use item::{Item, What};
pub use point::{Approach, Feed, Point};
pub use state::{LoadedTool, State};
pub use text::ToolpathText;
