//! Every order of three linear and two rotary axes, with every place of the bed: solved, or refused by name.

use machc::compile::{Compiled, compile};
use machc::sources::Sources;
use std::fmt::Write;

#[path = "common/closing.rs"]
mod closing;

/// 16 blocks of 64 poses.
const BLOCKS: usize = 16;

struct Text(String);

impl Sources for Text {
    fn read(&self, _: &str) -> Result<String, String> {
        Ok(self.0.clone())
    }
}

/// All orders of the letters.
fn orders(letters: &[&'static str]) -> Vec<Vec<&'static str>> {
    if letters.is_empty() {
        return vec![vec![]];
    }
    let with_first = |place: usize| {
        let mut rest = letters.to_vec();
        let first = rest.remove(place);
        orders(&rest).into_iter().map(move |order| [vec![first], order].concat())
    };
    (0..letters.len()).flat_map(with_first).collect()
}

/// A machine of this order with offsets everywhere; what stands before the bed moves the workpiece.
fn machine(order: &[&str], bed: usize) -> String {
    let links: Vec<String> =
        order.iter().enumerate().map(|(place, axis)| format!("{axis}{}", if place < bed { "'" } else { "" })).collect();
    let (table, head) = links.split_at(bed);
    let mut text = format!("machine order {{\n    chain w {} b {} t\n", table.join(" "), head.join(" "));
    for axis in order {
        let direction = ["x", "y", "z"]["XYZABC".find(axis).expect("one of the letters") % 3];
        match *axis {
            "X" | "Y" | "Z" => writeln!(text, "    linear {axis} along +{direction}"),
            _ => writeln!(text, "    rotary {axis} about +{direction} through (11, -23, {})", 10 * axis.len()),
        }
        .expect("writing to a string does not fail");
    }
    text + "    tool along +z at (5, 7, -13) length 120\n}\n"
}

#[test]
fn all_orders_are_solved_or_refused_by_name() {
    let (mut solved, mut refused) = (0, 0);
    for rotaries in [["A", "B"], ["A", "C"], ["B", "C"]] {
        for order in orders(&["X", "Y", "Z", rotaries[0], rotaries[1]]) {
            for bed in 0..=order.len() {
                let text = machine(&order, bed);
                match compile("order.mach", &Text(text.clone())) {
                    Ok(Compiled { model, plan, .. }) => {
                        solved += 1;
                        if let Err(error) = closing::close_blocks(&model, &plan, BLOCKS) {
                            panic!("{error}\n{text}");
                        }
                    }
                    Err(errors) => {
                        refused += 1;
                        // C next to the tool turns about it: the one freedom that such a chain can lack.
                        let nearest_the_tool = order.iter().rfind(|axis| rotaries.contains(axis));
                        assert_eq!(nearest_the_tool, Some(&"C"), "{text}");
                        assert_eq!(errors.len(), 1, "{text}");
                        assert!(errors[0].message.contains('C'), "{}", errors[0].message);
                    }
                }
            }
        }
    }
    assert_eq!((solved, refused), (240 * 6, 120 * 6));
}
