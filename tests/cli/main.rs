//! The command line, run as a process: what is accepted, what is refused and how, and what is left behind.

mod answers;
mod attacks;
mod batches;
mod builder;
mod classes;
mod explorer;
mod files;
mod ids;
mod mathematics;
mod orbits;
mod pages;
mod parts;
mod periodic;
mod regions;
mod scan;
mod schemas;
mod sections;
mod sentences;
mod short_orbits;
mod spins;
mod streams;
mod thresholds;
mod verdicts;
mod words;
mod wrong_batch_lines;
mod wrong_command_lines;
