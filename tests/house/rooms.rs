//! The rooms of the house from the ground up: each imports only from those before it, and nothing that it must not know.
//! `ARCHITECTURE.md` shows them in this order and says what they are for.

/// A file, a folder, or both.
pub(crate) struct Room {
    /// Where it is, without the file's extension.
    pub(crate) place: &'static str,
    /// Rooms before it, and paths of code, that it does not import all the same.
    pub(crate) must_not_know: &'static [&'static str],
}

const fn room(place: &'static str, must_not_know: &'static [&'static str]) -> Room {
    Room { place, must_not_know }
}

/// What reads and writes files, or speaks to a terminal.
const OUTSIDE: &[&str] = &["std::fs", "std::env", "std::process", "clap", "tempfile", "mach_command"];
const BLOCKS: &[&str] = &[
    "mach_runtime::kinematics::JointBlock",
    "mach_runtime::kinematics::PoseBlock",
    "mach_runtime::kinematics::SolutionBlock",
    "machc::plan::Interpreter",
];
const POLICIES: &[&str] = &["mach_runtime::machine::BranchPolicy", "mach_runtime::machine::Preference"];

pub(crate) static ROOMS: &[Room] = &[
    room("runtime/src/vector", &[]),
    room("runtime/src/unit", &[]),
    room("runtime/src/number", &[]),
    room("runtime/src/diagnostic", &["annotate_snippets"]),
    room("runtime/src/strictness", &[]),
    room("runtime/src/tool", &[]),
    room("runtime/src/dialect", &[]),
    room("runtime/src/nc/dialect", &[]),
    room("runtime/src/motion", &["runtime/src/nc/dialect"]),
    room("runtime/src/machine", &["runtime/src/dialect", "runtime/src/nc/dialect", "runtime/src/motion"]),
    room("runtime/src/place", &["runtime/src/machine"]),
    room("runtime/src/coordinates", &["runtime/src/dialect", "runtime/src/nc/dialect", "runtime/src/motion"]),
    room("runtime/src/control", &[]),
    room("runtime/src/kinematics", POLICIES),
    room("runtime/src/compensation", POLICIES),
    room("runtime/src/segment", POLICIES),
    room("runtime/src/toolpath", &["runtime/src/machine", "runtime/src/kinematics", "runtime/src/nc/dialect"]),
    room("runtime/src/cl", &["runtime/src/machine", "runtime/src/kinematics", "runtime/src/nc/dialect"]),
    room("runtime/src/branch", &["runtime/src/cl", "runtime/src/toolpath", "runtime/src/compensation"]),
    room("runtime/src/path", &["runtime/src/cl", "runtime/src/nc/dialect"]),
    room("runtime/src/road", &["runtime/src/machine", "runtime/src/path", "runtime/src/nc/dialect"]),
    room("runtime/src/nc", &["runtime/src/cl", "runtime/src/kinematics"]),
    room("runtime/src/certificate", &["runtime/src/nc", "runtime/src/nc/dialect"]),
    room("runtime/src/verify", &["runtime/src/path", "runtime/src/branch"]),
    room("runtime/src/post", OUTSIDE),
    room("runtime/src/rig", OUTSIDE),
    room("runtime/src/lib", &[]),
    room("src/syntax", &["runtime/src/machine", "runtime/src/kinematics"]),
    room("src/plan", &["runtime/src/machine", "src/syntax"]),
    room("src/sources", OUTSIDE),
    room("src/model", OUTSIDE),
    room("src/check", OUTSIDE),
    room("src/derive", BLOCKS),
    room("src/prove", &["src/derive"]),
    room("src/numeric", &["src/derive", "src/model"]),
    room("src/compile", OUTSIDE),
    room("src/emit", &["src/derive", "std::fs", "std::env", "mach_command"]),
    room("src/rig", OUTSIDE),
    room("src/codes", OUTSIDE),
    room("src/compare", OUTSIDE),
    room("src/snapshot", OUTSIDE),
    room("src/lib", &[]),
    room("command/src", &["machc"]),
    room("src/cli", &["libm", "nalgebra", "runtime/src/vector"]),
    room("src/main", &[]),
];

impl Room {
    /// The room of a file and its level; the longest place that fits.
    pub(crate) fn of(file: &str) -> Option<(usize, &'static Room)> {
        let path = file.strip_suffix(".rs").unwrap_or(file);
        let is_in = |place: &str| path.strip_prefix(place).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'));
        ROOMS.iter().enumerate().filter(|(_, room)| is_in(room.place)).max_by_key(|(_, room)| room.place.len())
    }

    /// How high a file's room stands.
    pub(crate) fn level(file: &str) -> Option<usize> {
        Self::of(file).map(|(level, _)| level)
    }
}

/// The rooms that a page shows: the names in the first columns of the tables below headings that begin with a folder.
pub(crate) fn shown(page: &str) -> Vec<String> {
    let (mut folder, mut rooms) = (None, Vec::new());
    for line in page.lines() {
        if line.starts_with('#') {
            folder = line.strip_prefix("### `").and_then(|rest| rest.split_once("/`")).map(|(folder, _)| folder);
        } else if let (Some(folder), Some(row)) = (folder, line.strip_prefix("| `")) {
            let cell = row.split('|').next().unwrap_or(row);
            let names = cell.split('`').step_by(2);
            rooms.extend(names.filter(|name| !name.trim().is_empty()).map(|name| format!("{folder}/{name}")));
        }
    }
    rooms
}
