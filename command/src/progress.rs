//! How far the reading of a long file is.

use std::io::Read;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::report::Report;

/// Shorter files are done before anyone looks.
const LONG_BYTES: u64 = 8 << 20;

/// The input, watched by a bar on the terminal when it is long and someone is there to see it. The bar goes when the
/// input is dropped.
pub fn watched(input: Box<dyn Read>, bytes: Option<u64>, report: &Report) -> Box<dyn Read> {
    let Some(bytes) = bytes.filter(|bytes| *bytes >= LONG_BYTES && report.shows_progress()) else { return input };
    let style = ProgressStyle::with_template("{bar:32} {percent:>3} %  {bytes_per_sec}  {eta} left");
    let bar = ProgressBar::with_draw_target(Some(bytes), ProgressDrawTarget::stderr());
    let bar = bar.with_style(style.expect("the template is well formed"));
    Box::new(bar.with_finish(indicatif::ProgressFinish::AndClear).wrap_read(input))
}
