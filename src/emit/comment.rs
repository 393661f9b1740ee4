//! What stands above the blocks of a listing.

use super::listing::{Block, Function, Listing, Remark};
use crate::model::origin::on_one_line;

/// The comment above each block, line by line: where it comes from, in full the first time, and its equation.
pub fn comments(function: &Function, listing: &Listing) -> Vec<Vec<String>> {
    let mut told: Vec<String> = Vec::new();
    let comment = |block: &Block| {
        let origin = match &function.outputs[block.output].remark {
            Remark::Meaning(text) => Some(text.clone()),
            Remark::Stated(place) => {
                let line = format!("{}:{}", place.file, place.line);
                let (is_known, is_last) = (told.contains(&line), told.last() == Some(&line));
                told.push(line.clone());
                let text = if is_known { line } else { format!("{line}: {}", on_one_line(place)) };
                (!is_last).then_some(text)
            }
        };
        origin.into_iter().chain(block.equation.clone()).collect()
    };
    listing.blocks.iter().map(comment).collect()
}
