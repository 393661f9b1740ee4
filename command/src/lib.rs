//! What a post is on the command line: arguments, files, progress, diagnostics, exit status. The compiler's own `post` and
//! every generated one are this.

pub mod files;
mod json;
pub mod outcome;
pub mod output;
pub mod post;
pub mod progress;
pub mod render;
pub mod report;
pub mod standalone;
pub mod toolpath;
