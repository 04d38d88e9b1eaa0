//! Real parts for JavaScript: files and tensors to the block `part` of the documents. The readers of files are a fifth of
//! the explorer, so they are a module of their own, loaded when a part is given.

mod part;

use bifdiag::body::part::Products;
use bifdiag::schema::PartDocument;
use wasm_bindgen::prelude::*;

/// The part of a mesh or an inertial block, a file by its name and its bytes, as the block `part` of the documents. Empty
/// texts say nothing.
///
/// # Errors
/// A file that gives no part, or a part that cannot exist.
#[wasm_bindgen]
pub fn part_of_file(
    name: &str,
    bytes: Vec<u8>,
    density: &str,
    mass: &str,
    units: &str,
    pivot: &str,
) -> Result<String, JsError> {
    let form = part::Form { density, mass, units, point: pivot };
    text(&part::of_file(name, bytes, &form)?)
}

/// The part of a tensor Ixx, Iyy, Izz, Ixy, Ixz, Iyz: `integral` products are +∫ x y dm, others entries of the tensor.
///
/// # Errors
/// Numbers that are none, or a part that cannot exist.
#[wasm_bindgen]
pub fn part_of_tensor(
    tensor: &str,
    integral: bool,
    about_com: bool,
    com: &str,
    mass: &str,
    units: &str,
) -> Result<String, JsError> {
    let products = if integral { Products::Integral } else { Products::Tensor };
    let form = part::Form { density: "", mass, units, point: com };
    text(&part::of_tensor(tensor, products, about_com, &form)?)
}

fn text(part: &PartDocument) -> Result<String, JsError> {
    Ok(serde_json::to_string(part)?)
}
