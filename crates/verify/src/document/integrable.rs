//! The integrable cases that a document names, by invariants of the tensor of inertia and r, and the formulas by the axes.

use bifdiag_schema::{IntegrableCaseName, IntegrableDocument};
use dashu_ratio::RBig;

use super::tensor::{Matrix, Vector, dot};
use crate::equilibria::spaces::Body;

/// The cases of a body with this tensor and weight r, in whatever axes; `body` has the axes of the formulas.
pub(super) fn cases(tensor: &Matrix, weight: &Vector, body: &Body) -> Vec<IntegrableDocument> {
    let found =
        |case, integral: String, holds: &str| vec![IntegrableDocument { case, integral, holds: holds.to_owned() }];
    let always = "always";
    let (a, r) = (&body.moments, &body.center);
    if weight.iter().all(RBig::is_zero) {
        return found(IntegrableCaseName::Euler, "⟨L,L⟩".to_owned(), always);
    }
    let third = (0..3).find(|k| a[(k + 1) % 3] == a[(k + 2) % 3]);
    let along = tensor.times(weight);
    // A r = λ r.
    let carries = |factor: &RBig| along.iter().zip(weight).all(|(image, r)| *image == factor * r);
    let [trace, second, determinant] = tensor.invariants();
    match third {
        Some(_) if a[0] == a[1] && a[1] == a[2] => {
            return found(IntegrableCaseName::Lagrange, "⟨L,r⟩".to_owned(), always);
        }
        Some(k) if (0..3).all(|i| i == k || r[i].is_zero()) => {
            return found(IntegrableCaseName::Lagrange, format!("ω{}", k + 1), always);
        }
        Some(k) => {
            let number = |n: i32| RBig::from(n);
            let [i, j] = [[1, 2], [0, 2], [0, 1]][k];
            let (i, j, k) = (i + 1, j + 1, k + 1);
            // The moments n c, n c, c.
            let has_ratio = |n: i32| {
                let c = &trace / number(2 * n + 1);
                let (squared, cubed) = (&c * &c, &c * &c * &c);
                second == number(n * n + 2 * n) * squared
                    && determinant == number(n * n) * cubed
                    && carries(&(number(n) * c))
            };
            if has_ratio(2) {
                let integral = format!(
                    "(ω{i}² − ω{j}² + (r{i}γ{i} − r{j}γ{j})/A{k})² + (2ω{i}ω{j} + (r{i}γ{j} + r{j}γ{i})/A{k})²"
                );
                return found(IntegrableCaseName::Kovalevskaya, integral, always);
            }
            if has_ratio(4) {
                let integral = format!("ω{k}(ω{i}² + ω{j}²) + (r{i}ω{i} + r{j}ω{j})γ{k}/A{k}");
                return found(IntegrableCaseName::GoryachevChaplygin, integral, "where l = 0");
            }
        }
        None => {}
    }
    // On the plane across r the form ⟨L,A⁻¹L⟩ has a double eigenvalue: with B = A⁻¹ det A, of trace `second`, its trace there
    // is tr B − ⟨r,Br⟩/|r|², and B r = A²r − (tr A) A r + e₂ r.
    let squared = dot(weight, weight);
    let moment = dot(weight, &along);
    let inverse = dot(&along, &along) - &trace * &moment + &second * &squared;
    let across = &second * &squared - inverse;
    if &across * &across == RBig::from(4) * determinant * moment * squared {
        return found(IntegrableCaseName::HessAppelrot, "⟨L,r⟩".to_owned(), "where it is 0");
    }
    Vec::new()
}
