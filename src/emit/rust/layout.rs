//! Rust source laid out by `prettyplease`, which knows no comments: each takes part as a macro of its number.

/// Stands for the line of its number while the source is a syntax tree.
const MARK: &str = "__line!";

/// The source in its usual layout. Lines that are blank or a `//` comment by themselves are kept where they are, between
/// items or statements.
///
/// # Panics
///
/// When the source is not Rust.
pub(super) fn laid_out(source: &str) -> String {
    let (mut marked, mut kept) = (String::new(), Vec::new());
    for line in source.lines() {
        let text = line.trim();
        let is_comment = text.starts_with("//") && !text.starts_with("///") && !text.starts_with("//!");
        if text.is_empty() || is_comment {
            marked += &format!("{MARK}({});\n", kept.len());
            kept.push(text);
        } else {
            marked += &format!("{line}\n");
        }
    }
    let tree = syn::parse_file(&marked).unwrap_or_else(|error| panic!("generated Rust is Rust: {error}\n{marked}"));
    let mut lines: Vec<String> = Vec::new();
    for line in prettyplease::unparse(&tree).lines() {
        match number(line) {
            Some(number) if kept[number].is_empty() && opens(lines.last()) => {}
            Some(number) if kept[number].is_empty() => lines.push(String::new()),
            Some(number) => lines.push(line.replace(line.trim(), kept[number])),
            None => lines.push(line.to_owned()),
        }
    }
    lines.join("\n") + "\n"
}

/// Whether no blank line belongs behind a line.
fn opens(line: Option<&String>) -> bool {
    line.is_none_or(|line| line.is_empty() || line.ends_with('{'))
}

/// The number of a mark.
fn number(line: &str) -> Option<usize> {
    line.trim().strip_prefix(MARK)?.trim_start_matches('(').trim_end_matches(");").parse().ok()
}

#[cfg(test)]
mod tests {
    use super::laid_out;

    #[test]
    fn comments_and_blank_lines_stay_between_statements() {
        let source = "//! Head.\n\n\n// an item\nfn f(){\n\n  // 1 \"one\"\n  let a=1;\n\n// 2\nlet b =a;}";
        let expected = "\
//! Head.

// an item
fn f() {
    // 1 \"one\"
    let a = 1;

    // 2
    let b = a;
}
";
        assert_eq!(laid_out(source), expected);
    }
}
