//! A table of errors that is no function of the position.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::draft::{Draft, ErrorDraft, Measured, MeasuredRow};
use mach_runtime::machine::Motion;

/// Rows that do not make a table.
pub(crate) static ROWS: Code = Code {
    id: "E0321",
    title: "the rows of a table of errors do not fit each other",
    explanation: "\
A table of errors has at least one row, and its positions ascend.

    error EXX { at 0: 0  at 300: 4 um  at 100: 1 um }     // 100 is below 300

Of a rotary axis that spans a whole turn the first and the last row are the same position, and the same error:

    error EXC {
        at   0 deg: 2 um
        at 180 deg: -3 um
        at 360 deg: 2 um
    }
",
};

pub(crate) fn check(draft: &Draft<'_>) -> Vec<Diagnostic> {
    draft.errors.iter().filter_map(|error| report(draft, error)).collect()
}

fn report(draft: &Draft<'_>, error: &ErrorDraft) -> Option<Diagnostic> {
    let Measured::Table { rows, is_whole } = &error.measured else { return None };
    let name = &error.name.value;
    let (Some(first), Some(last)) = (rows.first(), rows.last()) else {
        if !is_whole {
            return None;
        }
        let message = format!("the table of {name} has no rows");
        return Some(super::error(draft, &ROWS, message, &error.name.at, "nothing was measured"));
    };
    let pair = |(a, b): (&MeasuredRow, &MeasuredRow), message: String, label: &str| {
        super::error(draft, &ROWS, message, &b.at, label).at(draft.sources.place(&a.at), "")
    };
    if let Some([a, b]) = rows.windows(2).find(|pair| pair[0].value.0 >= pair[1].value.0) {
        return Some(pair((a, b), format!("the positions of {name} do not ascend"), "not above the row before"));
    }
    let is_whole_turn = draft.axes[error.axis].motion == Motion::Rotary && last.value.0 - first.value.0 == 360.0;
    (*is_whole && is_whole_turn && first.value.1 != last.value.1).then(|| {
        pair((first, last), format!("{name} has two values at one position"), "a whole turn from the first row")
    })
}
