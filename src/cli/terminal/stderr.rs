//! Standard error: messages, warnings, and what `-v` reports.

use std::fmt;
use std::io::{self, IsTerminal, Write};
use std::sync::OnceLock;

use bifdiag_schema::harmless;
use tracing::level_filters::LevelFilter;
use tracing::{Event, Level, Subscriber};
use tracing_subscriber::fmt::format::Writer;
use tracing_subscriber::fmt::{FmtContext, FormatEvent, FormatFields};
use tracing_subscriber::layer::SubscriberExt;
use tracing_subscriber::registry::{LookupSpan, Registry};
use tracing_subscriber::reload::{self, Handle};
use tracing_subscriber::util::SubscriberInitExt;

/// A line on stderr, without control of the terminal: a message may quote files; a closed stderr is no reason to stop.
pub fn say(message: &str) {
    say_styled(&harmless(message));
}

/// Likewise, with the colours of a text of our own.
pub fn say_styled(text: &str) {
    let _closed = writeln!(io::stderr(), "{text}");
}

/// True if a person can read stderr as it is written.
pub fn is_terminal() -> bool {
    io::stderr().is_terminal()
}

/// What changes the level of a process that runs several commands.
static LEVEL: OnceLock<Handle<LevelFilter, Registry>> = OnceLock::new();

/// Errors only if `quiet`, else warnings; `verbose` adds more. Where the process has a log of its own already, that one
/// stays.
pub fn log(quiet: bool, verbose: u8) {
    let level = match (quiet, verbose) {
        (true, _) => LevelFilter::ERROR,
        (false, 0) => LevelFilter::WARN,
        (false, 1) => LevelFilter::INFO,
        (false, _) => LevelFilter::DEBUG,
    };
    let handle = LEVEL.get_or_init(|| {
        let (filter, handle) = reload::Layer::new(level);
        let lines = tracing_subscriber::fmt::layer()
            .with_writer(io::stderr)
            .with_ansi(is_terminal())
            .log_internal_errors(false)
            .event_format(LevelAndMessage);
        let _another_is_there = tracing_subscriber::registry().with(filter).with(lines).try_init();
        handle
    });
    let _another_is_there = handle.reload(level);
}

/// `warning: message key=value`
struct LevelAndMessage;

impl<S, N> FormatEvent<S, N> for LevelAndMessage
where
    S: Subscriber + for<'a> LookupSpan<'a>,
    N: for<'a> FormatFields<'a> + 'static,
{
    fn format_event(&self, context: &FmtContext<'_, S, N>, mut writer: Writer<'_>, event: &Event<'_>) -> fmt::Result {
        let level = match *event.metadata().level() {
            Level::ERROR => "error",
            Level::WARN => "warning",
            Level::INFO => "info",
            _ => "debug",
        };
        write!(writer, "{level}: ")?;
        context.format_fields(writer.by_ref(), event)?;
        writeln!(writer)
    }
}
