//! The command line, run as a process: what is accepted, what is refused and how, and what is left behind.

mod answers;
mod batches;
mod builder;
mod files;
mod orbits;
mod pages;
mod scan;
mod schemas;
mod sections;
mod streams;
mod wrong_batch_lines;
mod wrong_command_lines;
