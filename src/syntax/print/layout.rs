//! The page: indentation, columns, comments behind lines.

/// Spaces a level of braces.
const INDENTATION: usize = 4;
/// Between a line and the comment behind it.
const COMMENT_GAP: usize = 2;

/// Lines that are columns of one table when they follow each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Table {
    /// `let`
    Parameters,
    /// `linear`
    LinearAxes,
    /// `rotary`
    RotaryAxes,
    /// `link`
    Links,
    /// a member of a `group`
    Members,
    /// `error` with a value
    Errors,
    /// `at` in a table of errors
    ErrorRows,
    /// `start` and `then`
    Branch,
    /// `format`
    Formats,
    /// `word`
    Words,
}

/// The text of a statement, in cells if it belongs to a table.
pub(super) struct StatementText {
    table: Option<Table>,
    cells: Vec<String>,
}

impl StatementText {
    /// A line that stands for itself.
    pub(super) fn plain(text: impl Into<String>) -> Self {
        Self { table: None, cells: vec![text.into()] }
    }

    /// A row of a table; a cell may be empty.
    pub(super) fn row(table: Table, cells: Vec<String>) -> Self {
        Self { table: Some(table), cells }
    }

    /// The blanks before a column.
    fn gap(&self, column: usize) -> usize {
        match self.table {
            Some(Table::LinearAxes | Table::RotaryAxes) if column > 1 => 2,
            _ => 1,
        }
    }

    /// The line with its columns as wide as given; a column nobody uses takes no place.
    fn joined(&self, widths: &[usize]) -> String {
        let mut text = String::new();
        let columns = self.cells.iter().zip(widths).enumerate().filter(|(_, (_, width))| **width > 0);
        for (column, (cell, width)) in columns {
            let gap = if column == 0 { 0 } else { self.gap(column) };
            text.extend(std::iter::repeat_n(' ', gap));
            text.push_str(cell);
            text.extend(std::iter::repeat_n(' ', width - characters(cell)));
        }
        text.truncate(text.trim_end().len());
        text
    }
}

/// A line in its place.
struct Placed {
    blank_before: bool,
    depth: usize,
    line: StatementText,
    behind: Option<String>,
}

/// The lines of a file.
#[derive(Default)]
pub(super) struct Page {
    lines: Vec<Placed>,
    blank: bool,
}

impl Page {
    /// A blank line before the next line, unless that is the first one.
    pub(super) fn blank(&mut self) {
        self.blank = !self.lines.is_empty();
    }

    /// A comment on a line of its own.
    pub(super) fn comment(&mut self, depth: usize, text: &str) {
        self.push(depth, StatementText::plain(comment(text)), None);
    }

    /// The next line, with the comment behind it.
    pub(super) fn push(&mut self, depth: usize, line: StatementText, behind: Option<&str>) {
        let blank_before = std::mem::take(&mut self.blank);
        self.lines.push(Placed { blank_before, depth, line, behind: behind.map(comment) });
    }

    /// The whole page, columns aligned.
    pub(super) fn text(&self) -> String {
        let same_table = |a: &Placed, b: &Placed| a.line.table.is_some() && a.line.table == b.line.table;
        let texts: Vec<String> = self.runs(same_table).flat_map(table_texts).collect();
        let commented = |a: &Placed, b: &Placed| a.behind.is_some() && b.behind.is_some();
        let mut page = String::new();
        let mut texts = texts.iter();
        for run in self.runs(commented) {
            let rows: Vec<(&Placed, &String)> = run.iter().zip(texts.by_ref()).collect();
            let width = rows.iter().map(|(_, text)| characters(text)).max().unwrap_or(0);
            rows.iter().for_each(|(placed, text)| placed.write(text, width, &mut page));
        }
        page
    }

    /// Neighbours at the same depth, with nothing between them, that belong together.
    fn runs(&self, together: impl Fn(&Placed, &Placed) -> bool) -> impl Iterator<Item = &[Placed]> {
        self.lines.chunk_by(move |a, b| !b.blank_before && a.depth == b.depth && together(a, b))
    }
}

impl Placed {
    fn write(&self, text: &str, width: usize, page: &mut String) {
        if self.blank_before {
            page.push('\n');
        }
        page.extend(std::iter::repeat_n(' ', self.depth * INDENTATION));
        page.push_str(text);
        if let Some(behind) = &self.behind {
            page.extend(std::iter::repeat_n(' ', width - characters(text) + COMMENT_GAP));
            page.push_str(behind);
        }
        page.push('\n');
    }
}

fn table_texts(rows: &[Placed]) -> Vec<String> {
    let columns = rows.iter().map(|row| row.line.cells.len()).max().unwrap_or(0);
    let width =
        |column: usize| rows.iter().filter_map(|row| row.line.cells.get(column)).map(|cell| characters(cell)).max();
    let widths: Vec<usize> = (0..columns).map(|column| width(column).unwrap_or(0)).collect();
    rows.iter().map(|row| row.line.joined(&widths)).collect()
}

fn comment(text: &str) -> String {
    if text.is_empty() { "//".to_owned() } else { format!("// {text}") }
}

fn characters(text: &str) -> usize {
    text.chars().count()
}
