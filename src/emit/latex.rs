//! The transformations of a machine as a Markdown page with LaTeX equations, for a person to read and to check by hand.

use super::data_sheet;
use super::measured;
use super::spelling::Spelling;
use super::transformation::{self, Inverse};
use crate::model::class;
use crate::model::machine::Model;
use crate::plan::Plan;
use std::fmt::Write;

/// What the symbols stand for.
const SYMBOLS: &str = "\
Tip (x, y, z) and unit tool axis (i, j, k), from the tip to the spindle, are in the workpiece: in the machine's frame with
every axis at zero. L is the tool's length. Lengths are in millimetres; atan2(y, x) is the angle of the point (x, y).
";

/// The whole page.
pub fn equations(model: &Model, plan: &Plan) -> String {
    let title = model.title.as_ref().map(|title| format!(": {title}")).unwrap_or_default();
    let mut page = format!("# {}{title}\n\n`{}`, {}\n", model.name, data_sheet::chain(model), class::class(model));
    list(&mut page, "Axes", model.axes.iter().map(data_sheet::axis));
    errors(&mut page, model);
    list(&mut page, "Constants", data_sheet::constants(model));
    heading(&mut page, "Forward transformation");
    write!(page, "\n{SYMBOLS}").expect("writing to a string does not fail");
    transformation::forward(model, plan, Spelling::Latex).iter().for_each(|lines| display(&mut page, lines));
    inverse(&mut page, transformation::inverse(model, plan, Spelling::Latex));
    list(&mut page, "Reach", data_sheet::reach(model, plan));
    page
}

/// What was measured, if anything was.
fn errors(page: &mut String, model: &Model) {
    let errors = measured::errors(model);
    if errors.is_empty() {
        return;
    }
    list(page, "Errors", errors);
    if !model.errors.tables.is_empty() {
        page.push_str(
            "\nThe equations are without the errors that depend on positions: those are compensated around them.\n",
        );
    }
}

fn inverse(page: &mut String, Inverse { given, shared, solutions, linear }: Inverse) {
    heading(page, "Inverse transformation");
    if let Some(given) = given {
        write!(page, "\n{}:\n", given.replacen('f', "F", 1)).expect("writing to a string does not fail");
    }
    display(page, &shared);
    if let [only] = &solutions[..] {
        display(page, only);
        display(page, &linear);
        return;
    }
    for (index, solution) in solutions.iter().enumerate() {
        write!(page, "\nSolution {}:\n", index + 1).expect("writing to a string does not fail");
        display(page, solution);
    }
    page.push_str("\nFor either solution:\n");
    display(page, &linear);
}

fn heading(page: &mut String, title: &str) {
    write!(page, "\n## {title}\n").expect("writing to a string does not fail");
}

fn list(page: &mut String, title: &str, items: impl IntoIterator<Item = String>) {
    heading(page, title);
    page.push('\n');
    items.into_iter().for_each(|item| writeln!(page, "- {item}").expect("writing to a string does not fail"));
}

/// Equations below each other, aligned at their signs.
fn display(page: &mut String, equations: &[String]) {
    if equations.is_empty() {
        return;
    }
    let lines: Vec<String> = equations.iter().map(|equation| equation.replacen(" = ", " &= ", 1)).collect();
    let lines = lines.join(" \\\\\n");
    write!(page, "\n$$\n\\begin{{aligned}}\n{lines}\n\\end{{aligned}}\n$$\n")
        .expect("writing to a string does not fail");
}
