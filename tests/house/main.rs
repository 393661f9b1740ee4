//! The house in order: where each room stands, what it must not know, and no circles, read from the imports of all sources.

mod imports;
mod rooms;
mod source;

use imports::{House, Import};
use rooms::{ROOMS, Room};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The crates of the house and their folders. The commands are a crate of their own beside the library's files.
const CRATES: [(&str, &str); 4] =
    [("mach_runtime", "runtime/src"), ("mach_command", "command/src"), ("commands", "src/cli"), ("machc", "src")];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn house() -> House {
    House::read(root(), &CRATES)
}

#[test]
fn every_file_has_its_room_and_every_room_its_files() {
    let house = house();
    let files: Vec<&str> = house.files().collect();
    let homeless: Vec<&str> = files.iter().copied().filter(|file| Room::of(file).is_none()).collect();
    assert!(homeless.is_empty(), "these files stand in no room of tests/house/rooms.rs: {homeless:?}");
    let lived_in: BTreeSet<&str> = files.iter().filter_map(|file| Room::of(file)).map(|(_, room)| room.place).collect();
    let empty: Vec<&str> = ROOMS.iter().map(|room| room.place).filter(|place| !lived_in.contains(place)).collect();
    assert!(empty.is_empty(), "these rooms have no files: {empty:?}");
}

#[test]
fn no_room_imports_upward() {
    let is_upward = |import: &&Import| import.to.as_ref().is_some_and(|to| Room::level(&import.from) < Room::level(to));
    told(house().imports().iter().filter(is_upward), "imports from a room above it");
}

#[test]
fn no_room_imports_what_it_must_not_know() {
    let knows = |import: &&Import| {
        Room::of(&import.from).is_some_and(|(_, room)| room.must_not_know.iter().any(|what| import.is_of(what)))
    };
    told(house().imports().iter().filter(knows), "must not know that");
}

#[test]
fn files_import_each_other_in_no_circle() {
    assert_eq!(house().circle(), None);
}

#[test]
fn the_architecture_shows_the_rooms_in_their_order() {
    let page = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("readable");
    let places: Vec<&str> = ROOMS.iter().map(|room| room.place).collect();
    assert_eq!(rooms::shown(&page), places);
}

/// Each import is a line of the failure.
fn told<'a>(imports: impl Iterator<Item = &'a Import>, what: &str) {
    let lines: Vec<String> =
        imports.map(|import| format!("{}: {what}: {}", import.from, import.path.join("::"))).collect();
    assert!(lines.is_empty(), "{}", lines.join("\n"));
}
