//! The chaotic share over the diagram for JavaScript: tiles of cells as rows of numbers, as `bifdiag chaos` measures them.

use bifdiag_body::Body;
use bifdiag_chaos::{CellShare, Cells, ShareOptions, map_tiles};
use bifdiag_dynamics::section::Monitor;
use bifdiag_dynamics::section::chaos::DecisionOptions;
use bifdiag_exact::{Accuracy, Solver};
use bifdiag_numbers::table::Id;
use wasm_bindgen::prelude::*;

/// A body and what was proved of it, for maps of any window.
#[wasm_bindgen]
pub struct Shares {
    solver: Solver,
}

#[wasm_bindgen]
impl Shares {
    /// Of the body with these moments and this centre of mass.
    ///
    /// # Errors
    /// A body that is none.
    #[wasm_bindgen(constructor)]
    #[expect(clippy::needless_pass_by_value, reason = "so lists of strings come from JavaScript")]
    pub fn new(moments: Vec<String>, center: Vec<String>) -> Result<Self, JsError> {
        Ok(Self { solver: Solver::new(Body::parse(&moments, &center)?, Accuracy::Exact) })
    }

    /// The cells of one tile of a map. `window`: from and to in h and in l; `along`: how many cells along h and along l, which are
    /// measured in tiles of 8 × 8, in rows along l. For each component of each region in a cell: the cell along h and along l,
    /// the number of the region, the component, which part of the block belongs to the region, cells along a side of the block,
    /// chaotic orbits, orbits without a verdict, all orbits, and one standard deviation of the chaotic share.
    ///
    /// # Errors
    /// A body without a diagram, a window that no orbit can be followed in.
    pub fn tile(
        &self,
        window: &[f64],
        along: &[u32],
        number: u32,
        error: f64,
        steps: u32,
    ) -> Result<Vec<f64>, JsError> {
        let (&[h0, h1, l0, l1], &[n, m]) = (window, along) else {
            return Err(JsError::new(
                "a window is h from, h to, l from, l to, and cells are counted along h and along l",
            ));
        };
        let cells = Cells { h: [h0, h1], l: [l0, l1], counts: [n.into(), m.into()] };
        let orbits = DecisionOptions { steps: steps as usize, ..DecisionOptions::default() };
        let options = ShareOptions { error, orbits, ..ShareOptions::default() };
        let tile = u64::from(number);
        let rows = map_tiles(&self.solver, &cells, tile..tile + 1, &options, &Monitor::default())?;
        Ok(rows.iter().flat_map(row).collect())
    }
}

fn row(CellShare { cell, region, component, part, block, share, error, .. }: &CellShare) -> [f64; 10] {
    let [i, j] = cell.map(|k| k as f64);
    let (chaotic, open, orbits) = (share.chaotic as f64, share.open as f64, share.orbits as f64);
    [i, j, region.index() as f64, *component as f64, *part, *block as f64, chaotic, open, orbits, *error]
}
