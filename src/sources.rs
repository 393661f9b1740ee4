//! Where machine files come from.

/// Reads machine files, by the paths of their `use` statements.
pub trait Sources {
    /// The text of a file.
    ///
    /// # Errors
    ///
    /// Why it cannot be read, in a few words for people (`no such file`).
    fn read(&self, path: &str) -> Result<String, String>;
}

/// Any function that knows the texts.
impl<F: Fn(&str) -> Result<String, String>> Sources for F {
    fn read(&self, path: &str) -> Result<String, String> {
        self(path)
    }
}
