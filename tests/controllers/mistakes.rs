//! What is wrong with a controller is found, each mistake at its place.

use crate::describe::dialect;
use mach_runtime::diagnostic::Diagnostic;
use mach_runtime::nc::dialect::Piece;

/// A controller without a mistake.
const RIGHT: &str = include_str!("right.mach");

const AXES: [&str; 5] = ["X", "Y", "Z", "A", "C"];

/// The diagnostics of the right controller with one change.
fn changed(from: &str, to: &str) -> Vec<Diagnostic> {
    assert!(RIGHT.contains(from), "{from}");
    dialect(&RIGHT.replace(from, to), &AXES).map(|_| Vec::new()).unwrap_or_else(|diagnostics| diagnostics)
}

/// A diagnostic's code and the text it marks.
fn marks(diagnostics: &[Diagnostic]) -> Vec<(&str, &str)> {
    let mark = |diagnostic: &'_ Diagnostic| -> (&'static str, std::ops::Range<usize>) {
        let place = &diagnostic.labels[0].place;
        (diagnostic.code.id, place.start..place.end)
    };
    diagnostics.iter().map(|it| (mark(it).0, &it.labels[0].place.excerpt[mark(it).1])).collect()
}

#[test]
fn the_right_controller_is_right() {
    assert_eq!(marks(&changed("plain", "simple")), []);
}

#[test]
fn each_mistake_has_its_code_and_place() {
    let cases = [
        ("####.###", "####.#0", ("E0520", "0")),
        ("###.####", "###,####", ("E0520", ",")),
        ("\"0.0\"", "\"-0\"", ("E0520", "-0")),
        ("{tool:00}", "{tool:0#}", ("E0520", "#")),
        ("word F feed", "word F fed", ("E0521", "fed")),
        ("word A C length", "word A C C1 length", ("E0522", "C1")),
        ("word A C length", "word A C length as \"A1\"", ("E0522", "\"A1\"")),
        ("word A C length", "word A C length as \"A=\"", ("E0522", "\"A=\"")),
        ("word A C length", "word A length word C length as \"A=\"", ("E0522", "\"A=\"")),
        ("word A C length", "word A length word C length as \"X\"", ("E0522", "\"X\"")),
        ("word A C length", "word A length word C length as \"F\"", ("E0522", "\"F\"")),
        ("word A C length", "word A length word C length as \"N\"", ("E0522", "\"N\"")),
        ("word A C length", "word A length word C length as \"M\"", ("E0522", "\"M\"")),
        ("word A C length", "word A length word C length as \"O\"", ("E0522", "\"O\"")),
        ("word A C length", "word A length word C length as \"M2=\"", ("E0522", "\"M2=\"")),
        ("word A C length", "word A C G length", ("E0522", "G")),
        ("word F feed", "word F feed as \"G\"", ("E0522", "\"G\"")),
        ("word F feed", "word F feed as \"C\"", ("E0522", "C")),
        ("word F feed", "word F feed word F_revolution feed as \"C\"", ("E0522", "C")),
        ("sequence \"N\"", "sequence \"F\"", ("E0522", "F")),
        ("word F feed", "word F feed word I J length as \"I\"", ("E0522", "\"I\"")),
        ("word F feed", "word F feed word I length as \"X\"", ("E0522", "\"X\"")),
        ("word F feed", "word F feed word R length as \"N\"", ("E0522", "\"N\"")),
        ("word F feed", "word F feed word S feed as \"F\"", ("E0522", "\"F\"")),
        ("sequence \"N\"", "sequence \"T\"", ("E0522", "T")),
        ("word A C length", "word A length word C length as \"T\"", ("E0522", "T")),
        ("word A C length", "word A length word C length as \"T=\"", ("E0522", "T")),
        ("\"T{tool:00} M6\"", "\"M6\" \"N{register}\"", ("E0522", "{register}")),
        ("\"T{tool:00} M6\"", "\"T1\" } on spindle clockwise { \"M3n {speed}\"", ("E0522", "{speed}")),
        ("sequence \"N\"", "sequence \"G\"", ("E0522", "\"G\"")),
        ("sequence \"N\"", "sequence \"M\"", ("E0522", "\"M\"")),
        ("sequence \"N\"", "sequence \"C=\"", ("E0522", "C")),
        ("word A C length", "word A length", ("E0523", "plain")),
        ("word F feed", "word D feed", ("E0523", "plain")),
        ("on rapid { \"G0 {axes}\" }", "", ("E0523", "plain")),
        ("T{tool:00}", "{units}", ("E0523", "{units}")),
        ("{tool:00}", "{toll}", ("E0524", "{toll}")),
        ("{tool:00}", "{speed}", ("E0525", "{speed}")),
        ("T{tool:00}", "{offset:00}", ("E0525", "{offset:00}")),
        ("\"G0 {axes}\"", "\"G0\"", ("E0526", "rapid")),
        ("\"G0 {axes}\"", "\"G0 {axes}\" \"{axes}\"", ("E0526", "rapid")),
        ("{axes} {feed}", "{axes}", ("E0526", "feed")),
        ("{axes} {feed}", "{axes}\" \"{feed}", ("E0526", "feed")),
        ("{axes} {feed}", "{rotary} {feed}\" \"{linear}", ("E0526", "feed")),
        ("\"G0 {axes}\"", "\"G0 {linear} {A}\"", ("E0526", "rapid")),
        ("\"G0 {axes}\"", "\"G0 {axes}\" \"{C}\"", ("E0526", "rapid")),
        ("\"G0 {axes}\"", "\"G0 {linear} {A} {D}\"", ("E0524", "{D}")),
        ("\"G0 {axes}\"", "\"G0 {axes} {retract}\"", ("E0525", "{retract}")),
        ("T{tool:00}", "{X}", ("E0525", "{X}")),
        ("on rapid", "on approach { \"{X} {Y}\" } on rapid", ("E0526", "approach")),
        ("on rapid", "on approach feed { \"{axes}\" \"{feed}\" } on rapid", ("E0526", "approach feed")),
        ("on rapid", "on approach { \"{axes} #1=5\" } on rapid", ("E0562", "approach")),
        ("sequence", "comment \"N\" sequence", ("E0534", "\"N\"")),
        ("sequence", "comment \"\" sequence", ("E0534", "\"\"")),
        ("sequence", "comment \".\" sequence", ("E0534", "\".\"")),
        ("sequence", "comment \"#\" sequence", ("E0534", "\"#\"")),
        ("sequence", "comment \" \" sequence", ("E0534", "\" \"")),
        ("sequence", "comment \"REM\" sequence", ("E0534", "\"REM\"")),
        ("sequence", "comment \"+\" sequence", ("E0534", "\"+\"")),
        ("sequence", "comment \"ä\" sequence", ("E0534", "\"ä\"")),
        ("sequence", "comment \"=\" sequence", ("E0534", "\"=\"")),
        ("sequence", "comment \"\\\"\" sequence", ("E0534", "\"\\\"\"")),
        ("sequence", "comment \"(\" \"\" sequence", ("E0534", "\"\"")),
        ("sequence", "comment \"(\" \"1\" sequence", ("E0534", "\"1\"")),
        ("sequence", "blocks statements continued \"+\" sequence", ("E0535", "\"+\"")),
        ("sequence", "blocks statements continued \"(\" sequence", ("E0535", "\"(\"")),
        ("sequence", "blocks statements continued \"\" sequence", ("E0535", "\"\"")),
        ("sequence \"N\"", "sequence \"\"", ("E0522", "\"\"")),
        ("sequence", "form incremental \"I{address}\" sequence", ("E0536", "\"I{address}\"")),
        ("sequence", "form incremental \"{number}I{address}\" sequence", ("E0536", "\"{number}I{address}\"")),
        ("sequence", "form shortest \"{address}{number}\" sequence", ("E0536", "\"{address}{number}\"")),
        ("word F feed", "word F feed inch 0.1 in", ("E0537", "0.1 in")),
        ("word F feed", "word F feed inch 0.1", ("E0537", "0.1")),
        ("word A C length", "word A C length inch 1 in/min", ("E0537", "1 in/min")),
        ("start 1", "start 1.5", ("E0527", "1.5")),
        ("start 1", "start 1 mm", ("E0527", "1 mm")),
        ("step 1", "step 0", ("E0527", "0")),
        ("greatest 9", "greatest 0", ("E0527", "0")),
        ("1 \"G54\"", "1 \"G54 X5.\"", ("E0532", "\"G54 X5.\"")),
        ("1 \"G54\"", "1 \"G54 F5\"", ("E0532", "\"G54 F5\"")),
        ("1 \"G54\"", "1 \"N5 G54\"", ("E0532", "\"N5 G54\"")),
        ("1 \"G54\"", "1 \"G54 G0\"", ("E0532", "\"G54 G0\"")),
        ("line \"G1\"", "line \"C1\"", ("E0532", "\"C1\"")),
        ("once", "plain \"C90\" once", ("E0532", "\"C90\"")),
        ("once", "retract \"\" once", ("E0533", "\"\"")),
        ("once", "retract \"M30\" once", ("E0533", "\"M30\"")),
        ("once", "retract \"G28 Z0.\" once", ("E0533", "\"G28 Z0.\"")),
        ("once", "retract \"Z\" once", ("E0533", "\"Z\"")),
        ("once", "retract \"Z-\" once", ("E0533", "\"Z-\"")),
        ("once", "retract \"Z0.0.\" once", ("E0533", "\"Z0.0.\"")),
        ("once", "retract \"Z=0\" once", ("E0533", "\"Z=0\"")),
        ("once", "retract \"A0.\" once", ("E0533", "\"A0.\"")),
        ("once", "retract \"W0.\" once", ("E0533", "\"W0.\"")),
        ("once", "retract \"Z0. (up)\" once", ("E0533", "\"Z0. (up)\"")),
        ("once", "retract \"z0.\" once", ("E0533", "\"z0.\"")),
        ("once", "retract \"Zµ\" once", ("E0533", "\"Zµ\"")),
        ("tool change \"M6\"", "tool change \"M6\" stop \"M06\"", ("E0561", "\"M06\"")),
        ("\"M6\"", "\"M{speed}\"", ("E0560", "\"M{speed}\"")),
        ("{tool:00} M6", "{tool:00} M6 ä", ("E0529", "ä")),
        ("\"G0 {axes}\"", "\"G0 {axes} X5.\"", ("E0562", "rapid")),
        ("{axes} {feed}", "{axes} {feed} #1=5", ("E0562", "feed")),
    ];
    for (from, to, expected) in cases {
        let diagnostics = changed(from, to);
        assert_eq!(marks(&diagnostics).first(), Some(&expected), "{to}: {diagnostics:#?}");
        assert!(marks(&diagnostics).iter().all(|mark| mark.0 == expected.0), "{to}: {diagnostics:#?}");
    }
}

/// The marks of a controller whose tool change has this line.
fn marks_in_tool(line: &str) -> Vec<(String, String)> {
    let diagnostics = changed("\"T{tool:00} M6\"", &format!("\"{line}\""));
    marks(&diagnostics).into_iter().map(|(code, mark)| (code.to_owned(), mark.to_owned())).collect()
}

#[test]
fn what_a_placeholder_prints_is_read_alone() {
    let motions = [
        ("{axes} {feed}", "{X}5 {Y} {Z} {rotary} {feed}", "{X}"),
        ("{axes} {feed}", "{axes} {feed}5", "{feed}"),
        ("{axes} {feed}", "{axes}0 {feed}", "{axes}"),
        ("{axes} {feed}", "{axes}.5 {feed}", "{axes}"),
        ("{axes} {feed}", "{axes}-5 {feed}", "{axes}"),
        ("{axes} {feed}", "{axes}{feed}", "{axes}"),
        ("G1 {axes}", "G1{axes}", "{axes}"),
        ("G1 {axes}", "G1 {linear}{rotary}", "{linear}"),
        ("G1 {axes}", "G1 U{axes}", "{axes}"),
        ("G1 {axes}", "G1 X={axes}", "{axes}"),
        ("G1 {axes}", "G1 -{axes}", "{axes}"),
        ("G1 {axes}", "G1 D{X} {Y} {Z} {rotary}", "{X}"),
        ("G1 {axes}", "G1 {axes} D{E}", "{E}"),
    ];
    for (from, to, mark) in motions {
        let text = RIGHT.replace("word A C", "word A C E");
        let diagnostics = dialect(&text.replace(from, to), &AXES).expect_err(to);
        assert_eq!(marks(&diagnostics), [("E0531", mark)], "{to}");
    }
    let commands = [
        ("T0{tool} M6", "{tool}"),
        ("T.{tool} M6", "{tool}"),
        ("T-{tool} M6", "{tool}"),
        ("T{tool}0 M6", "{tool}"),
        ("T{tool:00}.1 M6", "{tool:00}"),
        ("T{tool}{register} M6", "{tool}"),
        ("T{tool}{program} M6", "{tool}"),
        ("G53{retract}", "{retract}"),
        ("G53 {retract}0", "{retract}"),
        ("M6{offset}", "{offset}"),
        ("{offset}.1", "{offset}"),
        ("{offset}{retract}", "{offset}"),
        ("{program}{retract}", "{program}"),
        ("(a) T0{tool} (b)", "{tool}"),
    ];
    for (line, mark) in commands {
        assert_eq!(marks_in_tool(line), [("E0531".to_owned(), mark.to_owned())], "{line}");
    }
}

#[test]
fn in_comments_and_quotes_and_beside_other_signs_a_placeholder_may_stand() {
    for line in [
        "(tool {tool}. -{offset}.)",
        "MSG(\\\"tool {tool}0{offset}5\\\")",
        "O{program}5",
        "T{tool}M6",
        "{retract}M6",
        "T={tool}",
        "R{tool}=5",
        "#1=[{tool}-1]*{register}",
        "/{offset}",
        "G53 {retract};",
    ] {
        assert!(marks_in_tool(line).iter().all(|(code, _)| code != "E0531"), "{line}");
    }
}

#[test]
fn what_is_said_rightly_is_taken() {
    for (from, to) in [
        ("word A C length", "word A length word C length as \"C1=\""),
        ("word A C length", "word A length as \"C1=\" word C length"),
        ("word A C length", "word A C length word B length as \"A\""),
        ("word A C length", "word A length word C length as \"MC=\""),
        ("word F feed", "word F feed word F_revolution feed as \"F\""),
        ("sequence \"N\"", "sequence \"B\""),
        ("sequence", "comment \"(*\" \"*)\" sequence"),
        ("sequence", "comment \"//\" sequence"),
        ("sequence", "comment \"!\" sequence"),
        ("once", "retract \"Z0.\" once"),
        ("once", "retract \"Z+100\" once"),
        ("once", "retract \"Z-.5 Y0\" once"),
        ("\"G54\"", "\"G54.1 P5\""),
        ("\"G54\"", "\"CYCLE800(0,TABLE,0)\""),
        ("1 \"G54\"", "1 \"G54\" 2 \"G55\""),
    ] {
        assert_eq!(marks(&changed(from, to)), [], "{to}");
    }
    let without_numbers = RIGHT.replace("sequence \"N\" start 1 step 1 greatest 9", "sequence none");
    assert!(
        dialect(&without_numbers.replace("C length", "C length as \"N\"").replace("A C", "C"), &["X", "Y", "Z", "C"])
            .is_ok()
    );
}

#[test]
fn a_misspelt_placeholder_is_mended_by_its_suggestion() {
    let diagnostics = changed("{tool:00}", "{toll:00}");
    let suggestion = diagnostics[0].suggestion.as_ref().expect("a placeholder is close");
    let place = &suggestion.place;
    let mut line = place.excerpt.clone();
    line.replace_range(place.start..place.end, &suggestion.replacement);
    assert_eq!(line.trim(), "on tool { \"T{tool:00} M6\" }");
}

#[test]
fn a_misspelt_format_is_mended_by_its_suggestion() {
    let diagnostics = changed("word A C length", "word A C lenght");
    assert_eq!(diagnostics[0].suggestion.as_ref().map(|it| it.replacement.as_str()), Some("length"));
}

#[test]
fn all_mistakes_are_found_at_once() {
    let text = RIGHT.replace("####.###", "####.#0").replace("word F feed", "word F fed").replace("{tool:00}", "{tol}");
    let diagnostics = dialect(&text, &AXES).expect_err("three mistakes");
    assert_eq!(marks(&diagnostics), [("E0520", "0"), ("E0521", "fed"), ("E0524", "{tol}")]);
}

#[test]
fn codes_of_modal_groups_are_found_where_they_are_codes() {
    let modal = |template: &str| {
        let text = RIGHT.replace("\"T{tool:00} M6\"", &format!("\"T{{tool}} M6\" {template}"));
        let dialect = dialect(&text, &AXES).unwrap_or_else(|found| panic!("{template}: {found:#?}"));
        let block = &dialect.blocks[0];
        block.lines[1].pieces.iter().filter(|piece| matches!(piece, Piece::Modal { .. })).count()
    };
    assert_eq!(modal(r#""G53 G0 {retract}""#), 1);
    assert_eq!(modal(r#""(G0 G1) G53 G0 {retract}""#), 1);
    assert_eq!(modal(r#""(G0 G1)""#), 0);
}
