//! A comparison as tables for people.

use mach_runtime::certificate::Range;
use mach_runtime::kinematics::Miss;
use mach_runtime::number::fixed;
use machc::compare::{Apart, Comparison, Count, Refusal, Way, WordChange};

pub(super) fn comparison(comparison: &Comparison, files: [&str; 2], cl: &str) -> String {
    let [old, new] = files;
    let head = match (comparison.is_same(), comparison.changed.points) {
        (true, _) => format!("the same motion at all {} points of {cl}\n", comparison.points),
        (false, changed) => format!("other words at {changed} of the {} points of {cl}\n", comparison.points),
    };
    let refused = refused(&comparison.old, old) + &refused(&comparison.new, new);
    let differences =
        if comparison.is_same() { Vec::new() } else { vec![words(comparison, files), branch(comparison)] };
    [head, refused, differences.concat(), tool(comparison), margins(comparison)].concat()
}

/// In a few words.
pub(super) fn reason(refusal: &Refusal) -> String {
    match refusal {
        Refusal::Missed(Miss::OutOfReach { .. }) => "the direction is out of reach".to_owned(),
        Refusal::Missed(Miss::InsideDeadRadius { .. } | Miss::OffPlane { .. }) => {
            "the point is off the plane of the two linear axes".to_owned()
        }
        Refusal::Missed(Miss::Singular) => "the linear axes cannot hold the tip there".to_owned(),
        Refusal::Missed(Miss::NotCompensated) => "no joints put the tip there with the machine's errors".to_owned(),
        Refusal::Travel(axis) => format!("{axis} beyond its travel"),
        Refusal::Word(axis) => format!("the word {axis} is too narrow"),
    }
}

fn refused(way: &Way, file: &str) -> String {
    let Some(refusal) = &way.refusal else { return String::new() };
    format!("{file} cannot go to {}: {}\n", counted(&way.refused), reason(refusal))
}

fn words(comparison: &Comparison, [old, new]: [&str; 2]) -> String {
    let mut text =
        format!("\n{:<8}{:>8}{:>20}{:>9}{:>13}{:>13}\n", "word", "points", "largest change", "line", "old", "new");
    for word in &comparison.words {
        text += &row(word);
    }
    for (names, file) in [(&comparison.only_old, old), (&comparison.only_new, new)] {
        text.extend(names.iter().map(|name| format!("{name:<8}only in {file}\n")));
    }
    text
}

fn row(word: &WordChange) -> String {
    let WordChange { name, motion, points, largest, old, new } = word;
    if *points == 0 {
        return format!("{name:<8}{:>8}\n", "-");
    }
    let by = format!("{:.4} {}", largest.value, motion.unit());
    format!("{name:<8}{points:>8}{by:>20}{:>9}{:>13}{:>13}\n", largest.line, fixed(*old, 4), fixed(*new, 4))
}

fn tool(comparison: &Comparison) -> String {
    let row = |title: &str, apart: &Apart| {
        if apart.tip_mm.line == 0 {
            return format!("{title:<30}{:>16}{:>24}\n", "-", "-");
        }
        let tip = format!("{:.6} mm", apart.tip_mm.value);
        let axis = format!("{:.6} deg", apart.axis_rad.value.to_degrees());
        format!("{title:<30}{tip:>16}{:>6}{axis:>18}{:>6}\n", apart.tip_mm.line, apart.axis_rad.line)
    };
    let head =
        format!("\n{:<30}{:>16}{:>6}{:>18}{:>6}\n", "in the workpiece", "tip apart", "line", "axis apart", "line");
    let old_words = comparison.old_words.as_ref().map(|apart| row("old words on new, from the CL", apart));
    [head, row("old and new, each by its words", &comparison.apart), old_words.unwrap_or_default()].concat()
}

fn branch(comparison: &Comparison) -> String {
    let solution = match &comparison.branch {
        None => "not compared: other rotary axes\n".to_owned(),
        Some(Count { points: 0, .. }) => "the same at every point\n".to_owned(),
        Some(count) => format!("the other one at {}\n", counted(count)),
    };
    let turned = comparison.words.iter().zip(&comparison.turns).filter(|(_, turns)| turns.points > 0);
    let turned = turned.map(|(word, turns)| format!("whole turns of {:<6}{}\n", word.name, counted(turns)));
    format!("\nrotary solution      {solution}{}", turned.collect::<String>())
}

fn margins(comparison: &Comparison) -> String {
    let Comparison { old, new, .. } = comparison;
    let both = old.ranges.iter().filter_map(|a| {
        let b = new.ranges.iter().find(|b| (&b.axis.name, b.axis.motion) == (&a.axis.name, a.axis.motion))?;
        Some(margin_row(a, b))
    });
    let head = format!("\n{:<16}{:>14}{:>14}{:>14}{:>14}\n", "to the limits", "lower, old", "new", "upper, old", "new");
    head + &both.collect::<String>()
}

fn margin_row(old: &Range, new: &Range) -> String {
    let margin = |margin: f64, range: &Range| match (range.is_visited(), margin.is_finite()) {
        (false, _) => "-".to_owned(),
        (_, false) => "no limit".to_owned(),
        (_, true) => fixed(margin, 3),
    };
    let [a, b] = [margin(old.lower_margin(), old), margin(new.lower_margin(), new)];
    let [c, d] = [margin(old.upper_margin(), old), margin(new.upper_margin(), new)];
    let axis = format!("{}, {}", old.axis.name, old.axis.motion.unit());
    format!("{axis:<16}{a:>14}{b:>14}{c:>14}{d:>14}\n")
}

fn counted(count: &Count) -> String {
    let points = if count.points == 1 { "1 point".to_owned() } else { format!("{} points", count.points) };
    format!("{points}, first at line {}", count.first_line)
}
