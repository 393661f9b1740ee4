//! `verify` from outside: programs of the library, programs of others, programs changed by one edit.

mod agreement;
mod foreign;
mod klartext;
mod mill;
mod mutations;
mod plain;
mod published;
mod rs274;
mod verified;

#[path = "../cli/machc.rs"]
#[allow(dead_code)]
mod machc;
#[path = "../common/machine.rs"]
mod machine;
#[path = "../common/refit.rs"]
mod refit;
#[path = "../common/stems.rs"]
mod stems;
