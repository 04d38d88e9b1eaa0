//! Components of U_hl by flood fill on a lat–long grid about r̂: crude, and independent of everything in the crate.
// The last bit of a cosine moves no cell that matters.
#![allow(clippy::disallowed_methods)]

use bifdiag_body::Body;
use bifdiag_diagram::topology::{Component, Poles, sort_components};

/// U_hl by flood fill on a grid with the given number of rows.
#[must_use]
pub fn components(body: &Body, h: f64, l: f64, rows: usize) -> Vec<Component> {
    let (a, r) = (body.moments_f64(), body.center_f64());
    fill(r, rows, |g| {
        let j = a[0] * g[0] * g[0] + a[1] * g[1] * g[1] + a[2] * g[2] * g[2];
        l * l / (2.0 * j) - (g[0] * r[0] + g[1] * r[1] + g[2] * r[2]) <= h
    })
}

/// Components of the set of accessible γ on a grid of `rows` × 2 `rows` points whose polar axis is r̂ (the third axis
/// when r = 0): rows are circles of latitude and the two poles are single points; boundary circles are counted as the
/// components of the complement that touch a component.
pub fn fill(r: [f64; 3], rows: usize, accessible: impl Fn([f64; 3]) -> bool) -> Vec<Component> {
    let norm = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt();
    let axis = if norm == 0.0 { [0.0, 0.0, 1.0] } else { r.map(|x| x / norm) };
    let (e1, e2) = complement(axis);
    let columns = 2 * rows;
    let circle: Vec<(f64, f64)> = (0..columns)
        .map(|n| {
            let psi = (n as f64 + 0.137) * std::f64::consts::PI / rows as f64;
            (psi.cos(), psi.sin())
        })
        .collect();
    // Cell 0 is r̂, the last is −r̂.
    let mut inside = vec![accessible(axis)];
    for row in 1..rows {
        let theta = row as f64 * std::f64::consts::PI / rows as f64;
        let (c, s) = (theta.cos(), theta.sin());
        for &(x, y) in &circle {
            inside.push(accessible(std::array::from_fn(|k| c * axis[k] + s * (x * e1[k] + y * e2[k]))));
        }
    }
    inside.push(accessible(axis.map(|x| -x)));
    let last = inside.len() - 1;

    let neighbours = |cell: usize, visit: &mut dyn FnMut(usize)| {
        if cell == 0 {
            (1..=columns).for_each(visit);
        } else if cell == last {
            (last - columns..last).for_each(visit);
        } else {
            let (row, column) = ((cell - 1) / columns, (cell - 1) % columns);
            visit(1 + row * columns + (column + 1) % columns);
            visit(1 + row * columns + (column + columns - 1) % columns);
            visit(if row == 0 { 0 } else { cell - columns });
            visit(if cell + columns < last { cell + columns } else { last });
        }
    };
    let mut label = vec![usize::MAX; inside.len()];
    let mut signs = Vec::new();
    let mut stack = Vec::new();
    for seed in 0..inside.len() {
        if label[seed] != usize::MAX {
            continue;
        }
        let name = signs.len();
        signs.push(inside[seed]);
        label[seed] = name;
        stack.push(seed);
        while let Some(cell) = stack.pop() {
            neighbours(cell, &mut |next| {
                if label[next] == usize::MAX && inside[next] == inside[cell] {
                    label[next] = name;
                    stack.push(next);
                }
            });
        }
    }
    let mut borders = Vec::new();
    for cell in 0..inside.len() {
        neighbours(cell, &mut |next| {
            if inside[cell] && !inside[next] {
                borders.push((label[cell], label[next]));
            }
        });
    }
    borders.sort_unstable();
    borders.dedup();
    let mut found: Vec<Component> = (0..signs.len())
        .filter(|&name| signs[name])
        .map(|name| Component {
            boundary_circles: u32::try_from(borders.iter().filter(|border| border.0 == name).count()).unwrap(),
            poles: (norm > 0.0).then_some(Poles { plus: label[0] == name, minus: label[last] == name }),
        })
        .collect();
    sort_components(&mut found);
    found
}

fn complement(axis: [f64; 3]) -> ([f64; 3], [f64; 3]) {
    let k = (0..3).min_by(|&i, &j| axis[i].abs().total_cmp(&axis[j].abs())).unwrap();
    let mut e = [0.0; 3];
    e[k] = 1.0;
    let v: [f64; 3] = std::array::from_fn(|i| e[i] - axis[k] * axis[i]);
    let n = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    let e1 = v.map(|x| x / n);
    let cross = |i: usize, j: usize| axis[i] * e1[j] - axis[j] * e1[i];
    (e1, [cross(1, 2), cross(2, 0), cross(0, 1)])
}
