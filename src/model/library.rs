//! Every definition by its name, and the one machine that the entry file defines.

use super::load::Program;
use super::lost::Lost;
use super::source::{Location, SourceId, SourceMap};
use crate::diagnostic::{Code, Diagnostic, Suggestion};
use crate::syntax::spelling::nearest;
use crate::syntax::tree::{ControllerStatement, Definition, Item, MachineStatement, Name};
use std::collections::BTreeMap;

/// Two definitions of one name.
pub(crate) static DEFINED_TWICE: Code = Code {
    id: "E0203",
    title: "two definitions have the same name",
    explanation: "\
Within a file and everything it uses, no two machines and no two controllers may have the same name.

    controller syntec \"for mills\" { }
    controller syntec \"for lathes\" { }     // which one would `controller syntec` be?

Give one of them another name; to change a controller for one machine only, write the changes into the machine's own
`controller NAME { }` block.
",
};

/// No machine, or several.
pub(crate) static ONE_MACHINE: Code = Code {
    id: "E0210",
    title: "the file does not define exactly one machine",
    explanation: "\
The file given to machc defines the machine it is to compile, and only that one. Other machines, such as a family that
the machine is `like`, come from other files:

    use \"families/trunnion.mach\"
    machine mill3 like trunnion \"Mill 3\" { let centre = -20.013 mm }
",
};

/// A name that is nowhere defined.
pub(crate) static UNKNOWN_DEFINITION: Code = Code {
    id: "E0211",
    title: "unknown machine or controller",
    explanation: "\
A `like` or a machine's `controller` block names a definition that is neither in the file nor in a file it uses.

    use \"controllers/syntec.mach\"
    machine m { controller sintec { } }      // did you mean `syntec`?
",
};

/// A definition and its file.
#[derive(Debug)]
pub(crate) struct Entry<'a, T> {
    pub(crate) source: SourceId,
    pub(crate) definition: &'a Definition<T>,
}

impl<T> Entry<'_, T> {
    /// Where its name stands.
    pub(crate) fn at(&self) -> Location {
        Location { source: self.source, span: self.definition.name.span.clone() }
    }
}

impl<T> Clone for Entry<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Entry<'_, T> {}

/// Definitions of one kind by name.
pub(crate) struct Shelf<'a, T> {
    /// `machine` or `controller`.
    pub(crate) kind: &'static str,
    entries: BTreeMap<&'a str, Entry<'a, T>>,
    /// What may define others.
    lost: &'a Lost,
}

/// Everything that is defined.
pub(crate) struct Library<'a> {
    pub(crate) machines: Shelf<'a, MachineStatement>,
    pub(crate) controllers: Shelf<'a, ControllerStatement>,
    pub(crate) sources: &'a SourceMap,
}

impl<'a> Library<'a> {
    /// Collects the definitions of all files.
    pub(crate) fn collect(program: &'a Program, diagnostics: &mut Vec<Diagnostic>) -> Self {
        let mut machines = Shelf { kind: "machine", entries: BTreeMap::new(), lost: &program.lost };
        let mut controllers = Shelf { kind: "controller", entries: BTreeMap::new(), lost: &program.lost };
        for (source, item) in program.items() {
            match item {
                Item::Use(_) => {}
                Item::Machine(definition) => machines.put(Entry { source, definition }, &program.sources, diagnostics),
                Item::Controller(definition) => {
                    controllers.put(Entry { source, definition }, &program.sources, diagnostics);
                }
            }
        }
        Self { machines, controllers, sources: &program.sources }
    }
}

impl<'a, T> Shelf<'a, T> {
    fn put(&mut self, entry: Entry<'a, T>, sources: &SourceMap, diagnostics: &mut Vec<Diagnostic>) {
        let name = entry.definition.name.value.as_str();
        // Behind a broken head, a machine's own `controller` block looks like a definition.
        if self.entries.contains_key(name) && self.lost.may_be(&["machine"]) {
            return;
        }
        if let Some(first) = self.entries.get(name) {
            let diagnostic = Diagnostic::error(&DEFINED_TWICE, format!("the {} `{name}` is defined twice", self.kind))
                .at(sources.place(&entry.at()), "defined again")
                .at(sources.place(&first.at()), "first defined here");
            diagnostics.push(diagnostic);
            return;
        }
        self.entries.insert(name, entry);
    }

    /// The definition of this name; a name that is unknown is reported, unless it may be one of what was not understood.
    pub(crate) fn find(
        &self,
        name: &Name,
        source: SourceId,
        sources: &SourceMap,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> Option<Entry<'a, T>> {
        if let Some(entry) = self.entries.get(name.value.as_str()) {
            return Some(*entry);
        }
        if self.lost.may_say(&[self.kind], &name.value) || self.lost.may_be(&["use"]) {
            return None;
        }
        let place = sources.place(&Location { source, span: name.span.clone() });
        let message = format!("there is no {} `{}`", self.kind, name.value);
        let mut diagnostic = Diagnostic::error(&UNKNOWN_DEFINITION, message).at(place.clone(), "unknown");
        if let Some(meant) = nearest(&name.value, self.entries.keys().copied()) {
            let text = format!("did you mean `{meant}`?");
            diagnostic = diagnostic.suggest(Suggestion { text, place, replacement: meant.to_owned() });
        } else {
            diagnostic = diagnostic.note(format!("a {} of another file comes with `use \"…\"`", self.kind));
        }
        diagnostics.push(diagnostic);
        None
    }
}

/// The machine that the entry file defines.
pub(crate) fn entry_machine<'a>(
    program: &'a Program,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<Entry<'a, MachineStatement>> {
    let entry_file = program.sources.ids().next()?;
    let items = program.items().filter(|(source, _)| *source == entry_file);
    let machines: Vec<Entry<'a, MachineStatement>> = items
        .filter_map(|(source, item)| match item {
            Item::Machine(definition) => Some(Entry { source, definition }),
            Item::Use(_) | Item::Controller(_) => None,
        })
        .collect();
    if let [machine] = machines[..] {
        return Some(machine);
    }
    let is_lost = program.files[0].body.broken.iter().any(|broken| broken.may_be(&["machine"]));
    if machines.is_empty() && is_lost {
        return None;
    }
    let name = program.sources.name(entry_file);
    let count = if machines.is_empty() { "no machine".to_owned() } else { format!("{} machines", machines.len()) };
    let mut diagnostic = Diagnostic::error(&ONE_MACHINE, format!("`{name}` defines {count}, and must define one"));
    for machine in machines.iter().skip(1).chain(machines.first()) {
        diagnostic = diagnostic.at(program.sources.place(&machine.at()), "");
    }
    if machines.is_empty() {
        diagnostic = diagnostic.at(program.sources.place(&Location { source: entry_file, span: 0..0 }), "");
    }
    diagnostics.push(diagnostic);
    None
}
