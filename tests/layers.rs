//! The files of a package import one another in one direction: there is no circle of files, and no folder imports one
//! that stands after it in the order of the data.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// What lies at the top of each package's sources, in the order of the data: what stands later imports what stands
/// earlier. `lib.rs` and `mod.rs` hold the front of a package and stand where they are used.
const ORDER: [(&str, &str); 16] = [
    (
        "crates/numbers/src",
        "number decimal sign enclosure interval directed fixed_float wide root power polynomial vector symmetric bernstein form sequence table",
    ),
    (
        "crates/schema/src",
        "term shown json head integrable part command certificate classification nonlinear critical atlas point_proof find grid listing section chaos motion periodic rotation tolerance spin state spin_down steady scan border comparison classes",
    ),
    ("crates/body/src", "axis rigid_body frame integrable coincidence principal presets part"),
    ("crates/equilibria/src", "curves stability nonlinear critical permanent"),
    ("crates/diagram/src", "topology arrangement atlas class fast accessible region_changes spin_down"),
    (
        "crates/exact/src",
        "statistics id model family curves estimate evaluator equal_momentum ridges critical_values plane mirror pair polar arrange region certificate conversion vertex plane_point \
         answers solver steady state spins",
    ),
    ("crates/dynamics/src", "field integrator motion section poincare"),
    ("crates/enclosure/src", "bound scalar field set step start integrals orbit return_map"),
    ("crates/chaos/src", "liouville share point_shares cells block map"),
    (
        "crates/periodic/src",
        "flow reversor chain shooting walk orbit family catalogue chart section_map proof list manifold",
    ),
    (
        "crates/survey/src",
        "parallel parameter design signature scan border events path space strata nearest subdivision search tolerance",
    ),
    (
        "crates/documents/src",
        "layout codes body integrals subject chaos periodic orbit_list orbit_catalogue proved spin_change stability classification critical manifolds steady tolerance spin state spin_down grid atlas certified scan reading border comparison classes find witnesses \
         section words",
    ),
    ("crates/verify/src", "refused numbers equilibria order topology stability document"),
    (
        "crates/page/src",
        "perception sight error geometry formula color places path text notation tikz picture areas union canvas legend axes caption table chart",
    ),
    ("crates/plot/src", "animation steady campbell periods diagram map section chaos sphere part"),
    (
        "src/cli",
        "failure terminal input export batch listings explain part spin atlas show classify critical verify section chaos sphere \
         orbit periodic explore scan find classes compare arguments",
    ),
];

#[test]
fn no_circle_of_files() {
    let found: Vec<BTreeSet<String>> = packages().iter().flat_map(|package| circles(&package.imports())).collect();
    assert!(found.is_empty(), "these files import one another in a circle: {found:#?}");
}

#[test]
fn no_import_against_the_order_of_the_folders() {
    let packages = packages();
    let mut backward = BTreeSet::new();
    for (folder, order) in ORDER {
        let order: Vec<&str> = order.split_whitespace().collect();
        let top = |file: &str| -> Option<String> {
            let name = file.strip_prefix(folder)?.strip_prefix('/')?.split(['/', '.']).next()?;
            (!matches!(name, "lib" | "main" | "mod")).then(|| name.to_owned())
        };
        let place = |name: String| {
            order.iter().position(|ordered| *ordered == name).unwrap_or_else(|| panic!("{folder}: where is {name}?"))
        };
        let names = packages.iter().flat_map(|package| package.files.values()).filter_map(|file| top(&file.name));
        let places: BTreeSet<usize> = names.map(place).collect();
        assert_eq!(places.len(), order.len(), "{folder} lacks some of {order:?}");
        for (from, to) in packages.iter().flat_map(Package::arrows) {
            if let (Some(here), Some(there)) = (top(&from), top(&to))
                && place(here) < place(there)
            {
                backward.insert((from, to));
            }
        }
    }
    assert!(backward.is_empty(), "(importing file, imported file), against the order: {backward:#?}");
}

/// The check itself: it sees an import in each way in which one is written.
#[test]
fn every_way_to_import_is_seen() {
    let texts = [
        ("lib.rs", "mod a; mod b; pub use b::Thing;"),
        ("a/mod.rs", "mod inner; pub use inner::Deep as Shown; fn f() { inner::go(); }"),
        ("a/inner.rs", "use crate::{b::{Thing, self}}; // use super::Nothing\nstruct Deep;"),
        (
            "b.rs",
            "fn f(x: super::a::Shown) { let text = \"crate::c::X\"; }\n#[cfg(test)]\nmod tests { use crate::c::X; }",
        ),
        ("c.rs", "use crate::Thing;"),
    ];
    let package = Package::new(texts.map(|(name, text)| (name.to_owned(), text.to_owned())));
    let arrows: BTreeSet<(String, String)> = package.arrows().collect();
    let wanted = [("a/inner.rs", "b.rs"), ("a/mod.rs", "a/inner.rs"), ("b.rs", "a/inner.rs"), ("c.rs", "b.rs")];
    assert_eq!(arrows, wanted.map(|(from, to)| (from.to_owned(), to.to_owned())).into());
    assert_eq!(circles(&package.imports()), [["a/inner.rs", "b.rs"].map(str::to_owned).into()]);
}

/// The place of a module: the names on the way from the root of its package.
type Place = Vec<String>;

/// A file as a module.
struct File {
    name: String,
    /// Paths that are imported, or that stand in the code.
    paths: Vec<Place>,
    /// Names that are passed on (`pub use`), and what they mean.
    passed_on: BTreeMap<String, Place>,
}

/// The files of a package by their places.
struct Package {
    files: BTreeMap<Place, File>,
}

/// Every package of the repository.
fn packages() -> Vec<Package> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let crates = fs::read_dir(root.join("crates")).expect("the packages lie in crates/");
    let mut sources: Vec<PathBuf> = crates.map(|entry| entry.expect("an entry").path().join("src")).collect();
    sources.push(root.join("src"));
    let read = |path: PathBuf| {
        let name = path.strip_prefix(root).expect("a path below the root").to_string_lossy().replace('\\', "/");
        (name, fs::read_to_string(path).expect("a source file"))
    };
    sources.iter().map(|source| Package::new(rust_files(source).into_iter().map(read))).collect()
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().map(|entry| entry.expect("an entry").path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let files = files.into_iter().filter(|path| path.extension().is_some_and(|ending| ending == "rs"));
    files.chain(folders.iter().flat_map(|folder| rust_files(folder))).collect()
}

impl Package {
    /// Of the names and texts of its files.
    fn new(texts: impl IntoIterator<Item = (String, String)>) -> Self {
        let mut files = BTreeMap::new();
        let mut tests = Vec::new();
        for (name, text) in texts {
            let inside = name.split_once("src/").map_or(name.as_str(), |(_, inside)| inside);
            let mut place: Place = inside.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
            if place == ["main"] {
                continue;
            }
            if matches!(place.last().map(String::as_str), Some("mod" | "lib")) {
                place.pop();
            }
            let words = words(&text);
            let (code, test_modules) = without_tests(&words);
            tests.extend(test_modules.into_iter().map(|module| [place.clone(), vec![module]].concat()));
            files.insert(place.clone(), File::new(name, &place, &code));
        }
        files.retain(|place, _| !tests.iter().any(|test| place.starts_with(test)));
        Self { files }
    }

    /// Which file imports which.
    fn arrows(&self) -> impl Iterator<Item = (String, String)> {
        self.files.iter().flat_map(|(place, file)| {
            let targets = file.paths.iter().filter_map(|path| self.file_of(path)).filter(move |to| *to != place);
            targets.map(|to| (file.name.clone(), self.files[to].name.clone()))
        })
    }

    fn imports(&self) -> BTreeMap<String, BTreeSet<String>> {
        let mut imports: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for (from, to) in self.arrows() {
            imports.entry(from).or_default().insert(to);
        }
        imports
    }

    /// The file that defines what a path names; what is passed on is followed.
    fn file_of(&self, path: &[String]) -> Option<&Place> {
        let deepest = (0..=path.len()).rev().find(|&length| self.files.contains_key(&path[..length]))?;
        let (place, file) = self.files.get_key_value(&path[..deepest])?;
        match path.get(deepest).and_then(|name| file.passed_on.get(name)) {
            Some(meant) => self.file_of(&[meant, &path[deepest + 1..]].concat()),
            None => Some(place),
        }
    }
}

impl File {
    fn new(name: String, place: &Place, words: &[String]) -> Self {
        let children: BTreeSet<&str> =
            words.windows(3).filter(|w| w[0] == "mod" && w[2] == ";").map(|w| w[1].as_str()).collect();
        let absolute = |path: &[String]| -> Option<Place> {
            let mut base = match path.first()?.as_str() {
                "crate" => Vec::new(),
                "self" | "super" => place.clone(),
                child if children.contains(child) => [&place[..], &path[..1]].concat(),
                _ => return None,
            };
            let ups = path.iter().filter(|part| *part == "super").count();
            base.truncate(base.len().checked_sub(ups)?);
            base.extend(path[1..].iter().filter(|part| *part != "super" && *part != "self").cloned());
            Some(base)
        };
        let mut file = Self { name, paths: Vec::new(), passed_on: BTreeMap::new() };
        let mut at = 0;
        while at < words.len() {
            if words[at] == "use" {
                let end = at + words[at..].iter().position(|word| word == ";").unwrap_or(words.len() - at);
                let passed_on = at > 0 && (words[at - 1] == "pub" || words[at - 1] == ")");
                for (path, alias) in use_tree(&words[at + 1..end]) {
                    match absolute(&path) {
                        Some(path) if passed_on => drop(file.passed_on.insert(alias, path)),
                        Some(path) => file.paths.push(path),
                        None => {}
                    }
                }
                at = end;
            } else if is_name(&words[at]) && words.get(at + 1).is_some_and(|word| word == "::") {
                let mut path = vec![words[at].clone()];
                while at + 2 < words.len() && words[at + 1] == "::" && is_name(&words[at + 2]) {
                    path.push(words[at + 2].clone());
                    at += 2;
                }
                file.paths.extend(absolute(&path));
            }
            at += 1;
        }
        file
    }
}

/// The paths of a `use`, and the names under which they are known.
fn use_tree(words: &[String]) -> Vec<(Place, String)> {
    let mut done = Vec::new();
    // Prefixes of the braces that are open, and the path that is being read.
    let (mut prefixes, mut path, mut alias): (Vec<Place>, Place, Option<String>) = (vec![Vec::new()], Vec::new(), None);
    let mut words = words.iter().map(String::as_str).chain([","]);
    while let Some(word) = words.next() {
        match word {
            "{" => prefixes.push(std::mem::take(&mut path)),
            "," | "}" => {
                if let Some(last) = path.last() {
                    let whole = [prefixes.concat(), path.clone()].concat();
                    let name = if last == "self" { whole[whole.len() - 2].clone() } else { last.clone() };
                    done.push((whole, alias.take().unwrap_or(name)));
                }
                path.clear();
                if word == "}" {
                    prefixes.pop();
                }
            }
            "as" => alias = words.next().map(str::to_owned),
            name if is_name(name) => path.push(name.to_owned()),
            _ => {}
        }
    }
    done
}

fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// The code without its modules for tests, and the names of those that lie in files of their own.
fn without_tests(words: &[String]) -> (Vec<String>, Vec<String>) {
    let (mut code, mut files, mut at) = (Vec::new(), Vec::new(), 0);
    while at < words.len() {
        let rest = &words[at..];
        let marked = ["#", "[", "cfg", "(", "test", ")", "]", "mod"];
        if rest.len() > marked.len() + 1 && rest.iter().zip(marked).all(|(word, marked)| word == marked) {
            let mut depth = 0;
            let end = rest.iter().position(|word| match word.as_str() {
                "{" => {
                    depth += 1;
                    false
                }
                "}" => {
                    depth -= 1;
                    depth == 0
                }
                ";" => depth == 0,
                _ => false,
            });
            if rest[marked.len() + 1] == ";" {
                files.push(rest[marked.len()].clone());
            }
            at += end.map_or(rest.len(), |end| end + 1);
        } else {
            code.push(rest[0].clone());
            at += 1;
        }
    }
    (code, files)
}

/// Names, `::` and single signs; comments and texts are left out.
fn words(text: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if let Some(length) = literal(rest) {
            length
        } else if c.is_alphanumeric() || c == '_' {
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
            words.push(rest[..end].to_owned());
            end
        } else if rest.starts_with("::") {
            words.push("::".to_owned());
            2
        } else {
            if !c.is_whitespace() {
                words.push(c.to_string());
            }
            c.len_utf8()
        };
        rest = &rest[length..];
    }
    words
}

/// The length of a text or of a letter in quotes at the start.
fn literal(text: &str) -> Option<usize> {
    let raw = text.trim_start_matches('b');
    if let Some(hashes) = raw.strip_prefix('r').map(|raw| raw.len() - raw.trim_start_matches('#').len()) {
        let end = format!("\"{}", "#".repeat(hashes));
        let start = text.len() - raw.len() + 1 + hashes;
        if text.len() - raw.len() <= 1 && text[start..].starts_with('"') {
            return Some(text[start + 1..].find(&end).map_or(text.len(), |at| start + 1 + at + end.len()));
        }
    }
    let quote = text.chars().next().filter(|c| *c == '"' || *c == '\'')?;
    let mut letters = text.char_indices().skip(1);
    while let Some((at, c)) = letters.next() {
        match c {
            '\\' => drop(letters.next()),
            c if c == quote => return Some(at + 1),
            // A lifetime.
            _ if quote == '\'' && at > 1 && !text.starts_with("'\\") => return None,
            _ => {}
        }
    }
    None
}

/// The sets of files that reach one another, if there is more than one in it.
fn circles(imports: &BTreeMap<String, BTreeSet<String>>) -> Vec<BTreeSet<String>> {
    let reached = |from: &String| {
        let (mut seen, mut open) = (BTreeSet::new(), vec![from.clone()]);
        while let Some(file) = open.pop() {
            for next in imports.get(&file).into_iter().flatten() {
                if seen.insert(next.clone()) {
                    open.push(next.clone());
                }
            }
        }
        seen
    };
    let reached: BTreeMap<&String, BTreeSet<String>> = imports.keys().map(|file| (file, reached(file))).collect();
    let mut circles = BTreeSet::new();
    for (file, from_it) in &reached {
        if from_it.contains(*file) {
            circles.insert(
                from_it.iter().filter(|other| reached.get(other).is_some_and(|r| r.contains(*file))).cloned().collect(),
            );
        }
    }
    circles.into_iter().collect()
}
