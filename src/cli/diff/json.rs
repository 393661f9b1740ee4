//! A comparison as one JSON object.

use mach_runtime::certificate::{Extreme, Range};
use machc::compare::{Apart, Comparison, Count, Way, WordChange};
use serde_json::{Value, json};

use super::table::reason;

pub(super) fn comparison(comparison: &Comparison, files: [&str; 2]) -> Value {
    let turns = comparison.words.iter().zip(&comparison.turns).filter(|(_, turns)| turns.points > 0);
    let turns = turns.map(|(word, turns)| (word.name.clone(), count(turns))).collect::<serde_json::Map<_, _>>();
    json!({
        "type": "comparison",
        "old": way(&comparison.old, files[0]),
        "new": way(&comparison.new, files[1]),
        "same": comparison.is_same(),
        "points": comparison.points,
        "changed": count(&comparison.changed),
        "one_only": count(&comparison.one_only),
        "words": comparison.words.iter().map(word).collect::<Vec<_>>(),
        "only_old": comparison.only_old,
        "only_new": comparison.only_new,
        "apart": apart(&comparison.apart),
        "old_words_on_new": comparison.old_words.as_ref().map(apart),
        "branch": comparison.branch.as_ref().map(count),
        "turns": turns,
    })
}

fn count(count: &Count) -> Value {
    json!({ "points": count.points, "first_line": count.first_line })
}

fn extreme(extreme: &Extreme) -> Value {
    json!({ "value": extreme.value, "line": extreme.line })
}

fn apart(apart: &Apart) -> Value {
    json!({ "tip_mm": extreme(&apart.tip_mm), "axis_rad": extreme(&apart.axis_rad) })
}

fn word(word: &WordChange) -> Value {
    json!({
        "name": word.name,
        "unit": word.motion.unit(),
        "points": word.points,
        "largest": extreme(&word.largest),
        "old": word.old,
        "new": word.new,
    })
}

fn way(way: &Way, file: &str) -> Value {
    let margin = |margin: f64, range: &Range| (range.is_visited() && margin.is_finite()).then_some(margin);
    let axis = |range: &Range| {
        json!({
            "name": range.axis.name,
            "unit": range.axis.motion.unit(),
            "lower_margin": margin(range.lower_margin(), range),
            "upper_margin": margin(range.upper_margin(), range),
        })
    };
    json!({
        "file": file,
        "refused": count(&way.refused),
        "reason": way.refusal.as_ref().map(reason),
        "axes": way.ranges.iter().map(axis).collect::<Vec<_>>(),
    })
}
