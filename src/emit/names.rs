//! Names for generated code: identifiers that no keyword and no other name stands against.

use std::collections::BTreeSet;

/// The names that are taken.
#[derive(Debug, Clone)]
pub struct Names(BTreeSet<String>);

impl Names {
    /// Nothing is taken but these: a language's keywords, and what the code around calls by name.
    pub fn new(reserved: &[&str]) -> Self {
        Self(reserved.iter().map(|&name| name.to_owned()).collect())
    }

    /// Takes a name like the wanted one: lower case, with a number behind it where it is taken already.
    pub fn claim(&mut self, wanted: &str) -> String {
        let plain = snake_case(wanted);
        let numbered = (2..).map(|number| format!("{plain}_{number}"));
        let free = [plain.clone()].into_iter().chain(numbered).find(|name| !self.0.contains(name));
        let name = free.expect("there is always a greater number");
        self.0.insert(name.clone());
        name
    }
}

/// Lower case, words apart by one underscore, a letter first.
fn snake_case(text: &str) -> String {
    let lower = text.to_ascii_lowercase();
    let words: Vec<&str> = lower.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()).collect();
    let joined = words.join("_");
    if joined.starts_with(|c: char| c.is_ascii_alphabetic()) { joined } else { format!("n{joined}") }
}

#[cfg(test)]
mod tests {
    use super::Names;

    #[test]
    fn a_name_is_given_once() {
        let mut names = Names::new(&["fn", "self"]);
        let claimed = ["Fn", "FN_2", "Self", "A", "a", "A__", "C1", "1"].map(|wanted| names.claim(wanted));
        assert_eq!(claimed, ["fn_2", "fn_2_2", "self_2", "a", "a_2", "a_3", "c1", "n1"]);
    }
}
