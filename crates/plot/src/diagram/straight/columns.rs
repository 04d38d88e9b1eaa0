//! What lies over single momenta: exact energies, so that a point between two curves stays between them however close they are.

use super::super::scene::Scene;
use super::plane::Straight;
use super::strata::energies;
use bifdiag_page::PlotError;

/// What lies over one momentum.
#[derive(Clone, Debug, PartialEq)]
pub struct StraightColumn {
    /// From the left, in pixels.
    pub x: f64,
    /// The momentum.
    pub l: f64,
    /// From the lowest curve upwards: its energy, its y in pixels from above, and the number of the region above it.
    pub curves: Vec<([f64; 2], usize)>,
    /// The energies of equal steps from the highest curve towards the upper edge, which lies at infinity.
    pub above: Vec<f64>,
}

impl Straight {
    /// A column for each pixel, at the roundest momentum in it, and for each of `more` that is in view; above the
    /// highest curve this many steps.
    pub(crate) fn columns_at(
        &self,
        scene: &Scene<'_>,
        more: &[f64],
        steps: u32,
    ) -> Result<Vec<StraightColumn>, PlotError> {
        let l_end = self.l_end().unwrap_or(0.0);
        let edges: Vec<f64> = self.edges();
        let mut momenta: Vec<f64> = edges.windows(2).map(|pair| roundest(pair[0], pair[1])).collect();
        momenta.extend(more.iter().filter(|l| (0.0..=l_end).contains(*l)));
        momenta.sort_by(f64::total_cmp);
        momenta.dedup();
        let mut columns = Vec::with_capacity(momenta.len());
        let mut rest = &momenta[..];
        for (number, slab) in self.slabs.iter().enumerate() {
            let (own, others) = rest.split_at(rest.partition_point(|l| *l <= slab.l[1]));
            rest = others;
            let curves: Vec<Vec<f64>> =
                slab.layers.iter().map(|layer| energies(scene, layer.lower, own)).collect::<Result<_, _>>()?;
            for (column, &l) in own.iter().enumerate() {
                let place = self.within(number, l);
                let mut h: Vec<f64> = Vec::with_capacity(curves.len());
                for energies in &curves {
                    // Curves do not cross inside of a slab.
                    h.push(energies[column].max(h.last().copied().unwrap_or(f64::NEG_INFINITY)));
                }
                let above = (0..steps).map(|step| self.energy_above(f64::from(step) / f64::from(steps), &h)).collect();
                let layers = slab.layers.iter().zip(h.iter().zip(self.heights(place)));
                let curves = layers.map(|(layer, (h, y))| ([*h, y], layer.region)).collect();
                columns.push(StraightColumn { x: self.x(place).min(self.rect.right()), l, curves, above });
            }
        }
        Ok(columns)
    }

    /// The momenta at the edges of the pixels.
    fn edges(&self) -> Vec<f64> {
        let stations =
            || self.slabs.iter().zip(&self.placed).flat_map(|(slab, placed)| slab.stations.iter().zip(placed));
        let ends = stations().zip(stations().skip(1));
        let mut edges = Vec::new();
        let mut x = self.rect.x;
        for ((from, (left, _)), (to, (right, _))) in ends {
            while x < *right {
                edges.push(from.l + (to.l - from.l) * ((x - left) / (right - left)));
                x += 1.0;
            }
        }
        edges.extend(self.l_end());
        edges
    }
}

/// A decimal of few places in an interval of positive numbers.
fn roundest(from: f64, to: f64) -> f64 {
    let middle = 0.5 * (from + to);
    let mut power = 1.0;
    while power < 1e15 {
        let value = (middle * power).round() / power;
        if value > 0.0 && (from..to).contains(&value) {
            return value;
        }
        power *= 10.0;
    }
    middle
}

#[cfg(test)]
mod tests {
    use super::roundest;

    #[test]
    fn the_roundest_number_is_inside() {
        assert_eq!(roundest(0.0, 0.013), 0.01);
        assert_eq!(roundest(0.013, 0.026), 0.02);
        assert_eq!(roundest(3.249_999, 3.250_001), 3.25);
        assert_eq!(roundest(12.3, 57.9), 35.0);
        let narrow = 1.0 + f64::EPSILON;
        assert!((1.0..narrow).contains(&roundest(1.0, narrow)));
    }
}
