//! `machc new` from outside: every family compiles as it is written, anywhere.

use crate::machc::{MILL, Workshop};

const FAMILIES: [&str; 10] = [
    "three-axis",
    "four-axis",
    "turning-centre",
    "trunnion",
    "trunnion-measured",
    "trunnion-bc",
    "nutating-table",
    "head-table",
    "head-head",
    "six-axis",
];

#[test]
fn every_family_is_sound_canonical_and_posts() {
    let workshop = Workshop::new("new");
    workshop.write("part.cls", "LOAD/TOOL,1\nSPINDL/8000\nRAPID\nGOTO/0,0,50\nFEDRAT/100\nGOTO/0,0,0\nGOTO/10,0,0\n");
    for family in FAMILIES {
        for controller in ["syntec", "siemens"] {
            let name = format!("{}_{controller}", family.replace('-', "_"));
            let run = workshop.run(&["new", &name, "--like", family, "--controller", controller]);
            assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{}", run.stderr);
            let file = format!("{name}.mach");
            let text = workshop.read(&file);
            assert!(text.contains(&format!("machine {name} \"")), "{text}");
            assert!(text.contains(&format!("use \"controllers/{controller}.mach\"")), "{text}");
            let check = workshop.run(&["check", &file]);
            assert_eq!((check.status, check.stderr.as_str()), (0, ""));
            assert_eq!(workshop.run(&["fmt", "--check", &file]).stdout, "", "{file} is not canonical");
            let post = workshop.run(&["post", &file, "part.cls"]);
            assert!(post.status == 0 && post.stdout.contains("G1"), "{file}: {}", post.stderr);
            assert!(!post.stderr.contains("warning"), "{file}: {}", post.stderr);
        }
    }
}

#[test]
fn five_axes_tilt() {
    let workshop = Workshop::new("new-tilt");
    workshop.write("part.cls", "LOAD/TOOL,1\nFEDRAT/100\nGOTO/0,0,10,0,0,1\nGOTO/0,0,10,0.3,0.4,0.8660254037844386\n");
    for family in &FAMILIES[3..] {
        assert_eq!(workshop.run(&["new", "five", "--like", family]).status, 0);
        let post = workshop.run(&["post", "five.mach", "part.cls"]);
        assert_eq!(post.status, 0, "{family}: {}", post.stderr);
        std::fs::remove_file(workshop.path("five.mach")).unwrap();
    }
}

#[test]
fn nothing_is_overwritten() {
    let workshop = Workshop::new("new-twice");
    let run = workshop.run(&["new", "mill", "--like", "trunnion"]);
    assert_eq!(run.status, 2);
    assert!(run.stderr.contains("`mill.mach` is there already"), "{}", run.stderr);
    assert_eq!(workshop.read("mill.mach"), MILL);
}

#[test]
fn what_is_misspelt_is_guessed() {
    let workshop = Workshop::new("new-names");
    for (arguments, said) in [
        (&["new", "a", "--like", "trunion"][..], "did you mean `trunnion`?"),
        (&["new", "a", "--like", "hexapod"], "machc new --list"),
        (&["new", "a", "--like", "trunnion", "--controller", "sintec"], "did you mean `syntec`?"),
        (&["new", "5axis", "--like", "trunnion"], "`5axis` cannot be a machine's name"),
        (&["new", "linear", "--like", "trunnion"], "`linear` cannot be a machine's name"),
        (&["new", "a like b", "--like", "trunnion"], "cannot be a machine's name"),
        (&["new", "no/a", "--like", "trunnion"], "cannot write `no/a.mach`: there is no folder `no`"),
        (&["new", "a"], "--like"),
    ] {
        let run = workshop.run(arguments);
        assert_eq!(run.status, 2, "{arguments:?}: {}", run.stderr);
        assert!(run.stderr.contains(said), "{arguments:?}: {}", run.stderr);
    }
    assert_eq!(workshop.files(), ["mill.mach", "part.cls"]);
}

#[test]
fn families_are_listed() {
    let list = Workshop::new("new-list").run(&["new", "--list"]);
    assert_eq!(list.status, 0, "{}", list.stderr);
    for name in FAMILIES.iter().chain(&["syntec", "siemens"]) {
        assert!(list.stdout.lines().any(|line| line.split_whitespace().next() == Some(name)), "{name}");
    }
}

#[test]
fn a_controller_of_ones_own_comes_first() {
    let workshop = Workshop::new("new-own");
    assert_eq!(workshop.run(&["new", "mill2", "--like", "three-axis"]).status, 0);
    std::fs::create_dir(workshop.path("controllers")).unwrap();
    workshop.write("controllers/syntec.mach", "controller syntec {");
    let run = workshop.run(&["check", "mill2.mach"]);
    assert!(run.status == 1 && run.stderr.contains("controllers/syntec.mach:1"), "{}", run.stderr);
    assert_eq!(workshop.run(&["check", "nowhere/controllers/syntec.mach"]).status, 2);
}
