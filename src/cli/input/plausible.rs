//! Warnings of parts that are improbably large, small, light or dense: mostly a unit that was forgotten.

use std::f64::consts::PI;

use bifdiag_body::part::file::MeshSize;
use bifdiag_body::part::{MassProperties, Units};
use dashu_ratio::RBig;

use crate::cli::terminal::{bound_below, significant};

/// Digits in a warning, and of a density to be given again.
const DIGITS: usize = 3;
const DENSITY_DIGITS: usize = 12;

/// kg/m³ between a foam and osmium.
const DENSITIES: [f64; 2] = [1.0, 25_000.0];
/// Meshes in m across that raise no question.
const SIZES: [f64; 2] = [1e-3, 20.0];
/// Units that files and programs are mostly in.
const LENGTHS: [&str; 4] = ["mm", "cm", "in", "m"];

/// Whence the weight of a mesh is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// From its mass.
    Mass,
    /// From a density in the units of the part.
    InUnits,
    /// From a density with a unit of its own.
    OwnDensity,
}

fn within(x: f64, [low, high]: [f64; 2]) -> bool {
    low <= x && x <= high
}

fn rounded(x: &RBig) -> f64 {
    x.to_f64().value()
}

/// Warns of a mesh whose size or density no part has, with the unit that would make sense.
pub fn warn_of_mesh(mesh: MeshSize, properties: &MassProperties, units: &Units, weight: Weight) {
    if let Some(warning) = mesh_warning(mesh, rounded(&properties.mass), units, weight) {
        tracing::warn!("{warning}");
    }
}

fn mesh_warning(mesh: MeshSize, mass: f64, units: &Units, weight: Weight) -> Option<String> {
    let (length, mass) = (rounded(units.length()), mass * rounded(units.mass()));
    let measures = |length: f64| (mesh.extent * length, mass / (mesh.volume * length * length * length));
    let (size, density) = measures(length);
    if within(size, SIZES) && within(density, DENSITIES) {
        return None;
    }
    let what = if within(size, SIZES) {
        format!("the mean density of the part is {} kg/m³", significant(density, DIGITS))
    } else {
        format!("the part is {} m across", significant(size, DIGITS))
    };
    let [mass_unit, own, time] = units.names();
    let others = LENGTHS.into_iter().filter(|name| *name != own).filter_map(|name| {
        let other: Units = format!("{mass_unit},{name},{time}").parse().ok()?;
        Some((name, rounded(other.length())))
    });
    let plausible = |(_, length): &(&str, f64)| {
        let (size, other) = measures(*length);
        within(size, SIZES) && within(if weight == Weight::OwnDensity { density } else { other }, DENSITIES)
    };
    // A density that makes sense was meant in the units of the moment.
    let restated = within(density, DENSITIES) && weight == Weight::InUnits;
    let by_size = |(_, length): &(&str, f64)| within(measures(*length).0, SIZES);
    let found = others.clone().find(plausible).or_else(|| others.clone().find(|other| restated && by_size(other)));
    Some(match found {
        Some((name, _)) => {
            let density = if restated && !others.clone().any(|other| plausible(&other)) {
                format!(" and the density as {}kg/m3", significant(density, DENSITY_DIGITS))
            } else {
                String::new()
            };
            format!("{what}: is the file in {name}? then give --units {mass_unit},{name},{time}{density}")
        }
        None => format!("{what}: check --units and the density or mass"),
    })
}

/// Systems of units in which programs print mass properties.
const SYSTEMS: [&str; 6] = ["kg,mm", "g,mm", "kg,m", "g,cm", "kg,cm", "lb,in"];

/// Warns of mass properties about the centre of mass that no part has; where the tensor or the mass has a unit of its `own`,
/// other ones of all numbers would not help.
pub fn warn_of_tensor(properties: &MassProperties, units: &Units, own: bool) {
    let trace = rounded(&properties.about_com.trace());
    if let Some(warning) = tensor_warning(rounded(&properties.mass), trace, units, own) {
        tracing::warn!("{warning}");
    }
}

/// With the trace of the tensor twice ∫ |x|² dm: of all parts of this mass whose density is nowhere larger than some value, a
/// ball of that density has the least ∫ |x|² dm, so that the density of a ball is reached somewhere.
fn tensor_warning(mass: f64, trace: f64, units: &Units, own: bool) -> Option<String> {
    let measures = |units: &Units| {
        let mass = mass * rounded(units.mass());
        let square = 0.5 * trace * rounded(units.mass()) * rounded(units.length()) * rounded(units.length());
        let radius = (5.0 / 3.0 * square / mass).sqrt();
        (2.0 * radius, mass / (4.0 / 3.0 * PI * radius * radius * radius))
    };
    let (size, density) = measures(units);
    let is_light = density < 1e-3 || (size > 10.0 && density < 0.1);
    if !(size.is_finite() && size > 0.0) || !(is_light || density > DENSITIES[1]) {
        return None;
    }
    let what = if is_light {
        let weight = significant(mass * rounded(units.mass()), DIGITS);
        format!("the part is about {} m across and weighs {weight} kg", significant(size, DIGITS))
    } else {
        format!("the density of the part reaches at least {} kg/m³", bound_below(density, DIGITS))
    };
    if own {
        return Some(format!("{what}: check the units of tensor and mass"));
    }
    let [mass_unit, length, time] = units.names();
    let given = format!("{mass_unit},{length}");
    let plausible = SYSTEMS.into_iter().filter(|system| **system != given).find(|system| {
        let Ok(other) = format!("{system},{time}").parse::<Units>() else { return false };
        let (size, density) = measures(&other);
        within(size, [2e-3, 5.0]) && within(density, [5.0, 15_000.0])
    });
    Some(match plausible {
        Some(system) => format!("{what}: are the numbers in {system}? then give --units {system},{time}"),
        None => format!("{what}: check --units, and the units of tensor and mass"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn units(text: &str) -> Units {
        text.parse().unwrap()
    }

    #[test]
    fn a_mesh_in_millimetres_read_as_metres_is_noticed() {
        let bracket = MeshSize { extent: 60.0, volume: 24_000.0 };
        let warning = |mass: f64, text: &str, weight| mesh_warning(bracket, mass, &units(text), weight);
        // 24 cm³ of aluminium.
        let by_mass = warning(0.065, "kg,m,s", Weight::Mass).unwrap();
        assert_eq!(by_mass, "the part is 60 m across: is the file in mm? then give --units kg,mm,s");
        let own = warning(24_000.0 * 2700.0, "kg,m,s", Weight::OwnDensity).unwrap();
        assert_eq!(own, by_mass);
        let restated = warning(24_000.0 * 2700.0, "kg,m,s", Weight::InUnits).unwrap();
        assert_eq!(restated, format!("{by_mass} and the density as 2700kg/m3"));
        let heavy = warning(24_000.0 * 2700.0, "kg,m,s", Weight::Mass).unwrap();
        assert_eq!(heavy, "the part is 60 m across: check --units and the density or mass");
        assert_eq!(warning(0.065, "kg,mm,s", Weight::Mass), None);
        assert_eq!(warning(65.0, "g,mm,s", Weight::Mass), None);
        let light = warning(6.5e-9, "kg,mm,s", Weight::Mass).unwrap();
        assert!(light.contains("mean density of the part is 0.000271 kg/m³: check"), "{light}");
    }

    #[test]
    fn moments_in_other_units_are_noticed() {
        // The brass gyroscope in g mm²: a ball of mass 180 with this trace, 115500, has the diameter 2√(5·57750/(3·180)) = 46.25.
        let warning = |text: &str| tensor_warning(180.0, 29_625.0 * 2.0 + 56_250.0, &units(text), false);
        assert_eq!(warning("g,mm,s"), None);
        let metres = warning("kg,m,s").unwrap();
        assert!(metres.contains("46.2 m across and weighs 180 kg: are the numbers in g,mm?"), "{metres}");
        let dense = warning("kg,mm,s").unwrap();
        assert!(dense.contains("density of the part reaches at least") && dense.contains("--units g,mm,s"), "{dense}");
        // A satellite, and a rod of the examples.
        assert_eq!(tensor_warning(50.0, 9.9, &units("kg,m,s"), false), None);
        assert_eq!(tensor_warning(2.5, 0.56, &units("kg,m,s"), false), None);
    }
}
