//! Did you mean …?

/// The candidate that a misspelt word most probably stands for: the same but for its case, or at most a third of its
/// letters wrong. Of equals the first one.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let folded = word.to_lowercase();
    let tolerated = (word.chars().count().min(60) / 3).max(1);
    candidates
        .into_iter()
        .filter(|candidate| *candidate != word && candidate.len() <= 2 * word.len() + 1 && word.len() <= 60)
        .map(|candidate| (strsim::osa_distance(&folded, &candidate.to_lowercase()), candidate))
        .filter(|(distance, candidate)| *distance <= tolerated && *distance < candidate.chars().count())
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn takes_the_nearest_word_and_nothing_far_away() {
        assert_eq!(nearest("liner", ["rotary", "linear", "line"]), Some("linear"));
        assert_eq!(nearest("LINEAR", ["rotary", "linear"]), Some("linear"));
        assert_eq!(nearest("alogn", ["along"]), Some("along"));
        assert_eq!(nearest("c", ["C", "X"]), Some("C"));
        assert_eq!(nearest("spindle", ["stop", "end"]), None);
        assert_eq!(nearest("B", ["A"]), None);
    }
}
