//! The real part that the options describe.

use std::path::{Path, PathBuf};

use bifdiag_body::PrincipalForm;
use bifdiag_body::part::file::{self, FileError, FileOptions};
use bifdiag_body::part::{
    Dimension, Existence, MassError, MassProperties, Measured, MeasuredPart, Part, Products, Quantity, QuantityError,
    Units, tensor_of,
};
use bifdiag_numbers::symmetric::PrincipalAxes;
use bifdiag_numbers::{Number, decimal};
use clap::Args;
use dashu_ratio::RBig;

use super::plausible;
use super::values::{self, Named, nominal};
use crate::cli::failure::{Failure, incomplete};
use crate::cli::terminal::significant;

/// Standard gravity in m/s², exact.
const STANDARD_GRAVITY: &str = "9.80665";

/// What the products of inertia are.
const PRODUCTS: [Named<Products>; 2] = [
    ("tensor", "Entries of the tensor: Ixy = -∫ x y dm", Products::Tensor),
    ("integral", "The integrals: Ixy = +∫ x y dm", Products::Integral),
];

/// The heading above the options of a real part.
pub const PART: &str = "A real part";

/// A real part.
#[derive(Debug, Args)]
#[command(next_help_heading = PART)]
pub struct PartArguments {
    /// Inertia tensor about the fixed point (with --com and --mass)
    #[arg(long, value_name = "Ixx,Iyy,Izz,Ixy,Ixz,Iyz", allow_hyphen_values = true, value_parser = values::tensor, hide_short_help = true)]
    pub inertia: Option<[Quantity; 6]>,
    /// Inertia tensor about the centre of mass (with --com and --mass)
    #[arg(long, value_name = "Ixx,Iyy,Izz,Ixy,Ixz,Iyz", allow_hyphen_values = true, value_parser = values::tensor)]
    pub inertia_com: Option<[Quantity; 6]>,
    /// A mesh (.stl, .obj, .ply) or an inertial block (.urdf, MJCF .xml)
    #[arg(long = "part", value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// Link to read from a .urdf or .xml
    #[arg(long, value_name = "NAME", hide_short_help = true)]
    pub link: Option<String>,
    /// Density of a mesh, with its unit or in --units; or give --mass
    #[arg(long, value_name = "2.7g/cm3", allow_hyphen_values = true, value_parser = values::density, hide_short_help = true)]
    pub density: Option<Quantity>,
    /// Convention of the products of inertia; needed when one of them is not 0
    #[arg(long, value_name = "tensor|integral", value_parser = values::named(&PRODUCTS), hide_short_help = true)]
    pub products: Option<Products>,
    /// Centre of mass, from the fixed point; with --pivot, in the same axes as the pivot
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::place)]
    pub com: Option<[Quantity; 3]>,
    /// Mass
    #[arg(long, value_name = "m", allow_hyphen_values = true, value_parser = values::mass)]
    pub mass: Option<Quantity>,
    /// Units of mass, length and time, for the part and for results that name no unit of their own (default: kg,m,s)
    #[arg(long, value_name = "kg,mm,s", value_parser = values::units, hide_short_help = true)]
    pub units: Option<Units>,
    /// Acceleration of gravity, in m/s² whatever --units are, or with its unit (default: 9.80665)
    #[arg(long = "g", value_name = "g", allow_hyphen_values = true, value_parser = values::gravity, hide_short_help = true)]
    pub gravity: Option<Quantity>,
    /// The fixed point, in the axes of the part's description (default: their origin)
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::place, hide_short_help = true)]
    pub pivot: Option<[Quantity; 3]>,
    /// Accept a part that no mass distribution has
    #[arg(long, hide_short_help = true)]
    pub unphysical: bool,
}

/// A part, and its body.
pub struct GivenPart {
    /// The option that gave it.
    pub option: &'static str,
    pub part: Part,
    pub principal: PrincipalForm,
    /// Its numbers, where some are known to within so much only.
    pub measured: Option<MeasuredPart>,
    /// A density or mass of a file that is known to within so much only, on which no spin depends.
    scale: Option<&'static str>,
}

/// The numbers of the options in the units of the part.
struct Numbers {
    inertia: Option<[Measured; 6]>,
    inertia_com: Option<[Measured; 6]>,
    density: Option<Measured>,
    com: Option<[Measured; 3]>,
    mass: Option<Measured>,
    /// In m/s².
    gravity: Measured,
    pivot: Option<[Measured; 3]>,
    units: Units,
}

impl GivenPart {
    /// This part, unless it is known to within so much only.
    fn exact(self) -> Result<Self, Failure> {
        if self.measured.is_none() && self.scale.is_none() {
            return Ok(self);
        }
        Err(Failure::input(
            "±: only `bifdiag critical-spin` accepts numbers with an uncertainty; leave out ± and the number after it",
        ))
    }
}

impl PartArguments {
    /// The option that says which part it is, if one is given.
    pub fn source(&self) -> Option<&'static str> {
        self.given().find(|option| ["--inertia", "--inertia-com", "--part"].contains(option))
    }

    /// The options that are given, by name.
    pub fn given(&self) -> impl Iterator<Item = &'static str> + use<> {
        let options = [
            ("--inertia", self.inertia.is_some()),
            ("--inertia-com", self.inertia_com.is_some()),
            ("--part", self.file.is_some()),
            ("--link", self.link.is_some()),
            ("--density", self.density.is_some()),
            ("--products", self.products.is_some()),
            ("--com", self.com.is_some()),
            ("--mass", self.mass.is_some()),
            ("--units", self.units.is_some()),
            ("--g", self.gravity.is_some()),
            ("--pivot", self.pivot.is_some()),
            ("--unphysical", self.unphysical),
        ];
        options.into_iter().filter(|(_, given)| *given).map(|(name, _)| name)
    }

    /// The part of the options, or `None` if none of them was given. One that cannot exist is refused without
    /// `--unphysical`.
    pub fn part(&self) -> Result<Option<GivenPart>, Failure> {
        self.measured_part()?.map(GivenPart::exact).transpose()
    }

    /// The part of the options, also when its numbers are not exact.
    pub fn measured_part(&self) -> Result<Option<GivenPart>, Failure> {
        let Some(given) = self.read()? else { return Ok(None) };
        let GivenPart { option, part, .. } = &given;
        if let (Existence::Impossible(inequality), false) = (part.properties.existence(), self.unphysical) {
            let (inequality, unit) = (inequality.to_string(), part.units.moment());
            let hint = self.hint(&self.numbers()?, &part.properties);
            return Err(Failure::input(format!(
                "{option}: this part cannot exist: about its centre of mass {inequality} ({unit}). {hint}"
            )));
        }
        if let Some(option) = given.scale {
            tracing::warn!(
                "{option} ±: the tensor and the weight of a file scale alike with it, so no spin depends \
            on it"
            );
        }
        Ok(Some(given))
    }

    /// The part of the options, also when it cannot exist.
    pub fn shown(&self) -> Result<Option<GivenPart>, Failure> {
        self.read()?.map(GivenPart::exact).transpose()
    }

    fn read(&self) -> Result<Option<GivenPart>, Failure> {
        let Some(given) = self.given().next() else { return Ok(None) };
        let numbers = self.numbers()?;
        let (option, properties) = self.properties(given, &numbers)?;
        if self.gravity.is_none() {
            tracing::warn!("--g is not given: using standard gravity, {STANDARD_GRAVITY} m/s²");
        }
        let part = Part { properties, gravity: numbers.gravity.value.clone(), units: numbers.units.clone() };
        let principal =
            part.principal().map_err(|error| Failure::input(format!("{option}: {error}")).because(error))?;
        if self.file.is_none() && part.properties.existence().is_possible() {
            let entries = self.inertia.iter().chain(&self.inertia_com).flatten().chain(&self.mass);
            plausible::warn_of_tensor(&part.properties, &part.units, entries.into_iter().any(Quantity::has_unit));
        }
        let scales = [("--density", &numbers.density), ("--mass", &numbers.mass)];
        let scale = scales
            .into_iter()
            .find(|(_, number)| self.file.is_some() && number.as_ref().is_some_and(|number| !number.within.is_zero()));
        let measured = self.measured(&numbers, &part.properties);
        Ok(Some(GivenPart { option, part, principal, measured, scale: scale.map(|(option, _)| option) }))
    }

    /// The numbers of the options, each in the units of the part.
    fn numbers(&self) -> Result<Numbers, Failure> {
        let units = self.units.clone().unwrap_or_default();
        let standard = || {
            let value: Number = STANDARD_GRAVITY.parse().unwrap_or_else(|_| unreachable!("a number"));
            Measured { value: value.value().clone(), within: RBig::ZERO }
        };
        // g is in m/s² whatever the units are.
        let gravity = one("--g", self.gravity.as_ref(), Dimension::ACCELERATION, &Units::default())?;
        Ok(Numbers {
            inertia: all("--inertia", self.inertia.as_ref(), Dimension::MOMENT, &units)?,
            inertia_com: all("--inertia-com", self.inertia_com.as_ref(), Dimension::MOMENT, &units)?,
            density: one("--density", self.density.as_ref(), Dimension::DENSITY, &units)?,
            com: all("--com", self.com.as_ref(), Dimension::LENGTH, &units)?,
            mass: one("--mass", self.mass.as_ref(), Dimension::MASS, &units)?,
            gravity: gravity.unwrap_or_else(standard),
            pivot: all("--pivot", self.pivot.as_ref(), Dimension::LENGTH, &units)?,
            units,
        })
    }

    /// The fixed point in the axes of the file, rounded.
    pub fn fixed_point(&self) -> Result<[f64; 3], Failure> {
        let pivot = self.numbers()?.pivot;
        Ok(pivot.map_or([0.0; 3], |pivot| nominal(&pivot).map(|x| x.to_f64().value())))
    }

    /// The numbers as they were measured, from the fixed point; `None` where all are exact. For a file, its mass
    /// properties about the pivot.
    fn measured(&self, numbers: &Numbers, properties: &MassProperties) -> Option<MeasuredPart> {
        let exact = |value: RBig| Measured { value, within: RBig::ZERO };
        let gravity = || numbers.gravity.clone();
        let part = if self.file.is_some() {
            let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = properties.about_com.rows().clone();
            // They are those seen from the pivot.
            let mut com = properties.com.clone();
            for (coordinate, pivot) in com.iter_mut().zip(numbers.pivot.iter().flatten()) {
                *coordinate += &pivot.value;
            }
            let [x, y, z] = com;
            let list = [xx, yy, zz, xy, xz, yz, x, y, z, properties.mass.clone()].map(exact);
            MeasuredPart::new(true, list, gravity())
        } else {
            let list = numbers.inertia.as_ref().or(numbers.inertia_com.as_ref())?;
            let mut inputs = list.iter().chain(numbers.com.as_ref()?).chain([numbers.mass.as_ref()?]).cloned();
            let list = std::array::from_fn(|_| inputs.next().unwrap_or_else(|| unreachable!("six, three and one")));
            let mut part = MeasuredPart::new(self.inertia_com.is_some(), list, gravity());
            if self.products == Some(Products::Integral) {
                for product in &mut part.inputs[3..6] {
                    product.value = -product.value.clone();
                }
            }
            part
        };
        let part = numbers.pivot.iter().cloned().fold(part, MeasuredPart::seen_from);
        let is_exact = part.uncertain().next().is_none();
        (!is_exact).then_some(part)
    }

    /// The mass properties seen from the fixed point, and the option that gave them.
    fn properties(&self, given: &'static str, numbers: &Numbers) -> Result<(&'static str, MassProperties), Failure> {
        if let Some(path) = &self.file {
            return Ok(("--part", self.of_file(path, numbers)?));
        }
        let of_files = [("--link", self.link.is_some()), ("--density", self.density.is_some())];
        if let Some((option, _)) = of_files.into_iter().find(|(_, given)| *given) {
            return Err(Failure::input(format!("{option} has no effect without --part")));
        }
        let missing = |missing, example| incomplete(given, missing, example);
        let (option, list) = match (&numbers.inertia, &numbers.inertia_com) {
            (Some(_), Some(_)) => return Err(two_parts("--inertia", "--inertia-com")),
            (Some(list), None) => ("--inertia", list),
            (None, Some(list)) => ("--inertia-com", list),
            (None, None) => {
                return Err(missing("--inertia or --inertia-com", "--inertia-com 0.24,0.15,0.17,0,0,0"));
            }
        };
        let com = numbers.com.as_ref().ok_or_else(|| missing("--com", "--com 0,0.02,0.15"))?;
        let mass = numbers.mass.as_ref().ok_or_else(|| missing("--mass", "--mass 2.5"))?;
        let (mass, com) = (mass.value.clone(), nominal(com));
        if self.inertia.is_some() {
            if self.pivot.is_some() {
                return Err(Failure::input(
                    "--pivot with --inertia: that tensor is already about the fixed point; give --inertia-com, or no \
                    --pivot",
                ));
            }
            let read =
                |products| MassProperties::about_origin(mass.clone(), com.clone(), &tensor_of(nominal(list), products));
            return Ok((option, self.with_products(option, list, read)?));
        }
        let read = |products| MassProperties::about_com(mass.clone(), com.clone(), tensor_of(nominal(list), products));
        let properties = self.with_products(option, list, read)?;
        Ok((option, numbers.pivot.iter().fold(properties, |properties, pivot| properties.seen_from(&nominal(pivot)))))
    }

    /// The mass properties of a file, seen from the pivot, in the units of the part.
    fn of_file(&self, path: &Path, numbers: &Numbers) -> Result<MassProperties, Failure> {
        let others = [("--inertia", self.inertia.is_some()), ("--inertia-com", self.inertia_com.is_some())];
        if let Some((second, _)) = others.into_iter().find(|(_, given)| *given) {
            return Err(two_parts("--part", second));
        }
        let useless = [("--com", self.com.is_some()), ("--products", self.products.is_some())];
        if let Some((option, _)) = useless.into_iter().find(|(_, given)| *given) {
            return Err(Failure::input(format!("{option} has no effect with --part: the file gives it")));
        }
        let exact =
            |number: &Option<Measured>| number.as_ref().map(|number| Number::from_rational(number.value.clone()));
        let (density, mass) = (exact(&numbers.density), exact(&numbers.mass));
        let wanted = FileOptions { link: self.link.as_deref(), density: density.as_ref(), mass: mass.as_ref() };
        let read = file::read(path, &wanted).map_err(|source| {
            let hint = match source {
                FileError::NoDensity | FileError::DensityAndMass => "; give --density or --mass",
                _ => "",
            };
            Failure::input(format!("--part {}: {source}{hint}", path.display())).because(source)
        })?;
        if let Some(mesh) = read.mesh {
            let weight = match &self.density {
                Some(density) if density.has_unit() => plausible::Weight::OwnDensity,
                Some(_) => plausible::Weight::InUnits,
                None => plausible::Weight::Mass,
            };
            plausible::warn_of_mesh(mesh, &read.properties, &numbers.units, weight);
        }
        let pivot = numbers.pivot.as_ref().map_or([const { RBig::ZERO }; 3], nominal);
        Ok(read.seen_from(&pivot, self.units.clone()).0)
    }

    /// A tensor in the convention of its products, which must be given where it matters.
    fn with_products(
        &self,
        option: &'static str,
        list: &[Measured; 6],
        read: impl Fn(Products) -> Result<MassProperties, MassError>,
    ) -> Result<MassProperties, Failure> {
        let matters = list[3..].iter().any(|product| !product.value.is_zero());
        if let (true, None) = (matters, self.products) {
            let possible =
                |products| read(products).map(|reading| reading.existence().is_possible()).map_err(mass_error);
            let hint = match [possible(Products::Tensor)?, possible(Products::Integral)?] {
                [true, false] => "with --products integral the part could not exist",
                [false, true] => "with --products tensor the part could not exist",
                _ => "look up the convention of your program",
            };
            let about = if self.inertia_com.is_some() { " about the centre of mass" } else { "" };
            let [tensor, integral] = [Products::Tensor, Products::Integral].map(|products| moments(list, products));
            let product_count = list[3..].iter().filter(|product| !product.value.is_zero()).count();
            // Other signs of them all are a mirror image unless all three matter.
            if product_count < 3 {
                return Err(Failure::input(format!(
                    "--products is missing: a product of inertia in {option} is not 0, and programs differ in its sign. The \
                     principal moments{about} are {tensor} with either sign, but the principal axes differ; write \
                     --products tensor (Ixy = -∫ x y dm) or integral (Ixy = +∫ x y dm); {hint}"
                )));
            }
            return Err(Failure::input(format!(
                "--products is missing: a product of inertia in {option} is not 0, and programs differ in its sign. The \
                 principal moments{about} would be {tensor} with --products tensor (Ixy = -∫ x y dm), {integral} with --products \
                 integral (Ixy = +∫ x y dm); {hint}"
            )));
        }
        read(self.products.unwrap_or(Products::Tensor)).map_err(mass_error)
    }

    /// What may be wrong with a part that cannot exist.
    fn hint(&self, numbers: &Numbers, properties: &MassProperties) -> String {
        let other = |products| match (&numbers.inertia, &numbers.inertia_com) {
            (Some(list), _) => {
                let tensor = tensor_of(nominal(list), products);
                MassProperties::about_origin(properties.mass.clone(), properties.com.clone(), &tensor).ok()
            }
            (_, Some(list)) => {
                let tensor = tensor_of(nominal(list), products);
                MassProperties::about_com(properties.mass.clone(), properties.com.clone(), tensor).ok()
            }
            _ => None,
        };
        let possible = |reading: Option<MassProperties>| reading.is_some_and(|p| p.existence().is_possible());
        let flipped = match self.products {
            Some(Products::Tensor) => Some((Products::Integral, "integral")),
            Some(Products::Integral) => Some((Products::Tensor, "tensor")),
            None => None,
        };
        if let Some((_, name)) = flipped.filter(|(products, _)| possible(other(*products))) {
            return format!("With --products {name} it could exist. Or give --unphysical");
        }
        let about_com = numbers.inertia.as_ref().and_then(|list| {
            let tensor = tensor_of(nominal(list), self.products.unwrap_or(Products::Tensor));
            MassProperties::about_com(properties.mass.clone(), properties.com.clone(), tensor).ok()
        });
        if possible(about_com) {
            return "The tensor is possible about the centre of mass: if it is that, give it as --inertia-com; else check \
                    the units of length and mass. Or give --unphysical"
                .to_owned();
        }
        "Check digits, units and reference point of the tensor, or give --unphysical".to_owned()
    }
}

/// The number of an option in the units of the part.
fn one(
    option: &str,
    quantity: Option<&Quantity>,
    dimension: Dimension,
    units: &Units,
) -> Result<Option<Measured>, Failure> {
    quantity.map(|number| number.measured(dimension, units)).transpose().map_err(in_option(option))
}

/// The list of an option in the units of the part.
fn all<const N: usize>(
    option: &str,
    list: Option<&[Quantity; N]>,
    dimension: Dimension,
    units: &Units,
) -> Result<Option<[Measured; N]>, Failure> {
    list.map(|list| Quantity::all_measured(list, dimension, units)).transpose().map_err(in_option(option))
}

/// A number with a unit that an option cannot have.
fn in_option(option: &str) -> impl FnOnce(QuantityError) -> Failure + use<'_> {
    move |error| Failure::input(format!("{option}: {error}")).because(error)
}

fn mass_error(error: MassError) -> Failure {
    Failure::input(format!("--mass: {error}")).because(error)
}

fn two_parts(first: &str, second: &str) -> Failure {
    Failure::input(format!(
        "{first} and {second} both say what the part is; give one of --inertia, --inertia-com, --part"
    ))
}

/// The principal moments of a list of entries, as text.
fn moments(list: &[Measured; 6], products: Products) -> String {
    let zero = || dashu_ratio::RBig::ZERO;
    let axes = PrincipalAxes::new(&tensor_of(nominal(list), products), &[zero(), zero(), zero()], 20);
    axes.values.each_ref().map(|value| significant(value.to_f64(), 7)).join(", ")
}

/// The longest text that is shown whole.
const LONG: usize = 24;

/// A number that was typed: whole where it is short.
pub fn shown(text: &str) -> String {
    let value: Option<Number> = if text.len() <= LONG { None } else { text.parse().ok() };
    value.map_or_else(|| text.to_owned(), |value| format!("{}…", significant(value.to_f64(), 14)))
}

/// A number computed for a part: a decimal, exact if it is short, otherwise rounded to this many digits.
pub fn shown_of_part(text: &str, digits: usize) -> String {
    // Fractions of a turned tensor have hundreds of digits, more than a number that may be given.
    let parsed = text.parse::<Number>().map(|number| number.value().clone()).or_else(|_| text.parse::<RBig>());
    let Ok(value) = parsed else { return text.to_owned() };
    let short = decimal::short(&value);
    if short.len() <= digits + 2 && !short.contains('/') {
        return short;
    }
    let rounded = significant(value.to_f64().value(), digits);
    let is_whole = rounded.parse::<Number>().is_ok_and(|number| *number.value() == value);
    if is_whole { rounded } else { format!("{rounded}…") }
}
