//! Points that the machine cannot go to, as diagnostics.

use super::job::Job;
use crate::branch::{Candidate, Obstacle};
use crate::diagnostic::{Code, Diagnostic, Place};
use crate::kinematics::Miss;
use crate::machine::{Axis, Motion, Rule, Travel};
use crate::path::{Jump, NoWay, Solved};
use crate::strictness::Strictness;

/// E1101.
pub static OUT_OF_REACH: Code = Code {
    id: "E1101",
    title: "the tool cannot be turned into this direction",
    explanation: "\
The machine's rotary axes cannot turn the tool, or the workpiece under it, so that the tool axis has the direction that
the CL asks for. `machc show MACHINE` prints the cone of directions that it can reach.

A three-axis machine reaches one direction only, a four-axis machine those of a cone. A nutating head or table reaches
a cone about its first rotary axis.

Turn the workpiece or use another machine. A solver that iterates (`--solver newton`, `--solver broyden`) says this too where
it finds no way. If the CL is only rounded too coarsely, widen the tolerance:

    tolerance axis 0.01 deg",
};

/// E1102.
pub static OUT_OF_TRAVEL: Code = Code {
    id: "E1102",
    title: "the point is out of the machine's travel",
    explanation: "\
The tool can be turned into the wanted direction, but every way of doing so takes an axis beyond its travel. The message
names the axis of the solution that is least beyond.

Move the workpiece (the program zero, `zero (x, y, z)`), check the tool length, or check the `travel` of the axis in the
machine file.",
};

/// E1103.
pub static REPOSITION: Code = Code {
    id: "E1103",
    title: "the travel forces a reposition in the middle of a cut",
    explanation: "\
To go on within the travel of its axes the machine would have to turn back by whole turns, or change to the other
solution of its rotary axes, between two points of a cut. The tool would be in the workpiece all the while. So it would
while an axis moves that the pose leaves open (`prefer`, `free`), because the machine has no way on where it stands.

Start the operation at another angle (`branch { start … }`), split it where the tool may retract, or, if the motion is
known to be harmless, let it pass with a warning:

    branch {
        reposition warn
    }",
};

/// E1104.
pub static SINGULAR: Code = Code {
    id: "E1104",
    title: "the linear axes cannot hold the tip at this angle",
    explanation:
        "\
A rotary axis stands between the linear axes, and at this angle it has turned them so that they no longer span space: no
motion of the linear axes puts the tip where it should be. `machc show MACHINE` tells the chain. Use another direction.",
};

/// E1120.
pub static NOT_COMPENSATED: Code = Code {
    id: "E1120",
    title: "no joints were found that put the tip there with the machine's errors",
    explanation: "\
The machine has tables of errors, and they are compensated by moving the axes a little, looking up the errors there, and
so on until nothing changes. Here it does not come to rest: a table changes too fast from one position to the next (by
a good part of the distance between them), or no linear axis moves the way that the error goes.

Look for a wrong unit or a wrong row in the tables (`machc show MACHINE` prints their ranges).",
};

/// E1105.
pub static TOO_MANY_ERRORS: Code = Code {
    id: "E1105",
    title: "too many errors",
    explanation: "After 20 errors in one CL file the post gives up. Mend the first ones and post again.",
};

/// E1107.
pub static INSIDE_DEAD_RADIUS: Code = Code {
    id: "E1107",
    title: "the point is inside the dead radius",
    explanation: "\
The machine has two linear axes, and a rotary axis makes up for the third: it turns the point into the plane in which the
linear axes move the tool. Where that plane does not hold the axis of the rotary (because the tool is set beside it, or
the ways are skewed), no angle brings points near the centre into it. `machc show MACHINE` tells the radius.

Set the tool over the centre of the rotary axis, or use a machine with a Y axis.",
};

/// E1108.
pub static OFF_PLANE: Code = Code {
    id: "E1108",
    title: "the point is off the plane of the two linear axes",
    explanation: "\
The machine has two linear axes. With the rotary axis turned so that the tool has the wanted direction, the point does
not lie in the plane in which these two move the tip: it would take a third one, a Y axis.

On a turning centre with the driven tool along X, the tool axis of every point must pass through the axis of the spindle.
If the CL is only rounded too coarsely, widen the tolerance:

    tolerance plane 0.01 mm",
};

/// W1103.
pub static REPOSITION_WARNING: Code = Code {
    id: "W1103",
    title: "the travel forces a reposition in the middle of a cut",
    explanation: "\
The machine turns back by whole turns, or changes to the other solution of its rotary axes, between two points of a cut,
because its travel ends. The machine file lets it pass (`reposition warn`); look at the place before you run the program.",
};

/// W1104.
pub static NO_FEED_RATE: Code = Code {
    id: "W1104",
    title: "a motion at feed without a feed rate",
    explanation: "\
The CL moves at feed before it has given any FEDRAT. The blocks are written without a feed word, and most controls stop
there with an alarm. Give the feed rate in the CAM system.",
};

/// W1105.
pub static SPINDLE_STANDS: Code = Code {
    id: "W1105",
    title: "a motion at feed while the spindle stands",
    explanation: "\
The CL moves at feed before any SPINDL has switched the spindle on, or after SPINDL/OFF. The program is written so: the tool
goes into the material without turning, unless it is a probe or the machine's own programs switch the spindle on. Reported
once a file, and not for a controller without a block `on spindle clockwise`. Have the CAM system put out the speed:

    SPINDL/RPM,8000,CLW",
};

/// Why a point cannot be posted, if it cannot.
pub(super) fn of(job: Job<'_>, solved: &Solved<'_>) -> Option<Diagnostic> {
    let place = Place::line(job.file, solved.point.line);
    match solved.way() {
        Ok(_) => None,
        Err(NoWay::Missed(miss)) => Some(missed(job, solved, miss, place)),
        Err(NoWay::OutOfTravel(obstacle)) => Some(out_of_travel(job, solved, obstacle, place)),
    }
}

fn missed(job: Job<'_>, solved: &Solved<'_>, miss: Miss, place: Place) -> Diagnostic {
    let name = &job.machine.name;
    let error = |code, message, label: String| Diagnostic::error(code, message).at(place, label);
    match miss {
        Miss::OutOfReach { by_rad } => {
            let message = format!("`{name}` cannot turn the tool into this direction");
            let label = format!("{:.3} deg out of reach", by_rad.to_degrees());
            error(&OUT_OF_REACH, message, label).note(direction(solved))
        }
        Miss::InsideDeadRadius { gap_mm, radius_mm } => {
            let message = format!("`{name}` has two linear axes, and no angle brings the point to them");
            let label = format!("{gap_mm:.3} mm inside the dead radius of {radius_mm:.3} mm");
            error(&INSIDE_DEAD_RADIUS, message, label)
        }
        Miss::OffPlane { by_mm } => {
            let message = format!("`{name}` has two linear axes, and the point is off their plane");
            let label = format!("off the plane by {by_mm:.3} mm");
            error(&OFF_PLANE, message, label).note("it needs a Y axis")
        }
        Miss::NotCompensated => {
            let message = format!("no joints of `{name}` put the tip there with its errors");
            error(&NOT_COMPENSATED, message, String::new()).note(direction(solved))
        }
        Miss::Singular => {
            let message = format!("the linear axes of `{name}` cannot hold the tip at this angle");
            error(&SINGULAR, message, String::new()).note(direction(solved))
        }
    }
}

fn out_of_travel(job: Job<'_>, solved: &Solved<'_>, worst: Obstacle, place: Place) -> Diagnostic {
    let axes = &job.machine.axes;
    let obstacles = solved.candidates.iter().filter_map(|candidate| {
        let obstacle = candidate.obstacle?;
        Some((candidate.joints[obstacle.axis], obstacle))
    });
    let mut ways: Vec<String> =
        obstacles.map(|(value, obstacle)| beyond(&axes[obstacle.axis], value, obstacle.beyond)).collect();
    ways.dedup();
    let axis = &axes[worst.axis];
    let message = format!("the point is out of the travel of axis {}", axis.name);
    let label = format!("{} beyond the travel of {}", amount(axis, worst.beyond), axis.name);
    let error = Diagnostic::error(&OUT_OF_TRAVEL, message).at(place, label);
    let beginnings = if ways.len() > 1 { &["one way, ", "the other way, "][..] } else { &[""] };
    beginnings.iter().zip(ways).fold(error, |error, (beginning, way)| error.note(format!("{beginning}{way}")))
}

/// A point that can be posted, but only by a reposition in the cut.
pub(super) fn of_step(job: Job<'_>, solved: &Solved<'_>, chosen: &Candidate) -> Diagnostic {
    let text = match solved.jump {
        Some(_) => "a surplus axis jumps in the middle of a cut",
        None => "the travel forces a reposition in the middle of a cut",
    };
    let diagnostic = match job.machine.branch.reposition {
        Strictness::Error => Diagnostic::error(&REPOSITION, text),
        Strictness::Warn => Diagnostic::warning(&REPOSITION_WARNING, text),
    };
    let place = Place::line(job.file, solved.point.line);
    if let Some(jump) = solved.jump {
        return jumped(job, diagnostic.at(place, ""), jump);
    }
    let label = format!("the rotary axes turn by {:.3} deg to get here", chosen.rotary_travel_deg);
    let diagnostic = diagnostic.at(place, label);
    let blocked = solved.candidates.iter().find_map(|candidate| Some((candidate, candidate.obstacle?)));
    match blocked {
        Some((candidate, Obstacle { axis, beyond: by })) => {
            let way = beyond(&job.machine.axes[axis], candidate.joints[axis], by);
            diagnostic.note(format!("the other way is barred: {way}"))
        }
        None => diagnostic.note("it turns back by whole turns to stay within its travel"),
    }
}

/// A surplus axis moves.
fn jumped(job: Job<'_>, diagnostic: Diagnostic, Jump { axis, from, to }: Jump) -> Diagnostic {
    let axis = &job.machine.axes[axis];
    let way = format!("{} goes from {} to {}", axis.name, amount(axis, from), amount(axis, to));
    let why = match axis.rule {
        Rule::Preferred(value) if value == to => "back to where the machine file prefers it".to_owned(),
        _ => format!("the machine has no way to this point with {} at {}", axis.name, amount(axis, from)),
    };
    diagnostic.note(way).note(why)
}

fn direction(solved: &Solved<'_>) -> String {
    let [i, j, k] = solved.point.axis;
    format!("the wanted tool axis is ({i:.7}, {j:.7}, {k:.7})")
}

fn beyond(axis: &Axis, value: f64, by: f64) -> String {
    let (value, by) = (amount(axis, value), amount(axis, by));
    let Travel { lower, upper } = axis.travel;
    format!("{} would be at {value}, {by} beyond its travel {lower} .. {upper}", axis.name)
}

fn amount(axis: &Axis, value: f64) -> String {
    match axis.motion {
        Motion::Linear => format!("{value:.3} mm"),
        Motion::Rotary => format!("{value:.3} deg"),
    }
}
