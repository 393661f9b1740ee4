//! Whatever a machine file says, the compiler answers: a model, or at least one diagnostic, and never a panic.

use super::{CONTROLLERS, TRUNNION, Texts};
use mach_command::render::plain;
use machc::compile::compile;
use std::collections::BTreeMap;

/// A token of the whole file in place of, or beside, another: as text that the file already has.
fn mutations(tokens: &[&str], index: usize) -> Vec<String> {
    let other = tokens[(index * 31 + 7) % tokens.len()];
    let with = |replacement: &[&str]| {
        let before = tokens[..index].iter().chain(replacement);
        before.chain(&tokens[index + 1..]).copied().collect::<Vec<_>>().join(" ")
    };
    let token = tokens[index];
    vec![with(&[]), with(&[token, token]), with(&[other]), with(&[other, token]), with(&["0"]), with(&["1e300", "mm"])]
}

#[test]
fn every_mutated_file_gets_an_answer() {
    let machine =
        TRUNNION.replace("    branch {", "    controller fine { word Z angle write A -180 .. 180 }\n    branch {");
    let spaced = ["(", ")", ","].iter().fold(machine, |text, mark| text.replace(mark, &format!(" {mark} ")));
    let text = format!("{CONTROLLERS} {spaced}");
    let tokens: Vec<&str> = text.split_whitespace().collect();
    let (mut models, mut refusals) = (0, 0);
    for mutation in (0..tokens.len()).flat_map(|index| mutations(&tokens, index)) {
        match compile("m.mach", &Texts(BTreeMap::from([("m.mach", mutation.clone())]))) {
            Ok(_) => models += 1,
            Err(diagnostics) => {
                assert!(!diagnostics.is_empty(), "refused in silence: {mutation}");
                assert!(!plain(&diagnostics).is_empty());
                refusals += 1;
            }
        }
    }
    assert!(models > 20 && refusals > 200, "{models} models, {refusals} refusals: the mutations do not mutate");
}
