//! Snapshot files as the crate insta writes and reads them: `NAME.snap` is accepted, `NAME.snap.new` waits for a review.
//!
//! ```text
//! ---
//! source: machines/vmc3.mach
//! description: face_mill on vmc3
//! ---
//! content
//! ```

/// What opens and closes the head.
const FENCE: &str = "---";
/// A line of the head that pending files have, and accepted ones have not.
const PENDING_ONLY: &str = "assertion_line:";

/// A snapshot file's parts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Snapshot {
    /// The lines between the fences: YAML.
    head: String,
    /// What is locked, as it is compared: without blanks at its end, with plain line ends.
    content: String,
}

impl Snapshot {
    /// A snapshot of `content`, with the file that it comes of and a line for people.
    pub fn new(source: &str, description: &str, content: &str) -> Self {
        let head = format!("source: {}\ndescription: {}\n", yaml(source), yaml(description));
        Self { head, content: normal(content) }
    }

    /// From a file's text. What has no head is content.
    pub fn parse(text: &str) -> Self {
        let mut lines = text.split_inclusive('\n');
        let is_fence = |line: &&str| line.trim_end() == FENCE;
        if lines.next().filter(is_fence).is_none() {
            return Self { head: String::new(), content: normal(text) };
        }
        let head = lines.by_ref().take_while(|line| !is_fence(line)).collect::<String>().replace("\r\n", "\n");
        Self { head, content: normal(&lines.collect::<String>()) }
    }

    /// What is locked.
    pub fn content(&self) -> &str {
        &self.content
    }

    /// The same as an accepted file has it.
    #[must_use]
    pub fn accepted(self) -> Self {
        let kept = self.head.split_inclusive('\n').filter(|line| !line.starts_with(PENDING_ONLY));
        Self { head: kept.collect(), ..self }
    }

    /// The file's text.
    pub fn to_text(&self) -> String {
        format!("{FENCE}\n{}{FENCE}\n{}\n", self.head, self.content)
    }
}

/// As insta compares it.
fn normal(content: &str) -> String {
    content.trim_end().replace("\r\n", "\n")
}

/// A YAML scalar; in quotes unless it is plain beyond doubt.
fn yaml(text: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '/' | ' ' | '-' | '+' | '(' | ')');
    if text.starts_with(char::is_alphabetic) && text.chars().all(is_plain) && !text.ends_with(' ') {
        return text.to_owned();
    }
    let escaped: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    format!("\"{}\"", escaped.replace('\\', "\\\\").replace('"', "\\\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_what_insta_makes_of_it() {
        let snapshot = Snapshot::new("machines/vmc3.mach", "part #1 on \"vmc3\"", "one\r\ntwo  \n\n");
        let text = "---\nsource: machines/vmc3.mach\ndescription: \"part #1 on \\\"vmc3\\\"\"\n---\none\ntwo\n";
        assert_eq!(snapshot.to_text(), text);
        assert_eq!(Snapshot::parse(text), snapshot);

        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("vmc3@part.snap");
        std::fs::write(&path, text).unwrap();
        let read = insta::Snapshot::from_file(&path).unwrap();
        assert_eq!(read.metadata().source(), Some("machines/vmc3.mach"));
        assert_eq!(read.metadata().description(), Some("part #1 on \"vmc3\""));
        assert_eq!(read.as_text().unwrap().to_string(), snapshot.content());
        read.save(&path).unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
    }

    #[test]
    fn fences_within_the_content_stay() {
        let snapshot = Snapshot::new("a.mach", "b on a", "---\n---");
        assert_eq!(Snapshot::parse(&snapshot.to_text()), snapshot);
        assert_eq!(Snapshot::parse("no head").content(), "no head");
    }

    #[test]
    fn an_accepted_file_has_no_line_of_an_assertion() {
        let pending = "---\nsource: tests/a.rs\nassertion_line: 7\n---\nx\n";
        assert_eq!(Snapshot::parse(pending).accepted().to_text(), "---\nsource: tests/a.rs\n---\nx\n");
    }
}
