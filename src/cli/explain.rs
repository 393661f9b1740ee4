//! `machc explain`.

use mach_command::outcome::{Failure, Status};
use mach_command::output::print;
use machc::codes;
use machc::diagnostic::Code;

use super::{joints, post};

/// Explain the code of a diagnostic
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Such as E0204; without a code, all of them are listed
    code: Option<String>,
}

pub(super) fn run(arguments: Arguments) -> Result<Status, Failure> {
    let text = match arguments.code {
        None => codes().into_iter().map(|code| format!("{}  {}\n", code.id, code.title)).collect(),
        Some(id) => {
            let found = codes().into_iter().find(|code| code.id.eq_ignore_ascii_case(&id));
            let unknown = || Failure(format!("there is no code `{id}`; `machc explain` lists all of them"));
            let Code { id, title, explanation } = found.ok_or_else(unknown)?;
            format!("{id}: {title}\n\n{}\n", explanation.trim_end())
        }
    };
    print(&text)?;
    Ok(Status::Done)
}

/// The library's codes and those of the command line, in order.
fn codes() -> Vec<&'static Code> {
    let mut codes = codes::all();
    codes.extend([&joints::BAD_JOINTS, &post::NO_CONTROLLER]);
    codes.sort_by_key(|code| code.id);
    codes
}
