//! A travel with its ends the wrong way round, or with nothing between them.

use crate::diagnostic::{Code, Diagnostic, Suggestion};
use crate::model::draft::{AxisDraft, Draft};
use crate::model::quantity::readable;
use crate::model::source::Located;
use mach_runtime::machine::Motion;

/// A travel that is upside down.
pub(crate) static UPSIDE_DOWN: Code = Code {
    id: "E0305",
    title: "the travel is upside down",
    explanation: "\
A travel goes from its lower to its upper end, and there is something between them.

    linear Z along +z travel 60 .. -450       // -450 .. 60
    rotary A about +x travel 30 .. 30 deg     // an axis that cannot move

An axis that stands still in every program does not belong into the machine.
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    let travels = draft.axes.iter().filter_map(|axis| Some((axis, axis.travel.as_ref()?)));
    let wrong = travels.filter(|(_, travel)| travel.value[0] >= travel.value[1]);
    wrong.map(|(axis, travel)| report(draft, axis, travel)).collect()
}

fn report(draft: &Draft<'_>, axis: &AxisDraft, travel: &Located<[f64; 2]>) -> Diagnostic {
    let name = &axis.name.value;
    let [upper, lower] = travel.value;
    if lower == upper {
        let message = format!("{name} cannot move: its travel is empty");
        return super::error(draft, &UPSIDE_DOWN, message, &travel.at, "from here to here");
    }
    let unit = if axis.motion == Motion::Linear { "mm" } else { "deg" };
    let replacement = format!("travel {} .. {} {unit}", readable(lower), readable(upper));
    let suggestion = Suggestion {
        text: "the lower end comes first".to_owned(),
        place: draft.sources.place(&travel.at),
        replacement,
    };
    let message = format!("the travel of {name} is upside down");
    super::error(draft, &UPSIDE_DOWN, message, &travel.at, "its lower end is above its upper end").suggest(suggestion)
}
