//! More or fewer axes than machc can solve, as the pose decides them.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::{AxisDraft, Draft};
use mach_runtime::machine::Motion;

/// Too few axes.
pub(crate) static NOT_SUPPORTED: Code = Code {
    id: "E0306",
    title: "too few axes",
    explanation: "\
A pose of the tool decides where the axes are if there are three linear axes, with none, one or two rotary axes, in any
order and in any direction, or two linear axes and one rotary axis (a turning centre without Y).

    chain w C b X Z t            // X Z C: C turns the point to where X and Z reach it

Axes of which a `branch` block says `lock`, `prefer` or `free` do not count.
",
};

/// Axes that nothing decides.
pub(crate) static SURPLUS: Code = Code {
    id: "E0311",
    title: "the machine has more axes than a pose decides",
    explanation: "\
A pose of the tool decides three linear and two rotary axes, or, with two linear axes, one rotary. Where a machine has
more, its `branch` block says of each one too many what it does:

    branch {
        lock   W 0 mm        // it always stands there
        prefer A 0 deg       // it stands there wherever the point can be reached so
        free   A             // it stays where it is while the point can be reached so
    }

Where the point cannot be reached with the axis where it is wanted, the nearest position is taken with which it can, in
steps of a millimetre or a degree. The axes of which nothing is said are those that the pose decides.
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    if draft.axes.is_empty() || !draft.knows_solved() {
        return Vec::new();
    }
    let (linear, rotary) = (draft.solved(Motion::Linear), draft.solved(Motion::Rotary));
    let most_rotary = if linear.len() == 2 { 1 } else { 2 };
    let mut found = Vec::new();
    // A rule for an axis that is not there was meant for one of the others, and is told: nobody knows which are left.
    let is_known = draft.ruled.iter().all(|ruled| draft.axis(&ruled.axis.value.value).is_some());
    if is_known && linear.len() > 3 {
        found.push(too_many(draft, &linear, 3, "linear"));
    }
    if is_known && rotary.len() > most_rotary {
        found.push(too_many(draft, &rotary, most_rotary, "rotary"));
    }
    if linear.len() < 2 || linear.len() == 2 && rotary.is_empty() {
        let count = linear.len();
        let axes = if count == 1 { "axis is" } else { "axes are" };
        let message = format!("{count} linear {axes} too few: it takes three, or two and a rotary axis");
        let error = super::error(draft, &NOT_SUPPORTED, message, &draft.name.at, "");
        found.push(linear.iter().fold(error, |error, axis| error.at(draft.sources.place(&axis.name.at), "")));
    }
    found
}

/// More axes of one motion than the pose decides.
fn too_many(draft: &Draft<'_>, axes: &[&AxisDraft], most: usize, motion: &str) -> Diagnostic {
    let names: Vec<&str> = axes.iter().map(|axis| axis.name.value.as_str()).collect();
    let beside = if motion == "rotary" && most == 1 { " beside two linear ones" } else { "" };
    let surplus = axes.len() - most;
    let number =
        |count: usize| ["no", "one", "two", "three"].get(count).map_or(count.to_string(), |&word| word.to_owned());
    let message = format!(
        "{} {motion} axes{beside}: a pose decides {}, and nothing is said of the other{}",
        axes.len(),
        number(most),
        if surplus == 1 { "" } else { "s" }
    );
    let error = Diagnostic::error(&SURPLUS, message);
    let marked = axes.iter().fold(error, |error, axis| error.at(draft.sources.place(&axis.name.at), ""));
    let (last, unit) = (names[names.len() - 1], if motion == "linear" { "mm" } else { "deg" });
    let marked = marked.note(format!(
        "say of {} of {} what it does, for example `branch {{ lock {last} 0 {unit} }}`",
        number(surplus),
        names.join(", ")
    ));
    if motion == "rotary" && most == 1 { marked } else { marked.note("`prefer` and `free` let it move where it must") }
}
