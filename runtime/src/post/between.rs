//! What is told of a program whose tip leaves its lines between the points.

use super::job::Job;
use crate::certificate::Between;
use crate::diagnostic::{Code, Diagnostic, Place};

/// W1110.
pub static OFF_THE_LINE: Code = Code {
    id: "W1110",
    title: "between points the tip leaves its line",
    explanation: "\
The program gives axis values at the points of the CL, and between them the control moves every axis evenly. Where a rotary
axis turns, the tip then goes on a curve, not on the straight line from point to point; near a pole, or where the machine
changes to its other solution, far from it. The certificate states how far at most, as a bound that is proved and not
sampled; this warning counts the blocks of cuts in which it may be more than the machine's chord tolerance.

No points are put in. Ask the CAM system for shorter steps where the tool turns, or, if that much does no harm, say so:

    tolerance chord 0.05 mm",
};

/// A warning, if blocks of cuts are off their lines by more than the tolerance.
pub(super) fn warning(job: Job<'_>, between: &Between) -> Option<Diagnostic> {
    let tolerance_mm = job.machine.chord_tolerance_mm;
    let message = match between.beyond_tolerance {
        0 => return None,
        1 => format!("in one block of a cut the tip may leave its line by more than {tolerance_mm} mm"),
        blocks => format!("in {blocks} blocks of cuts the tip may leave its line by more than {tolerance_mm} mm"),
    };
    let place = Place::line(job.file, between.feed_mm.line);
    let label = format!("on the way here by at most {:.3} mm, the farthest", between.feed_mm.value);
    let warning = Diagnostic::warning(&OFF_THE_LINE, message).at(place, label);
    Some(warning.note("between points the axes move evenly, and no points are put in"))
}
