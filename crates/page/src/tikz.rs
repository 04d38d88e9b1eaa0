//! TikZ of a picture from its SVG, with text as text: what documents `\input`, or a LaTeX document of its own.

use std::collections::BTreeMap;
use std::fmt::Write;

use resvg::tiny_skia::{PathSegment, Point, Transform};
use resvg::usvg::{Color, Group, Node, Paint, Path, Stroke, Text, TextAnchor, Tree};

use super::error::PlotError;
use super::formula::{Part, parts};
use super::geometry::POINTS;
use super::text::text_width;

/// What the preamble of a document needs.
const PREAMBLE: &str = "\\usepackage{tikz}\n\\usetikzlibrary{patterns.meta}\n";

/// A text no wider than its place in the picture, whatever fonts the document has: labels were placed by the widths of ours.
const FIT: &str = r"\def\bifdiagfit#1#2{\setbox8\hbox{#2}\ifdim\wd8>#1\relax\resizebox{#1}{!}{\box8}\else\box8\fi}%";

/// A document of its own.
pub fn document(tree: &Tree, title: &str) -> Result<String, PlotError> {
    let picture = picture(tree, title)?;
    let class = "\\documentclass[border=0pt]{standalone}\n";
    Ok(format!("{class}{PREAMBLE}\\begin{{document}}\n{picture}\\end{{document}}\n"))
}

/// The picture, as large as in print; lengths are in points of a PDF, y runs downwards as in the SVG. Its colours are its own.
pub fn picture(tree: &Tree, title: &str) -> Result<String, PlotError> {
    let mut writer = Writer::default();
    writer.group(tree.root(), 1)?;
    let mut out = String::new();
    let _ok = writeln!(out, "% {}", title.replace('\n', " "));
    let _ok = writeln!(out, "% The preamble needs {}", PREAMBLE.trim().replace('\n', " "));
    let _ok = writeln!(out, "\\begingroup%\n{FIT}");
    for (color, name) in &writer.colors {
        // The ends of lines would be spaces beside the picture.
        let _ok = writeln!(out, "\\definecolor{{{name}}}{{HTML}}{{{color}}}%");
    }
    let _ok = writeln!(out, "\\begin{{tikzpicture}}[x={POINTS}bp, y=-{POINTS}bp, font=\\sffamily, line join=round]");
    let (width, height) = (tree.size().width(), tree.size().height());
    let _ok = writeln!(out, "  \\useasboundingbox (0,0) rectangle ({},{});", length(width), length(height));
    out.push_str(&writer.body);
    out.push_str("\\end{tikzpicture}%\n\\endgroup%\n");
    Ok(out)
}

#[derive(Default)]
struct Writer {
    body: String,
    /// Names of colours by their six digits.
    colors: BTreeMap<String, String>,
}

/// A number without superfluous digits.
fn length(value: f32) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn place(point: Point, transform: Transform) -> String {
    let mut point = point;
    transform.map_point(&mut point);
    format!("({},{})", length(point.x), length(point.y))
}

/// How much longer a length is on the page.
fn scale(transform: Transform) -> f32 {
    transform.get_scale().0
}

impl Writer {
    fn line(&mut self, depth: usize, text: &str) {
        let _ok = writeln!(self.body, "{}{text}", "  ".repeat(depth));
    }

    fn color(&mut self, color: Color) -> String {
        let digits = format!("{:02X}{:02X}{:02X}", color.red, color.green, color.blue);
        let next = format!("bif{}", self.colors.len());
        self.colors.entry(digits).or_insert(next).clone()
    }

    fn group(&mut self, group: &Group, depth: usize) -> Result<(), PlotError> {
        for node in group.children() {
            match node {
                Node::Group(inner) if inner.id().is_empty() => self.group(inner, depth)?,
                Node::Group(inner) => {
                    self.line(depth, &format!("\\begin{{scope}} % {}", inner.id()));
                    self.group(inner, depth + 1)?;
                    self.line(depth, "\\end{scope}");
                }
                Node::Path(path) => self.path(path, depth),
                Node::Text(text) => self.text(text, depth),
                Node::Image(_) => return Err(PlotError::TikzImage),
            }
        }
        Ok(())
    }

    fn path(&mut self, path: &Path, depth: usize) {
        let transform = path.abs_transform();
        let mut line = String::new();
        for segment in path.data().segments() {
            let at = |point| place(point, transform);
            let _ok = match segment {
                PathSegment::MoveTo(p) => write!(line, "{}{}", if line.is_empty() { "" } else { " " }, at(p)),
                PathSegment::LineTo(p) => write!(line, "--{}", at(p)),
                PathSegment::CubicTo(a, b, p) => write!(line, "..controls {} and {}..{}", at(a), at(b), at(p)),
                // As one of the third degree would be: two thirds of the way to the control point. None is drawn.
                PathSegment::QuadTo(c, p) => write!(line, "..controls {}..{}", at(c), at(p)),
                PathSegment::Close => write!(line, "--cycle"),
            };
        }
        let mut options: Vec<String> = Vec::new();
        if let Some(fill) = path.fill() {
            match fill.paint() {
                Paint::Color(color) => options.push(format!("fill={}", self.color(*color))),
                Paint::Pattern(pattern) => self.stripes(pattern.root(), scale(transform), &line, depth),
                Paint::LinearGradient(_) | Paint::RadialGradient(_) => {}
            }
        }
        if let Some(stroke) = path.stroke() {
            options.extend(self.stroke(stroke, scale(transform)));
        }
        if !options.is_empty() {
            options.push("even odd rule".to_owned());
            self.line(depth, &format!("\\path[{}] {line};", options.join(", ")));
        }
    }

    fn stroke(&mut self, stroke: &Stroke, scale: f32) -> Vec<String> {
        let Paint::Color(color) = stroke.paint() else { return Vec::new() };
        let points = |value: f32| format!("{}bp", length(value * scale * POINTS));
        let mut options = vec![format!("draw={}", self.color(*color))];
        options.push(format!("line width={}", points(stroke.width().get())));
        if stroke.linecap() == resvg::usvg::LineCap::Round {
            options.push("line cap=round".to_owned());
        }
        if let Some(dashes) = stroke.dasharray() {
            let pattern: Vec<String> = dashes
                .iter()
                .enumerate()
                .map(|(place, dash)| format!("{} {}", if place % 2 == 0 { "on" } else { "off" }, points(*dash)))
                .collect();
            options.push(format!("dash pattern={}", pattern.join(" ")));
            let phase = stroke.dashoffset().rem_euclid(dashes.iter().sum::<f32>());
            if phase > 0.0 {
                options.push(format!("dash phase={}", points(phase)));
            }
        }
        options
    }

    /// A striped ground: the first colour, and over it lines in each of the others.
    fn stripes(&mut self, pattern: &Group, scale: f32, line: &str, depth: usize) {
        let mut stripes: Vec<(Color, [f32; 2])> = Vec::new();
        collect_stripes(pattern, &mut stripes);
        let Some(((ground, [_, period]), stripes)) = stripes.split_first() else { return };
        let ground = self.color(*ground);
        self.line(depth, &format!("\\path[fill={ground}, even odd rule] {line};"));
        let width = period / (stripes.len().max(1)) as f32;
        for (place, (color, _)) in stripes.iter().enumerate().skip(1) {
            let color = self.color(*color);
            let points = |value: f32| format!("{}bp", length(value * scale * POINTS));
            let lines = format!(
                "Lines[angle=-45, distance={}, line width={}, xshift={}]",
                points(*period),
                points(width),
                points(width * place as f32 * std::f32::consts::SQRT_2)
            );
            let line = format!("\\path[pattern={{{lines}}}, pattern color={color}, even odd rule] {line};");
            self.line(depth, &line);
        }
    }

    fn text(&mut self, text: &Text, depth: usize) {
        let transform = text.abs_transform();
        for chunk in text.chunks() {
            let Some(span) = chunk.spans().first() else { continue };
            let (Some(x), Some(y)) = (chunk.x(), chunk.y()) else { continue };
            let anchor = match chunk.anchor() {
                TextAnchor::Start => "base west",
                TextAnchor::Middle => "base",
                TextAnchor::End => "base east",
            };
            let color = match span.fill().map(resvg::usvg::Fill::paint) {
                Some(Paint::Color(color)) => self.color(*color),
                _ => continue,
            };
            let size = span.font_size().get() * scale(transform) * POINTS;
            #[expect(clippy::cast_possible_truncation, reason = "the width of a text in points")]
            let width = length(text_width(chunk.text().trim(), f64::from(size)) as f32);
            let at = place(Point::from_xy(x, y), transform);
            let size = format!("\\fontsize{{{}bp}}{{{}bp}}\\selectfont", length(size), length(1.2 * size));
            let content = format!("\\bifdiagfit{{{width}bp}}{{{size} {}}}", tex(chunk.text().trim()));
            self.line(
                depth,
                &format!("\\node[anchor={anchor}, inner sep=0pt, outer sep=0pt, text={color}] at {at} {{{content}}};"),
            );
        }
    }
}

/// The rectangles of a striped pattern: their colours, left sides and widths.
fn collect_stripes(group: &Group, stripes: &mut Vec<(Color, [f32; 2])>) {
    for node in group.children() {
        match node {
            Node::Group(inner) => collect_stripes(inner, stripes),
            Node::Path(path) => {
                if let Some(Paint::Color(color)) = path.fill().map(resvg::usvg::Fill::paint) {
                    let area = path.abs_bounding_box();
                    stripes.push((*color, [area.left(), area.width()]));
                }
            }
            Node::Text(_) | Node::Image(_) => {}
        }
    }
}

/// A text for LaTeX: mathematics in dollars, and nothing that has a meaning of its own there.
pub fn tex(text: &str) -> String {
    // Neighbouring formulas are one.
    parts(text).iter().map(part).collect::<String>().replace("$$", "")
}

/// A part of a text for LaTeX.
fn part(Part { text, is_formula }: &Part) -> String {
    const EXPONENTS: [&str; 2] = ["⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+"];
    const INDICES: [&str; 2] = ["₀₁₂₃₄₅₆₇₈₉ⱼₖ", "0123456789jk"];
    let mut out = String::new();
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        let digit = |[set, digits]: [&str; 2], c: char| digits.chars().nth(set.chars().position(|other| other == c)?);
        let mut script = |sign: &str, alphabet: [&str; 2], first: char| {
            out.extend(["$", sign, "{"]);
            out.push(first);
            while let Some(next) = characters.peek().and_then(|c| digit(alphabet, *c)) {
                out.push(next);
                characters.next();
            }
            out.push_str("}$");
        };
        if let Some(first) = digit(EXPONENTS, character) {
            script("^", EXPONENTS, first);
        } else if let Some(first) = digit(INDICES, character) {
            script("_", INDICES, first);
        } else if characters.peek() == Some(&'\u{302}') {
            characters.next();
            out.push_str("$\\hat{");
            out.push(character);
            out.push_str("}$");
        } else if let Some((_, command)) = SYMBOLS.iter().find(|(symbol, _)| *symbol == character) {
            out.extend(["$", command, "$"]);
        } else if *is_formula && character.is_alphabetic() {
            out.push('$');
            out.push(character);
            out.push('$');
        } else {
            match character {
                '\\' => out.push_str("\\textbackslash{}"),
                '~' => out.push_str("\\textasciitilde{}"),
                '^' => out.push_str("\\textasciicircum{}"),
                '#' | '$' | '%' | '&' | '_' | '{' | '}' => out.extend(['\\', character]),
                other => out.push(other),
            }
        }
    }
    out
}

/// What pictures hold beyond letters, and the commands for it.
const SYMBOLS: [(char, &str); 34] = [
    ('−', "-"),
    ('…', "\\ldots "),
    ('×', "\\times "),
    ('·', "\\cdot "),
    ('≈', "\\approx "),
    ('≤', "\\le "),
    ('≥', "\\ge "),
    ('<', "<"),
    ('>', ">"),
    ('|', "|"),
    ('∖', "\\setminus "),
    ('∂', "\\partial "),
    ('√', "\\surd "),
    ('′', "'"),
    ('⟨', "\\langle "),
    ('⟩', "\\rangle "),
    ('∞', "\\infty "),
    ('→', "\\to "),
    ('±', "\\pm "),
    ('¾', "\\frac34"),
    ('½', "\\frac12"),
    ('α', "\\alpha "),
    ('γ', "\\gamma "),
    ('Δ', "\\Delta "),
    ('η', "\\eta "),
    ('θ', "\\theta "),
    ('ϑ', "\\vartheta "),
    ('λ', "\\lambda "),
    ('μ', "\\mu "),
    ('π', "\\pi "),
    ('ψ', "\\psi "),
    ('φ', "\\varphi "),
    ('ω', "\\omega "),
    ('Ṡ', "\\dot S"),
];

#[cfg(test)]
mod tests {
    use resvg::usvg::{Options, Tree};

    use super::{picture, tex};
    use crate::text::{database, text_width};

    #[test]
    fn a_text_is_no_wider_than_the_place_it_was_given() -> Result<(), Box<dyn std::error::Error>> {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="50" height="20"><text x="1" y="9" font-family="DejaVu Sans" font-size="10">R4</text></svg>"#;
        let tree = Tree::from_str(svg, &Options { fontdb: database(), ..Options::default() })?;
        let tikz = picture(&tree, "a label")?;
        let (_, rest) = tikz.split_once("{\\bifdiagfit{").ok_or("no fitted text")?;
        let (width, _) = rest.split_once("bp}").ok_or("no width")?;
        assert!((width.parse::<f64>()? - text_width("R4", 10.0) * f64::from(super::POINTS)).abs() < 0.01, "{width}");
        assert!(tikz.contains("\\def\\bifdiagfit"), "the document has no such command of its own");
        Ok(())
    }

    #[test]
    fn texts_become_formulas() {
        assert_eq!(tex("M²₃"), "$M^{2}_{3}$");
        assert_eq!(tex("S²∖2D²"), "$S^{2}\\setminus $2$D^{2}$");
        assert_eq!(tex("pole +r̂ enters U, Aω"), "pole +$\\hat{r}$ enters $U$, $A\\omega $");
        assert_eq!(tex("100 % of a_b"), "100 \\% of a\\_b");
        assert_eq!(tex("10⁻¹²"), "10$^{-12}$");
    }
}
