//! What every post compiled by machc links to.
//!
//! CL text is read as a stream (`cl`), placed (`place`), solved by the machine's own kinematics
//! (`kinematics`), reduced to one joint path (`branch`), written (`nc`), read as its control reads it (`control`) and
//! compared with the CL (`verify`). The runtime never parses a `.mach` file: a machine reaches it
//! as the tables of `machine` and `nc::dialect` and as an implementation of `kinematics::Kinematics`.

pub mod branch;
pub mod certificate;
pub mod cl;
pub mod compensation;
pub mod control;
pub mod coordinates;
pub mod diagnostic;
pub mod dialect;
pub mod kinematics;
pub mod machine;
pub mod motion;
pub mod nc;
pub mod number;
pub mod path;
pub mod place;
pub mod post;
pub mod rig;
pub mod road;
pub mod segment;
pub mod strictness;
pub mod tool;
pub mod toolpath;
pub mod unit;
pub mod vector;
pub mod verify;
