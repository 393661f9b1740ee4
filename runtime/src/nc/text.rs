//! Text from the CL on its way into the program: nothing in it may end a comment, a string or the program.

/// Prints text for a comment or a message. Characters of the comment's own delimiters, parentheses and quotes (a line may put
/// the text between those), `%` (the end of a tape), `;` (the end of a block) and control characters become blanks, runs of
/// blanks one blank; what is not ASCII becomes `?`.
pub fn print_comment(text: &str, delimiters: (&str, &str), out: &mut Vec<u8>) {
    let start = out.len();
    for c in text.chars() {
        let unsafe_here =
            matches!(c, '(' | ')' | '"' | '%' | ';') || delimiters.0.contains(c) || delimiters.1.contains(c);
        match c {
            _ if !c.is_ascii() => out.push(b'?'),
            _ if unsafe_here || c.is_ascii_control() || c == ' ' => {
                if out.len() > start && out.last() != Some(&b' ') {
                    out.push(b' ');
                }
            }
            _ => out.push(c as u8),
        }
    }
    if out.len() > start && out.last() == Some(&b' ') {
        out.pop();
    }
}

/// Prints a program's name: upper-case letters, digits, and underscores for everything else. False, and nothing
/// printed, when no letter or digit is in it.
pub fn print_program_name(name: &str, out: &mut Vec<u8>) -> bool {
    if !name.chars().any(|c| c.is_ascii_alphanumeric()) {
        return false;
    }
    out.extend(name.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() as u8 } else { b'_' }));
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn comment(text: &str, delimiters: (&str, &str)) -> String {
        let mut out = Vec::new();
        print_comment(text, delimiters, &mut out);
        String::from_utf8(out).expect("ASCII")
    }

    #[test]
    fn nothing_leaves_a_comment() {
        assert_eq!(comment("DRILL (6.8) 50%\r\nM30", ("(", ")")), "DRILL 6.8 50 M30");
        assert_eq!(comment("a;b \"c\" (d)", (";", "")), "a b c d");
        assert_eq!(comment("A) G0 X999 Z-50 (B", (";", "")), "A G0 X999 Z-50 B");
        assert_eq!(comment("Fräser Ø6", ("(", ")")), "Fr?ser ?6");
        assert_eq!(comment(" ( ) ", ("(", ")")), "");
    }

    #[test]
    fn program_names() {
        let mut out = Vec::new();
        assert!(print_program_name("sine-surface.v2", &mut out));
        assert_eq!(out, b"SINE_SURFACE_V2");
        assert!(!print_program_name("--é", &mut out));
    }
}
