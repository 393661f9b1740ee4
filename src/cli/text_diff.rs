//! Two texts, compared line by line, for people.

use similar::{ChangeTag, TextDiff};

/// Lines around each change.
const CONTEXT: usize = 3;

/// What has changed between two texts.
#[derive(Debug)]
pub(super) struct Changes {
    /// Lines that are gone.
    pub(super) removed: usize,
    /// Lines that are new.
    pub(super) added: usize,
    /// The changed lines and those around them; in colour if asked for.
    pub(super) text: String,
}

impl Changes {
    pub(super) fn between(old: &str, new: &str, color: bool) -> Self {
        let diff = TextDiff::from_lines(old, new);
        let mut changes = Self { removed: 0, added: 0, text: String::new() };
        for hunk in diff.unified_diff().context_radius(CONTEXT).iter_hunks() {
            changes.line("\x1b[36m", &hunk.header().to_string(), color);
            for change in hunk.iter_changes() {
                let (style, sign) = match change.tag() {
                    ChangeTag::Delete => ("\x1b[31m", '-'),
                    ChangeTag::Insert => ("\x1b[32m", '+'),
                    ChangeTag::Equal => ("", ' '),
                };
                changes.removed += usize::from(sign == '-');
                changes.added += usize::from(sign == '+');
                changes.line(style, &format!("{sign}{}", change.value()), color);
            }
        }
        changes
    }

    fn line(&mut self, style: &str, line: &str, color: bool) {
        let plain = line.trim_end().replace(|c: char| c.is_control() && c != '\t', "\u{fffd}");
        self.text += &if color && !style.is_empty() { format!("{style}{plain}\x1b[0m\n") } else { plain + "\n" };
    }
}
