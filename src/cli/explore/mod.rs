//! `bifdiag explore`: the explorer's page, served to this machine alone.

mod server;

use std::env;
use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;

use bifdiag_body::Number;
use bifdiag_documents::Subject;
use clap::Args;

use super::failure::{Failure, failed};
use super::input::{PlainBodyArguments, values};
use super::terminal::{print, say};
use server::Folder;

pub const EXAMPLES: &str = "\
Examples:
  bifdiag explore
  bifdiag explore --body paper --h 3.8 --l 3.25
  bifdiag explore --page web/dist --no-open

The page is built in web/ of the sources (`npm ci && npm run build`); wheels and released programs include it. It is \
served to this machine only, until Ctrl-C.";

/// `bifdiag explore`.
#[derive(Debug, Args)]
pub struct ExploreArguments {
    #[command(flatten)]
    pub body: PlainBodyArguments,
    /// Initial energy
    #[arg(long = "h", value_name = "h", allow_hyphen_values = true, value_parser = values::number)]
    #[arg(requires = "momentum", help_heading = "Point")]
    pub energy: Option<Number>,
    /// Initial vertical angular momentum
    #[arg(long = "l", value_name = "l", allow_hyphen_values = true, value_parser = values::number)]
    #[arg(requires = "energy", help_heading = "Point")]
    pub momentum: Option<Number>,
    /// Folder of the built page (default: `page` beside the program, else web/dist here)
    #[arg(long, value_name = "DIR", help_heading = "Page", hide_short_help = true)]
    pub page: Option<PathBuf>,
    /// Serve at this port (default: a free one)
    #[arg(
        long,
        value_name = "N",
        default_value_t = 0,
        hide_default_value = true,
        help_heading = "Page",
        hide_short_help = true
    )]
    pub port: u16,
    /// Print the address without opening a browser
    #[arg(long, help_heading = "Page")]
    pub no_open: bool,
}

pub fn run(arguments: &ExploreArguments) -> Result<(), Failure> {
    let subject = arguments.body.optional_subject()?;
    let page = arguments.page.clone().or_else(found).ok_or_else(|| {
        Failure::input(
            "this program comes without the page; give --page DIR, the folder that `npm ci && npm run build` makes in \
            web/ of the \
             sources, or install the wheel, which includes it",
        )
    })?;
    let folder = Folder::read(&page).map_err(|error| {
        let page = page.display();
        Failure::input(format!("--page {page}: {error}; give the folder that `npm run build` makes in web/"))
    })?;
    let port = arguments.port;
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))
        .map_err(|error| Failure::input(format!("--port {port}: {error}; leave it out to take one that is free")))?;
    let address = listener.local_addr().map_err(failed("the page could not be served"))?;
    let point = arguments.energy.as_ref().zip(arguments.momentum.as_ref());
    let url = format!("http://{address}/{}", state(subject.as_ref(), point));
    print(format!("{url}\n"))?;
    if !arguments.no_open && !opened(&url) {
        say("no browser could be opened; open the address in one");
    }
    server::serve(&listener, &folder);
    Ok(())
}

/// Serves a folder's page at a free port of this machine until the process ends; returns the port.
///
/// # Errors
/// The folder holds no page, or no port is free.
pub fn serve(page: &Path) -> io::Result<u16> {
    let folder = Folder::read(page)?;
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?;
    let port = listener.local_addr()?.port();
    thread::Builder::new().name("bifdiag explorer".into()).spawn(move || server::serve(&listener, &folder))?;
    Ok(port)
}

/// What the page's address says of a body and a point.
fn state(subject: Option<&Subject>, point: Option<(&Number, &Number)>) -> String {
    let join = |numbers: &[Number; 3]| numbers.each_ref().map(Number::text).join(",");
    let body = subject.map(|Subject { body, .. }| format!("A={}&r={}", join(body.moments()), join(body.center())));
    let point = point.map(|(h, l)| format!("h={}&l={}", h.text(), l.text()));
    let parts: Vec<String> = body.into_iter().chain(point).collect();
    if parts.is_empty() { String::new() } else { format!("#{}", parts.join("&")) }
}

/// The page that belongs to this program.
fn found() -> Option<PathBuf> {
    let beside = env::current_exe().ok().and_then(|program| Some(program.parent()?.join("page")));
    beside.into_iter().chain([Path::new("web").join("dist")]).find(|page| page.join("index.html").is_file())
}

/// Asks the system to open an address; true if it accepted.
fn opened(url: &str) -> bool {
    let (program, first): (&str, &[&str]) = if cfg!(target_os = "macos") {
        ("open", &[])
    } else if cfg!(windows) {
        ("rundll32", &["url.dll,FileProtocolHandler"])
    } else {
        ("xdg-open", &[])
    };
    let mut command = Command::new(program);
    command.args(first).arg(url).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().is_ok()
}
