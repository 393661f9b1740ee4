//! Which file imports which: paths followed to the files in which they end.

use crate::source::{Segments, Source};
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fs;
use std::path::Path;

/// Every source file, and what it imports.
pub(crate) struct House {
    files: BTreeMap<String, File>,
    /// Files by crate and module.
    modules: BTreeMap<Segments, String>,
    imports: Vec<Import>,
}

struct File {
    /// The crate and the module.
    module: Segments,
    source: Source,
}

/// One file names something of another, or of another crate.
pub(crate) struct Import {
    pub(crate) from: String,
    /// The file it ends in; none outside of the house.
    pub(crate) to: Option<String>,
    /// The crate first.
    pub(crate) path: Segments,
}

impl Import {
    /// Whether it is of this place (`src/model`), or of this path or one below (`std::fs`).
    pub(crate) fn is_of(&self, what: &str) -> bool {
        if what.contains('/') {
            let room = self.to.as_deref().and_then(crate::Room::of);
            return room.is_some_and(|(_, room)| room.place == what);
        }
        what.split("::").eq(self.path.iter().take(what.split("::").count()))
    }
}

impl House {
    /// Reads the crates below a folder; the first whose folder a file is in has it.
    pub(crate) fn read(root: &Path, crates: &[(&str, &str)]) -> Self {
        let mut files = BTreeMap::new();
        for (krate, folder) in crates {
            for file in sources(&root.join(folder)) {
                let path = file.strip_prefix(root).expect("a file of the house").to_str().expect("UTF-8").to_owned();
                let text = fs::read_to_string(&file).expect("readable");
                let module = module(krate, path.strip_prefix(&format!("{folder}/")).expect("a file of its folder"));
                files.entry(path).or_insert_with(|| File { module, source: Source::read(&text) });
            }
        }
        let modules = files.iter().map(|(path, file)| (file.module.clone(), path.clone())).collect();
        let mut house = Self { files, modules, imports: Vec::new() };
        house.imports = house.files.keys().flat_map(|file| house.imports_of(file)).collect();
        house
    }

    pub(crate) fn files(&self) -> impl Iterator<Item = &str> {
        self.files.keys().map(String::as_str)
    }

    pub(crate) fn imports(&self) -> &[Import] {
        &self.imports
    }

    fn imports_of(&self, file: &str) -> Vec<Import> {
        let File { module, source } = &self.files[file];
        let import = |path: &Segments| {
            let path = self.absolute(module, path);
            let to = self.file_of(&path);
            Import { from: file.to_owned(), to, path }
        };
        let imports = source.paths.iter().map(import);
        imports.filter(|import| import.to.as_deref() != Some(file)).collect()
    }

    /// A path as seen from a module, with the crate first.
    fn absolute(&self, module: &[String], path: &[String]) -> Segments {
        let ups = path.iter().take_while(|segment| *segment == "super").count();
        let child = [module, &path[..1]].concat();
        match path[0].as_str() {
            "crate" => [&module[..1], &path[1..]].concat(),
            "self" => [module, &path[1..]].concat(),
            "super" => [&module[..module.len() - ups], &path[ups..]].concat(),
            _ if self.modules.contains_key(&child) => [module, path].concat(),
            _ => path.to_vec(),
        }
    }

    /// The file in which a path ends, beyond what only hands it on.
    fn file_of(&self, path: &[String]) -> Option<String> {
        let (length, file) = (1..=path.len()).rev().find_map(|n| Some((n, self.modules.get(&path[..n])?)))?;
        let File { module, source } = &self.files[file];
        let handed_on = path.get(length).and_then(|name| source.hands_on.get(name));
        let beyond = handed_on.and_then(|to| self.file_of(&[&self.absolute(module, to), &path[length + 1..]].concat()));
        Some(beyond.unwrap_or_else(|| file.clone()))
    }

    /// The shortest circle of files that import each other, if there is one; parent and child may.
    pub(crate) fn circle(&self) -> Option<Vec<&str>> {
        let all: BTreeSet<(&str, &str)> =
            self.imports.iter().filter_map(|import| Some((import.from.as_str(), import.to.as_deref()?))).collect();
        let is_family = |a: &str, b: &str| self.is_parent(a, b) || self.is_parent(b, a);
        let mut outward: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for &(a, b) in all.iter().filter(|&&(a, b)| !(is_family(a, b) && all.contains(&(b, a)))) {
            outward.entry(a).or_default().push(b);
        }
        let edges = outward.iter().flat_map(|(a, targets)| targets.iter().map(move |b| (*a, *b)));
        edges.filter_map(|(a, b)| way(&outward, b, a)).min_by_key(Vec::len)
    }

    fn is_parent(&self, parent: &str, child: &str) -> bool {
        let module = &self.files[child].module;
        module.len() > 1 && self.files[parent].module == module[..module.len() - 1]
    }
}

/// The shortest way from one file to another, both ends included.
fn way<'a>(outward: &BTreeMap<&'a str, Vec<&'a str>>, from: &'a str, to: &'a str) -> Option<Vec<&'a str>> {
    let (mut seen, mut ways) = (BTreeSet::from([from]), VecDeque::from([vec![from]]));
    while let Some(way) = ways.pop_front() {
        let last = *way.last().expect("a way has a beginning");
        if last == to {
            return Some(way);
        }
        let next = outward.get(last).into_iter().flatten().filter(|next| seen.insert(next));
        ways.extend(next.map(|next| [&way[..], &[next]].concat()));
    }
    None
}

/// The Rust files below a folder.
fn sources(folder: &Path) -> Vec<std::path::PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder of sources").map(|entry| entry.expect("readable").path());
    let files = |path: std::path::PathBuf| match path.is_dir() {
        true => sources(&path),
        false => {
            Some(path).filter(|path| path.extension().is_some_and(|extension| extension == "rs")).into_iter().collect()
        }
    };
    entries.flat_map(files).collect()
}

/// The module of a file, as seen from its crate's folder.
fn module(krate: &str, path: &str) -> Segments {
    let path = path.strip_suffix(".rs").expect("a file of Rust");
    let names = path.split('/').filter(|name| !matches!(*name, "mod" | "lib"));
    std::iter::once(krate).chain(names).map(str::to_owned).collect()
}
