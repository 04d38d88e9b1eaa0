//! The glossary of the documentation, and the entries that a word means.

use bifdiag_equilibria::curves::{BranchName, CurveName};
use bifdiag_numbers::table::Id;

/// The page itself, so that the documentation and the program say the same.
const PAGE: &str = include_str!("../../../docs/glossary.md");

/// A row of a table of the page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    pub section: &'static str,
    pub terms: Vec<&'static str>,
    pub meaning: String,
    pub also_called: Vec<&'static str>,
}

/// The terms of the program.
pub struct Glossary {
    pub entries: Vec<Entry>,
}

impl Glossary {
    /// The glossary of the documentation.
    pub fn new() -> Self {
        let mut section = "";
        let mut entries = Vec::new();
        for line in PAGE.lines() {
            if let Some(title) = line.strip_prefix("## ") {
                section = title;
            }
            let cells = line.strip_prefix("| ").and_then(|row| row.strip_suffix('|'));
            let cells: Vec<&str> = cells.into_iter().flat_map(|row| row.split(" |")).map(str::trim).collect();
            if let [terms, meaning, also_called] | [terms, meaning, also_called, ""] = cells[..]
                && terms != "term"
                && !terms.starts_with("--")
            {
                entries.push(Entry {
                    section,
                    terms: parts(terms),
                    meaning: meaning.replace('`', ""),
                    also_called: parts(also_called),
                });
            }
        }
        Self { entries }
    }

    /// The entries that a word refers to: those with this term or other name; for the name of one of many things, such
    /// as R5 or M7, the entry of its kind; and those whose name contains it, such as Krein.
    pub fn find(&self, word: &str) -> Vec<&Entry> {
        let lower = word.to_lowercase();
        let endings = [
            ("ies", "y"),
            ("es", ""),
            ("s", ""),
            ("ices", "ex"),
            ("ices", "ix"),
            ("ae", "a"),
            ("i", "us"),
            ("ia", "ium"),
        ];
        let singular = |(plural, one)| Some(format!("{}{one}", lower.strip_suffix(plural)?));
        let singulars: Vec<String> = endings.into_iter().filter_map(singular).filter(|one| one.len() > 1).collect();
        let is_kind = |entry: &Entry| kind(word).is_some_and(|term| entry.terms.contains(&term));
        // R1 to R3 are regions, and r1 to r3 the components of r: whoever types R1 may mean either.
        let may_be_both = |entry: &Entry| is_kind(entry) && word.starts_with('R');
        let ways: [&dyn Fn(&Entry) -> bool; 4] = [
            &|entry| entry.is_called(word) || may_be_both(entry),
            &is_kind,
            &|entry| singulars.iter().any(|one| entry.is_called(one)),
            &|entry| entry.has_part(word),
        ];
        let found = |way: &&dyn Fn(&Entry) -> bool| self.entries.iter().filter(|entry| way(entry)).collect::<Vec<_>>();
        ways.iter().map(found).find(|found| !found.is_empty()).unwrap_or_default()
    }

    /// Terms that are written nearly so, the nearest first.
    pub fn nearest(&self, word: &str) -> Vec<&'static str> {
        const MOST: usize = 3;
        let word = folded(word);
        let names = self.entries.iter().flat_map(Entry::names);
        let distance = |name: &'static str| (edits(&word, &folded(name)), name);
        let mut near: Vec<(usize, &str)> = names.map(distance).collect();
        near.sort_by_key(|(edits, _)| *edits);
        near.dedup_by(|p, q| folded(p.1) == folded(q.1));
        // A word with less than two thirds of its letters right matches nothing.
        near.retain(|(edits, name)| 3 * edits <= word.chars().count().max(folded(name).chars().count()));
        near.into_iter().map(|(_, name)| name).take(MOST).collect()
    }
}

impl Entry {
    /// All its names; of `stable (energy)` also the part in parentheses, and of `fold (of steady axes)` also the part
    /// before them.
    fn names(&self) -> impl Iterator<Item = &'static str> + '_ {
        let all = self.terms.iter().chain(&self.also_called).copied();
        let part = |name: &'static str| {
            let (before, inner) = name.split_once(" (")?;
            if inner.starts_with("of ") { Some(before) } else { inner.strip_suffix(')') }
        };
        all.flat_map(move |name| std::iter::once(name).chain(part(name)))
    }

    fn is_called(&self, word: &str) -> bool {
        self.names().any(|name| folded(name) == folded(word))
    }

    /// A word of one of its names, without the s of a genitive.
    fn has_part(&self, word: &str) -> bool {
        let parts = self.names().flat_map(|name| name.split([' ', '-', '–', ',']));
        let bare = |part: &str| folded(part.trim_end_matches("'s").trim_end_matches("’s"));
        word.chars().count() > 2 && parts.map(bare).any(|part| part == folded(word))
    }
}

/// The parts between commas or semicolons outside parentheses.
fn parts(cell: &'static str) -> Vec<&'static str> {
    let mut depth = 0_i32;
    let outside = |c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth == 0 && (c == ',' || c == ';')
    };
    cell.split(outside).map(|part| part.trim().trim_matches('`')).filter(|part| !part.is_empty()).collect()
}

/// A word without what spellings differ in: capitals, blanks, parentheses, hyphens inside, apostrophes, accents, raised and
/// lowered digits.
pub fn folded(word: &str) -> String {
    let mut out = String::new();
    let mut rest = word.trim().chars().peekable();
    while let Some(c) = rest.next() {
        match c {
            // The sign of P− stays.
            '-' | '–' | '−' | '⁻' if !out.is_empty() && rest.peek().is_some_and(|next| next.is_alphanumeric()) => {
            }
            '-' | '–' | '−' | '⁻' => out.push('-'),
            '⁺' => out.push('+'),
            '²' => out.push('2'),
            '³' => out.push('3'),
            '₀'..='₉' => out.extend(char::from_digit(u32::from(c) - u32::from('₀'), 10)),
            '×' => out.push('x'),
            'ℝ' => out.push('r'),
            'é' | 'è' => out.push('e'),
            // The circumflex of r̂, and separators of words.
            '\u{302}' | ' ' | '(' | ')' | '_' | '\'' | '’' | '′' | '`' | '.' => {}
            _ => out.extend(c.to_lowercase()),
        }
    }
    out
}

/// The term for the kind of thing that a word names.
fn kind(word: &str) -> Option<&'static str> {
    let upper = word.to_uppercase().replace('−', "-");
    let number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let numbered = |start: &str| upper.strip_prefix(start).is_some_and(number);
    let between =
        |start: &str, end: &str| upper.strip_prefix(start).and_then(|rest| rest.strip_suffix(end)).is_some_and(number);
    let is_type = || {
        let (circles, poles) = upper.strip_prefix('K')?.split_once('N')?;
        (number(circles) && number(poles)).then_some(())
    };
    // Three moments part the μ of the generic family into four intervals.
    let branch = |name: &BranchName| match name {
        BranchName::Generic(interval) => (interval.index() < 4).then_some("generic"),
        BranchName::Axis(_) => Some("axis"),
        BranchName::Pole(_) => Some("pole line"),
        BranchName::Over(axes) => Some(match axes.iter().filter(|axis| **axis).count() {
            1 => "pair",
            2 => "circle",
            _ => "sphere",
        }),
    };
    let in_directions = || upper.starts_with("UNSTABLE IN ") && upper.contains(" DIRECTION");
    let is_class = || word.len() == 12 && word.bytes().all(|byte| byte.is_ascii_hexdigit());
    match () {
        () if numbered("R") => Some("region"),
        () if numbered("E") => Some("event"),
        () if numbered("M") => Some("Mg"),
        () if is_type().is_some() => Some("type"),
        () if between("S2-", "D2") => Some("S2-kD2"),
        () if between("#", "(S1XS2)") => Some("#k(S1xS2)"),
        () if upper.starts_with("KATOK:") => Some("Katok"),
        () if is_class() => Some("class"),
        () if upper.starts_with("BETWEEN AX") => Some("between axis i and axis k"),
        () if upper.starts_with("PAIR OVER AX") => Some("pair"),
        () if upper.starts_with("CIRCLE OVER AX") => Some("circle"),
        () if upper.starts_with("POLE LINE OF ") => Some("pole line"),
        () if in_directions() => Some("lost"),
        () => match upper.parse() {
            Ok(CurveName::Piece { branch: name, .. }) => branch(&name),
            Ok(CurveName::Pole(_)) => Some("pole line"),
            Ok(CurveName::Rest) | Err(_) => upper.parse().ok().as_ref().and_then(branch),
        },
    }
}

/// The least number of letters to insert, leave out or exchange, or of neighbours to swap, that makes one word the other.
fn edits(from: &str, to: &str) -> usize {
    let (from, to): (Vec<char>, Vec<char>) = (from.chars().collect(), to.chars().collect());
    let mut rows: Vec<Vec<usize>> = vec![(0..=to.len()).collect()];
    for (i, p) in from.iter().enumerate() {
        let mut row = vec![i + 1];
        for (j, q) in to.iter().enumerate() {
            let above = &rows[i];
            let mut least = (above[j] + usize::from(p != q)).min(above[j + 1] + 1).min(row[j] + 1);
            if i > 0 && j > 0 && *p == to[j - 1] && from[i - 1] == *q {
                least = least.min(rows[i - 1][j - 1] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[from.len()][to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn first_terms(word: &str) -> Vec<&'static str> {
        Glossary::new().find(word).iter().map(|entry| entry.terms[0]).collect()
    }

    #[test]
    fn every_row_of_the_page_is_read() {
        let rows = PAGE.lines().filter(|line| line.starts_with("| ")).count();
        let headings = PAGE.lines().filter(|line| line.starts_with("| term |")).count();
        let Glossary { entries } = Glossary::new();
        assert_eq!(entries.len(), rows - 2 * headings);
        assert!(entries.iter().all(|entry| !entry.terms.is_empty() && !entry.meaning.is_empty()));
        assert!(entries.iter().all(|entry| !entry.section.is_empty()));
    }

    #[test]
    fn other_spellings_are_found() {
        for word in ["Kowalevski", "kovalevskaja", "KOWALEVSKAYA", "Kovalevsky", "kovalevskaya"] {
            assert_eq!(first_terms(word), ["Kovalevskaya"], "{word}");
        }
        for word in ["saddle-centre", "Saddle centre", "saddlecentre", "saddle-centres"] {
            assert_eq!(first_terms(word), ["saddle-centre"], "{word}");
        }
        for word in ["Staude", "Staude's rotation", "staude’s rotations", "relative equilibrium"] {
            assert_eq!(first_terms(word), ["relative equilibrium"], "{word}");
        }
        assert_eq!(first_terms("Krein"), ["hamiltonian-hopf"]);
        assert_eq!(first_terms("goryachev-chaplygin"), ["Goryachev–Chaplygin"]);
        assert_eq!(first_terms("energy"), ["stable (energy)"]);
        assert_eq!(first_terms("stable (Arnold)"), ["stable (Arnold)"]);
    }

    #[test]
    fn names_of_things_mean_their_kind() {
        for (word, term) in [
            ("R12", "region"),
            ("E3", "event"),
            ("M7", "M2"),
            ("k3n1", "type"),
            ("S2-4D2", "S2-2D2"),
            ("#5(S1xS2)", "(S1xS2)#(S1xS2)"),
            ("G2.1", "generic"),
            ("L-", "axis"),
            ("S2.1", "pair"),
            ("S12", "circle"),
            ("P−", "pole line"),
            ("01036ac4a504", "class"),
            ("katok:6", "Katok"),
            ("between axes 1 and 2 and axis 3", "from −r̂"),
            ("pair over axis 1", "pair"),
            ("circle over axes 1 and 2", "circle"),
            ("unstable in 2 directions", "survives"),
        ] {
            assert_eq!(first_terms(word), [term], "{word}");
        }
    }

    #[test]
    fn a_slip_is_answered_with_what_is_near() {
        let glossary = Glossary::new();
        assert_eq!(glossary.nearest("pichfork")[0], "pitchfork");
        assert_eq!(glossary.nearest("elipitc")[0], "elliptic");
        assert_eq!(glossary.nearest("xyzzyxyzzy"), [""; 0]);
        assert_eq!(
            [("", "abc"), ("abcd", "abdc"), ("cusp", "cusps"), ("a", "b")].map(|(p, q)| edits(p, q)),
            [3, 1, 1, 1]
        );
    }
}
