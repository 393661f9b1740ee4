//! `like`: a definition's statements on top of its family's.

use super::library::{Entry, Library, Shelf};
use super::lost::Lost;
use super::source::{Located, Location, SourceId, SourceMap};
use super::subject::Statement;
use crate::diagnostic::{Code, Diagnostic};
use crate::syntax::tree::{Body, Broken, ControllerStatement, MachineStatement, Name};
use std::collections::{BTreeMap, BTreeSet};

/// The same thing said twice.
pub(crate) static SAID_TWICE: Code = Code {
    id: "E0208",
    title: "the same thing is said twice",
    explanation: "\
A body says each thing once: one `chain`, one `tool`, one statement an axis, a parameter, a word or an event.

    linear X along +x travel -355 .. 355
    linear X along +y travel -310 .. 200      // meant Y?

A definition that is `like` another may say again what its family says: its own statement replaces the family's.
",
};

/// A definition that is like itself.
pub(crate) static LIKE_CYCLE: Code = Code {
    id: "E0212",
    title: "definitions are like each other in a circle",
    explanation: "\
A machine or controller takes over from the one it is `like`; it cannot be like itself, neither directly nor through
others.

    machine a like b { }
    machine b like a { }
",
};

/// What is said of a machine or a controller.
#[derive(Clone)]
pub(crate) struct Said<T> {
    pub(crate) statements: Vec<Located<T>>,
    /// What is said beside them, and was not understood.
    pub(crate) lost: Lost,
}

/// What is said of a machine.
pub(crate) fn of_machine(
    library: &Library<'_>,
    machine: Entry<'_, MachineStatement>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Said<MachineStatement> {
    statements(&library.machines, machine, library.sources, diagnostics)
}

/// The statements of a definition and of everything it is like: the family's first, each replaced by a later one about
/// the same thing.
fn statements<'a, T: Statement>(
    shelf: &Shelf<'a, T>,
    entry: Entry<'a, T>,
    sources: &SourceMap,
    diagnostics: &mut Vec<Diagnostic>,
) -> Said<T> {
    let (members, lost) = lineage(shelf, entry, sources, diagnostics);
    let mut layers = Said { statements: Vec::new(), lost };
    for member in members {
        overlay(&mut layers, body(&member.definition.body, member.source, sources, diagnostics));
    }
    layers
}

/// A machine's statements about its controller, over the controller's own; and the controller's name.
pub(crate) fn controller<'a>(
    library: &Library<'_>,
    machine: &'a [Located<MachineStatement>],
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<Controller<'a>> {
    let blocks: Vec<(SourceId, &'a Name, &Body<ControllerStatement>)> = machine
        .iter()
        .filter_map(|statement| match &statement.value {
            MachineStatement::Controller { name, body } => Some((statement.at.source, name, body)),
            _ => None,
        })
        .collect();
    let (source, name, _) = *blocks.last()?;
    let family = match library.controllers.find(name, source, library.sources, diagnostics) {
        Some(entry) => statements(&library.controllers, entry, library.sources, diagnostics),
        None => Said { statements: Vec::new(), lost: Lost::anything(source, name.span.clone()) },
    };
    let mut own = Said { statements: Vec::new(), lost: Lost::default() };
    for (source, _, changes) in blocks.into_iter().filter(|block| block.1.value == name.value) {
        overlay(&mut own, body(changes, source, library.sources, diagnostics));
    }
    let name = Located { value: name, at: Location { source, span: name.span.clone() } };
    let mut said = family.clone();
    overlay(&mut said, own.clone());
    Some(Controller { name, family: family.statements, own: own.statements, said })
}

/// A controller as a machine has it.
pub(crate) struct Controller<'a> {
    /// The machine's word for it.
    pub(crate) name: Located<&'a Name>,
    /// What its definition and its family say.
    pub(crate) family: Vec<Located<ControllerStatement>>,
    /// What the machine changes.
    pub(crate) own: Vec<Located<ControllerStatement>>,
    /// What holds: the one over the other.
    pub(crate) said: Said<ControllerStatement>,
}

/// The definition and everything it is like, the eldest first. Behind an unknown family or in a circle anything is lost.
fn lineage<'a, T>(
    shelf: &Shelf<'a, T>,
    entry: Entry<'a, T>,
    sources: &SourceMap,
    diagnostics: &mut Vec<Diagnostic>,
) -> (Vec<Entry<'a, T>>, Lost) {
    let mut members = vec![entry];
    let mut eldest = entry;
    let mut lost = Lost::default();
    while let Some(like) = &eldest.definition.like {
        let unknown = || Lost::anything(eldest.source, like.span.clone());
        let Some(elder) = shelf.find(like, eldest.source, sources, diagnostics) else {
            lost = unknown();
            break;
        };
        if members.iter().any(|member| member.at() == elder.at()) {
            let name = &elder.definition.name.value;
            let at = Location { source: eldest.source, span: like.span.clone() };
            let message = format!("the {} `{name}` is like itself", shelf.kind);
            diagnostics.push(Diagnostic::error(&LIKE_CYCLE, message).at(sources.place(&at), "closes the circle"));
            lost = unknown();
            break;
        }
        members.push(elder);
        eldest = elder;
    }
    members.reverse();
    (members, lost)
}

/// A body's statements; what it says twice is reported.
fn body<T: Statement>(
    body: &Body<T>,
    source: SourceId,
    sources: &SourceMap,
    diagnostics: &mut Vec<Diagnostic>,
) -> Said<T> {
    let inside: Vec<Broken> = body.statements.iter().flat_map(|stated| stated.node.broken()).collect();
    let mut said: BTreeMap<String, Location> = BTreeMap::new();
    let mut statements = Vec::new();
    for (span, value) in body.statements.iter().flat_map(|stated| stated.node.parts(&stated.span)) {
        let at = Location { source, span };
        for subject in value.subjects() {
            let Some(first) = said.insert(subject.clone(), at.clone()) else { continue };
            if inside.iter().any(|broken| T::may_be_about(broken, &subject)) {
                continue;
            }
            let diagnostic = Diagnostic::error(&SAID_TWICE, format!("`{subject}` is said twice"))
                .at(sources.place(&at), "said again")
                .at(sources.place(&first), "first said here");
            diagnostics.push(diagnostic);
        }
        statements.push(Located { value, at });
    }
    Said { statements, lost: Lost::of(source, body.broken.iter().cloned().chain(inside)) }
}

/// Puts statements on top: one that is about the same thing takes the place of the one below, and one that may be takes it
/// away.
fn overlay<T: Statement>(below: &mut Said<T>, above: Said<T>) {
    let may_be_about = |subject: &String| above.lost.any(|broken| T::may_be_about(broken, subject));
    below.statements.retain(|statement| !statement.value.subjects().iter().any(may_be_about));
    replace(&mut below.statements, above.statements);
    below.lost.extend(above.lost);
}

fn replace<T: Statement>(below: &mut Vec<Located<T>>, above: Vec<Located<T>>) {
    let mut places: BTreeMap<String, usize> = BTreeMap::new();
    for (index, statement) in below.iter().enumerate().filter(|(_, statement)| !statement.value.adds_to_family()) {
        places.extend(statement.value.subjects().into_iter().map(|subject| (subject, index)));
    }
    let mut gone: BTreeSet<usize> = BTreeSet::new();
    let mut instead: BTreeMap<usize, Vec<Located<T>>> = BTreeMap::new();
    let mut new = Vec::new();
    for statement in above {
        let subjects = statement.value.subjects();
        let replaced: Vec<usize> = subjects.iter().filter_map(|subject| places.get(subject).copied()).collect();
        gone.extend(&replaced);
        match replaced.first() {
            Some(first) => instead.entry(*first).or_default().push(statement),
            None => new.push(statement),
        }
    }
    for (index, statement) in std::mem::take(below).into_iter().enumerate() {
        below.extend(Some(statement).filter(|_| !gone.contains(&index)));
        below.extend(instead.remove(&index).unwrap_or_default());
    }
    below.extend(new);
}
