//! Programs changed by one edit: the comparison reports every change of the motion or of an event. What it does not report is
//! proved harmless by another rule: run on the control, both programs do the same.

use super::machine::{Files, compiled};
use super::verified::Setup;
use mach_runtime::control::Control;
use mach_runtime::diagnostic::Severity;
use mach_runtime::dialect::meaning::Spindle;
use mach_runtime::dialect::table::BlockKind;
use mach_runtime::machine::Retract;
use mach_runtime::motion::{Event, Law, Motion, State, What};
use machc::model::tables;
use std::collections::BTreeMap;
use std::path::Path;

/// So many changed programs for each control.
const COUNT: usize = 2000;

/// Kinds of edits, those with statements among them, and how often a place is looked for that takes one.
const KINDS: usize = 14;
const KINDS_OF_STATEMENTS: usize = 16;
const TRIES: usize = 300;

/// Ends of moves closer than this, in millimetres or degrees, are one: the rounding that a comparison has to allow.
const ROUNDING: f64 = 0.0016;

/// A small generator: the same numbers on every machine.
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % count as u64) as usize
    }
}

/// What a program does, of what matters to the part.
#[derive(Debug, Clone, PartialEq)]
enum Deed {
    Move { is_cut: bool, is_machine: bool, joints: Vec<f64>, known: u64, state: State },
    Event(Event, Spindle),
}

/// What a program does; `None` where the control does not understand it.
fn deeds(setup: &Setup, nc: &str) -> Option<Vec<Deed>> {
    let machine = tables::machine(&setup.compiled.model);
    let mut control = Control::new(&setup.rig.dialect.table, &machine.axes, machine.tool());
    let mut motion = Motion::new(machine.axes.len());
    for (number, line) in nc.lines().enumerate() {
        control.run(line, number as u64 + 1, &mut motion).ok()?;
        // What stands behind the end is never run.
        if motion.items().last().is_some_and(|item| item.what == What::Event(Event::End)) {
            break;
        }
    }
    let way_out = Retract::of(&machine.axes).expect("the machine has a way out").axis;
    let along_tool = (0..).zip(&machine.axes).filter(|(_, axis)| axis.length_share != 0.0);
    let along_tool = along_tool.fold(0_u64, |axes, (axis, _)| axes | 1 << axis);
    let mut deeds: Vec<Deed> = Vec::new();
    let mut at: Option<(Vec<f64>, u64)> = None;
    for item in motion.items() {
        let state = *motion.state(item);
        match &item.what {
            What::Event(event) => {
                deeds.push(Deed::Event(*event, state.spindle));
                // What stands behind the end is never run.
                if *event == Event::End {
                    break;
                }
            }
            What::Move(it) => {
                let here = (motion.joints(it).to_vec(), it.known);
                let stays = at.as_ref().is_some_and(|at| at.1 == here.1 && are_near(&at.0, &here.0));
                // At the way out it is the same in which order the other axes go.
                let is_up = is_at_way_out(&deeds, &here.0, way_out);
                if is_up && !it.is_machine {
                    deeds.pop();
                }
                if !stays || is_up {
                    let (is_cut, is_machine) = (it.law != Law::Rapid, it.is_machine);
                    let has_length = along_tool & it.named != 0;
                    let state = if is_cut { state } else { at_rest(state, has_length) };
                    deeds.push(Deed::Move { is_cut, is_machine, joints: here.0.clone(), known: here.1, state });
                }
                at = Some(here);
            }
        }
    }
    Some(deeds)
}

/// Whether the last motion is an approach, and this one goes on with the axis of the way out where it was.
fn is_at_way_out(deeds: &[Deed], joints: &[f64], way_out: usize) -> bool {
    match deeds {
        [.., before, Deed::Move { is_cut: false, is_machine: false, joints: last, .. }] => {
            let up = match before {
                Deed::Move { is_machine: true, joints, .. } => joints[way_out],
                _ => last[way_out],
            };
            let begins = matches!(before, Deed::Move { is_machine: true, .. } | Deed::Event(Event::ToolChange(_), _));
            begins && last[way_out] == up && joints[way_out] == last[way_out]
        }
        _ => false,
    }
}

/// Spindle, coolant and feed matter in cuts, the tool's length where an axis goes that it counts along.
fn at_rest(state: State, has_length: bool) -> State {
    let usual = State::default();
    let length_register = state.length_register.filter(|_| has_length);
    State { spindle: usual.spindle, speed_rpm: 0.0, coolant: usual.coolant, feed: None, length_register, ..state }
}

fn are_near(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= ROUNDING)
}

fn do_the_same(a: &[Deed], b: &[Deed]) -> bool {
    a.len() == b.len()
        && a.iter().zip(b).all(|pair| match pair {
            (Deed::Event(a, x), Deed::Event(b, y)) => a == b && x == y,
            (
                Deed::Move { is_cut: a, is_machine: m, joints: p, known: k, state: s },
                Deed::Move { is_cut: b, is_machine: n, joints: q, known: l, state: t },
            ) => a == b && m == n && k == l && are_near(p, q) && (*m || s == t),
            _ => false,
        })
}

/// A program with one edit, and what kind it is; `None` where the place does not take it.
fn changed(kind: usize, lines: &[String], random: &mut Random) -> Option<(&'static str, Vec<String>)> {
    let mut lines = lines.to_vec();
    let at = random.below(lines.len());
    let words: Vec<String> = lines[at].split(' ').map(str::to_owned).collect();
    let word = random.below(words.len());
    let rejoined = |words: Vec<String>| words.join(" ");
    let replaced = |from: &str, to: &str| {
        words.iter().any(|it| it == from).then(|| {
            words.iter().map(|it| if it == from { to.to_owned() } else { it.clone() }).collect::<Vec<_>>().join(" ")
        })
    };
    let name = match kind {
        0 => {
            let digits: Vec<usize> =
                lines[at].char_indices().filter(|(_, c)| c.is_ascii_digit()).map(|(at, _)| at).collect();
            let place = *digits.get(random.below(digits.len().max(1)))?;
            let digit = char::from(b'0' + random.below(10) as u8).to_string();
            lines[at].replace_range(place..=place, &digit);
            "a digit"
        }
        1 => {
            let (address, number) = words[word].split_at_checked(1)?;
            let turned = number.strip_prefix('-').map_or_else(|| format!("-{number}"), str::to_owned);
            let mut words = words.clone();
            words[word] = format!("{address}{turned}");
            lines[at] = rejoined(words);
            "a sign"
        }
        2 => {
            let mut words = words.clone();
            words.remove(word);
            lines[at] = rejoined(words);
            "a word dropped"
        }
        3 => {
            let mut words = words.clone();
            words.insert(word, words[word].clone());
            lines[at] = rejoined(words);
            "a word doubled"
        }
        4 => {
            let mut words = words.clone();
            let moved = words.remove(word);
            words.insert(random.below(words.len() + 1), moved);
            lines[at] = rejoined(words);
            "a word moved"
        }
        5 => {
            let feed =
                || replaced("FMAX", "F500").or_else(|| lines[at].contains("L ").then(|| format!("{} FMAX", lines[at])));
            lines[at] = replaced("G0", "G1").or_else(|| replaced("G1", "G0")).or_else(feed)?;
            "rapid and line"
        }
        6 => {
            let swaps = [
                ("G54", "G55"),
                ("G21", "G20"),
                ("G710", "G700"),
                ("G90", "G91"),
                ("M3", "M4"),
                ("D1", "D2"),
                ("H01", "H02"),
                ("G17", "G18"),
                ("G94", "G95"),
                ("G40", "G41"),
                ("G64", "G60"),
                ("G61", "G64"),
                ("G43", "G49"),
                ("H1", "H2"),
                ("G91.1", "G90.1"),
                ("M30", "M0"),
                ("M2", "M0"),
                ("M0", "M1"),
                ("M91", ""),
                ("MM", "INCH"),
                ("M126", "M127"),
                ("M137", "M136"),
                ("Q339=+1", "Q339=+2"),
                ("DR+", "DR-"),
            ];
            lines[at] = swaps.iter().find_map(|(from, to)| replaced(from, to))?;
            "a code"
        }
        7 => {
            words.iter().any(|it| it.starts_with('F')).then_some(())?;
            let ten = |it: &String| match it.strip_prefix('F') {
                Some(feed) => format!("F{}", 10.0 * feed.parse::<f64>().unwrap_or(1.0)),
                None => it.clone(),
            };
            lines[at] = words.iter().map(ten).collect::<Vec<_>>().join(" ");
            "the feed times ten"
        }
        8 | 9 => {
            lines.remove(at);
            "a block dropped"
        }
        10 => {
            lines.insert(at, lines[at].clone());
            "a block doubled"
        }
        14 => {
            let drops = ["M91", "M126", "~", "CALL", "Z", "MM"];
            lines[at] = drops.iter().find_map(|word| replaced(word, ""))?;
            "a word of statements dropped"
        }
        15 => {
            lines[at] = replaced("R0", ["RL", "RR"][random.below(2)])?;
            "the side"
        }
        11 | 12 => {
            (at + 1 < lines.len()).then_some(())?;
            lines.swap(at, at + 1);
            "blocks exchanged"
        }
        _ => {
            let mut words = words.clone();
            let opens = if lines.iter().any(|it| it.ends_with('~')) { ";" } else { "(" };
            words.insert(word, opens.to_owned());
            lines[at] = rejoined(words);
            "a comment opened"
        }
    };
    Some((name, lines))
}

fn campaign(machine: &str, setup: &Setup, programs: &[&str]) {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let cls =
        programs.iter().map(|it| std::fs::read_to_string(examples.join(format!("{it}.cls"))).expect("an example"));
    let posted: Vec<(String, String)> = cls.map(|cl| (setup.post(&cl).expect("the machine can do it"), cl)).collect();
    let originals: Vec<Vec<Deed>> = posted.iter().map(|(nc, _)| deeds(setup, nc).expect("ours")).collect();
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut reported, mut harmless): (BTreeMap<&str, u32>, BTreeMap<&str, u32>) = (BTreeMap::new(), BTreeMap::new());
    let table = &setup.rig.dialect.table;
    let kinds = if table.blocks == BlockKind::Statements { KINDS_OF_STATEMENTS } else { KINDS };
    let mut count = 0;
    while count < COUNT {
        let which = random.below(posted.len());
        let (nc, cl) = &posted[which];
        let lines: Vec<String> = nc.lines().map(str::to_owned).collect();
        let kind = random.below(kinds);
        let tries = (0..TRIES).find_map(|_| changed(kind, &lines, &mut random));
        let Some((kind, mutant)) = tries else { continue };
        if mutant == lines {
            continue;
        }
        count += 1;
        let text = mutant.join("\n");
        let (told, agreement) = setup.verify(&text, cl);
        let is_reported = agreement.differences > 0 || told.iter().any(|it| it.severity == Severity::Error);
        if is_reported {
            *reported.entry(kind).or_default() += 1;
            continue;
        }
        let same = deeds(setup, &text).is_some_and(|deeds| do_the_same(&deeds, &originals[which]));
        assert!(same, "{kind} of {} is missed:\n{}", programs[which], difference(&lines, &mutant));
        *harmless.entry(kind).or_default() += 1;
    }
    println!("{machine}: reported {reported:?}, harmless {harmless:?}");
    let total: u32 = reported.values().sum();
    assert!(total as usize > COUNT / 2, "{reported:?} {harmless:?}");
}

/// The lines in which two programs differ.
fn difference(a: &[String], b: &[String]) -> String {
    let first = a.iter().zip(b).position(|(a, b)| a != b).unwrap_or(a.len().min(b.len()));
    let some = |lines: &[String]| lines[first.saturating_sub(2)..(first + 3).min(lines.len())].join("\n");
    format!("{}\n---\n{}", some(a), some(b))
}

/// A machine with the control in its file.
fn own(machine: &str) -> Setup {
    Setup::new(compiled(&format!("machines/{machine}.mach"), &Files))
}

/// The programs that are changed.
const PROGRAMS: [&str; 3] = ["sine_surface", "face_mill", "cone"];

#[test]
fn no_edit_of_a_syntec_program_is_missed() {
    campaign("tmv710a", &own("tmv710a"), &PROGRAMS);
}

#[test]
fn no_edit_of_a_sinumerik_program_is_missed() {
    campaign("dmu50ev", &own("dmu50ev"), &PROGRAMS);
}

#[test]
fn no_edit_of_a_fanuc_program_is_missed() {
    campaign("FANUC", &Setup::refitted("tmv710a", "fanuc"), &PROGRAMS);
}

#[test]
fn no_edit_of_a_linuxcnc_program_is_missed() {
    campaign("LinuxCNC", &Setup::refitted("vmc5_trunnion", "linuxcnc"), &PROGRAMS);
}

#[test]
fn no_edit_of_a_klartext_program_is_missed() {
    campaign("Klartext", &Setup::refitted("tmv710a", "heidenhain"), &PROGRAMS);
}
