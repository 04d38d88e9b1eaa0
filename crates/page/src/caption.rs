//! What has left a picture: its legend as a picture of its own, and texts for the caption, plain and for TeX.

use std::fmt::Write;

use plotters::style::RGBColor;

use super::color::{Theme, rgb};
use super::legend::Symbol;
use super::path::Dash;
use super::perception::lab;
use super::picture::Picture;
use super::tikz::tex;

/// A picture and what is said beside it.
#[derive(Clone, Debug)]
pub struct Figure {
    /// The picture.
    pub picture: Picture,
    /// Its legend, where that has left it to be a picture of its own.
    pub legend: Option<Picture>,
    /// What has left it, in words.
    pub caption: Caption,
}

/// A caption: paragraphs, what symbols mean, and tables.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Caption {
    theme: Theme,
    /// As plain text.
    pub text: String,
    /// For LaTeX with the package `xcolor`: lines and areas in their colours.
    pub tex: String,
}

/// What colours are called.
const NAMES: [(&str, RGBColor); 25] = [
    ("black", rgb(0x22_22_22)),
    ("dark grey", rgb(0x46_46_46)),
    ("grey", rgb(0x80_80_80)),
    ("pale grey", rgb(0xe3_e3_e3)),
    ("red", rgb(0xb0_10_18)),
    ("blue", rgb(0x10_3a_9a)),
    ("sky blue", rgb(0x00_b4_f0)),
    ("light blue", rgb(0xcb_d2_fb)),
    ("pale blue", rgb(0xe5_f5_ff)),
    ("green", rgb(0x00_80_5c)),
    ("light green", rgb(0xd5_eb_b4)),
    ("mint", rgb(0xc7_f6_d9)),
    ("sage", rgb(0xb8_d7_c6)),
    ("lime", rgb(0x9d_f0_07)),
    ("khaki", rgb(0xcf_d2_ad)),
    ("yellow", rgb(0xd8_b8_00)),
    ("pale yellow", rgb(0xff_fd_bd)),
    ("orange", rgb(0xdc_72_26)),
    ("pale orange", rgb(0xf6_cf_ba)),
    ("violet", rgb(0xa0_40_f0)),
    ("lavender", rgb(0xd1_bf_fd)),
    ("plum", rgb(0x0078_3264)),
    ("magenta", rgb(0xe8_3c_b4)),
    ("pink", rgb(0xe8_c1_dd)),
    ("pale pink", rgb(0xf1_d9_f9)),
];

/// The name of the nearest colour that has one.
#[must_use]
pub fn color_name(color: RGBColor) -> &'static str {
    let own = lab(color);
    let distance = |color: RGBColor| {
        let other = lab(color);
        let [lightness, a, b] = [own.lightness - other.lightness, own.a - other.a, own.b - other.b];
        lightness * lightness + a * a + b * b
    };
    let nearest = NAMES.into_iter().min_by(|(_, one), (_, other)| distance(*one).total_cmp(&distance(*other)));
    nearest.map_or("", |(name, _)| name)
}

/// The names of some colours, each once.
fn names(colors: impl IntoIterator<Item = RGBColor>) -> String {
    each_once(colors.into_iter().map(|color| color_name(color).to_owned()))
}

fn each_once(names: impl Iterator<Item = String>) -> String {
    let mut each: Vec<String> = Vec::new();
    for name in names {
        if !each.contains(&name) {
            each.push(name);
        }
    }
    each.join(" and ")
}

impl Caption {
    /// An empty one of a picture in a theme.
    #[must_use]
    pub fn new(theme: Theme) -> Self {
        Self { theme, ..Self::default() }
    }

    /// Adds a paragraph.
    pub fn paragraph(&mut self, text: &str) {
        let _ok = writeln!(self.text, "{text}");
        let _ok = writeln!(self.tex, "{}\n", tex(text));
    }

    /// Adds what symbols mean, each in a line.
    pub fn entries<'a>(&mut self, entries: impl IntoIterator<Item = (&'a Symbol, String)>) {
        for (symbol, text) in entries {
            let own = self.words(symbol);
            let colon = if own.is_empty() { "" } else { ": " };
            let _ok = writeln!(self.text, "{own}{colon}{text}");
            let _ok = writeln!(self.tex, "{}{};", self.drawn(symbol), tex(&text));
        }
        self.tex.push('\n');
    }

    /// Adds a table.
    pub fn table(&mut self, heading: &[String], rows: &[Vec<String>]) {
        let width = |column: usize| {
            let cells = rows.iter().filter_map(|row| row.get(column)).chain(heading.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let _ok = writeln!(self.tex, "\\begin{{tabular}}{{{}}}", "l".repeat(heading.len()));
        for row in [heading].into_iter().chain(rows.iter().map(Vec::as_slice)) {
            let padded = row.iter().enumerate().map(|(column, cell)| format!("{cell:<0$}", width(column)));
            let _ok = writeln!(self.text, "{}", padded.collect::<Vec<_>>().join("  ").trim_end());
            let _ok = writeln!(self.tex, "{} \\\\", row.iter().map(|cell| tex(cell)).collect::<Vec<_>>().join(" & "));
        }
        let _ok = writeln!(self.tex, "\\end{{tabular}}");
    }

    /// A symbol in words.
    fn words(&self, symbol: &Symbol) -> String {
        let line = |pattern: &[Dash]| pattern.iter().filter_map(|dash| dash.0).collect::<Vec<_>>();
        match symbol {
            Symbol::None => String::new(),
            // Paler in print, of the same name.
            Symbol::Swatch(colors) if self.theme == Theme::Print => names(colors.iter().copied()),
            Symbol::Swatch(colors) => self.called(colors, Theme::ground),
            Symbol::Line(pattern, _) => format!("{} line", self.called(&line(pattern), Theme::color)),
            Symbol::Dots(colors) => format!("{} dots", self.called(colors, Theme::color)),
            Symbol::Mark(name, _) => (*name).to_owned(),
        }
    }

    /// What colours are called that a theme shows: the names are those of the light one.
    fn called(&self, colors: &[RGBColor], shown: impl Fn(Theme, RGBColor) -> RGBColor) -> String {
        let hex = |RGBColor(red, green, blue): RGBColor| format!("#{red:02X}{green:02X}{blue:02X}");
        match self.theme {
            Theme::Light => names(colors.iter().copied()),
            theme => each_once(colors.iter().map(|color| hex(shown(theme, *color)))),
        }
    }

    /// A symbol for TeX: lines with their dashes, areas by their colours, marks by their names.
    fn drawn(&self, symbol: &Symbol) -> String {
        let rule = |RGBColor(red, green, blue): RGBColor, raise: &str, length: f64, height: f64| {
            format!(
                "\\textcolor[HTML]{{{red:02X}{green:02X}{blue:02X}}}{{\\rule[{raise}]{{{length:.2}bp}}{{{height:.2}bp}}}}"
            )
        };
        let mut out = String::new();
        match symbol {
            Symbol::None => return out,
            Symbol::Mark(name, _) => return format!("{name}: "),
            Symbol::Swatch(colors) => {
                out.extend(colors.iter().map(|color| rule(self.theme.ground(*color), "0pt", 6.0, 6.0)));
            }
            Symbol::Dots(colors) => {
                let dots = colors.iter().map(|color| rule(self.theme.color(*color), ".4ex", 2.0, 2.0));
                out.push_str(&dots.collect::<Vec<_>>().join("\\,"));
            }
            Symbol::Line(pattern, width) => {
                let mut left = symbol.width();
                for (color, length) in pattern.iter().cycle() {
                    let length = if pattern.len() == 1 { left } else { length.min(left) };
                    match color {
                        Some(color) => {
                            out.push_str(&rule(self.theme.color(*color), ".5ex", 0.55 * length, 0.55 * width));
                        }
                        None => out.extend(["\\hspace{", &format!("{:.2}", 0.55 * length), "bp}"]),
                    }
                    left -= length;
                    if left <= 0.0 || length <= 0.0 {
                        break;
                    }
                }
            }
        }
        out + "~"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// They were plum lines.
    #[test]
    fn grey_lines_are_grey() {
        assert_eq!(
            [0x46_46_46, 0x59_59_59, 0x22_22_22].map(|grey| color_name(rgb(grey))),
            ["dark grey", "dark grey", "black"]
        );
    }

    #[test]
    fn symbols_have_words_and_are_drawn_in_tex() {
        let mut caption = Caption::default();
        let dashed = Symbol::Line(vec![(Some(rgb(0xa3_0d_18)), 5.0), (None, 3.0)], 1.5);
        let ground = Symbol::Swatch(vec![rgb(0xe5_f5_ff), rgb(0xc7_f6_d9)]);
        caption.entries([(&dashed, "G0".to_owned()), (&ground, "R1: T²+S²".to_owned())]);
        assert_eq!(caption.text, "red line: G0\npale blue and mint: R1: T²+S²\n");
        assert_eq!(caption.tex.matches("\\rule[.5ex]").count(), 4, "{}", caption.tex);
        assert!(caption.tex.contains("\\textcolor[HTML]{A30D18}") && caption.tex.contains("\\textcolor[HTML]{C7F6D9}"));
        caption.table(&["curve".to_owned(), "l".to_owned()], &[vec!["G0.1".to_owned(), "0 … 1".to_owned()]]);
        assert!(caption.text.ends_with("curve  l\nG0.1   0 … 1\n"), "{}", caption.text);
        assert!(caption.tex.contains("curve & $l$ \\\\\nG0.1 & 0 $\\ldots $ 1 \\\\\n"), "{}", caption.tex);
    }
}
