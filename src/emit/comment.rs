//! What stands above the blocks of a listing.

use super::listing::{Function, Listing, Remark};
use crate::model::origin::on_one_line;

/// The comment above each block, line by line: where it comes from, in full the first time, and its equation.
pub fn comments(function: &Function, listing: &Listing) -> Vec<Vec<String>> {
    let mut told = Vec::new();
    let remark = |output: usize| &function.outputs[output].remark;
    let comment = |block: &super::listing::Block| {
        let origin = match remark(block.output) {
            Remark::Meaning(text) => text.clone(),
            Remark::Stated(place) => {
                let line = format!("{}:{}", place.file, place.line);
                let is_new = !told.contains(&line);
                told.push(line.clone());
                if is_new { format!("{line}: {}", on_one_line(place)) } else { line }
            }
        };
        [origin].into_iter().chain(block.equation.clone()).collect()
    };
    listing.blocks.iter().map(comment).collect()
}
