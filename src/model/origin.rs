//! Where a machine's statements stand, for what is printed beside them.

use super::draft::Draft;
use mach_runtime::diagnostic::Place;

/// The files of a machine and its statements in them.
#[derive(Debug, Clone)]
pub struct Origins {
    /// Every file that was read, as what is generated names it; the entry first.
    pub files: Vec<String>,
    /// The same files, as the user or the using file names them; so do all places.
    said: Vec<String>,
    /// The machine's name.
    pub name: Place,
    /// The statement that declares each axis, in the order of the model.
    pub axes: Vec<Place>,
    /// The tool's statement.
    pub tool: Place,
}

impl Origins {
    /// Gives the files other names in what is generated: the paths of a user's machine do not belong there.
    pub fn call_files(&mut self, name: impl Fn(&str) -> String) {
        self.files = self.said.iter().map(|said| name(said)).collect();
    }

    /// A place as what is generated names it.
    pub(crate) fn in_generated_text(&self, place: &Place) -> Place {
        let file =
            self.said.iter().position(|said| *said == place.file).expect("every place is in a file that was read");
        Place { file: self.files[file].clone(), ..place.clone() }
    }
}

/// The origins of a checked draft.
pub(crate) fn origins(draft: &Draft<'_>) -> Origins {
    let sources = draft.sources;
    let files: Vec<String> = sources.ids().map(|id| sources.name(id).to_owned()).collect();
    Origins {
        said: files.clone(),
        files,
        name: sources.place(&draft.name.at),
        axes: draft.axes.iter().map(|axis| sources.place(&axis.at)).collect(),
        tool: sources.place(&draft.tool.as_ref().expect("a draft without findings is complete").at),
    }
}

/// The marked text on one line, without comments.
pub fn on_one_line(place: &Place) -> String {
    let lines = place.excerpt[place.start..place.end].lines();
    let code = lines.map(|line| line.split("//").next().unwrap_or_default());
    code.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ")
}
