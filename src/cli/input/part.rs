//! The real part that the options describe.

use std::path::{Path, PathBuf};

use bifdiag_body::PrincipalForm;
use bifdiag_body::part::file::{self, FileError, FileOptions};
use bifdiag_body::part::{
    Existence, MassError, MassProperties, Measured, MeasuredPart, Part, Products, Units, tensor_of,
};
use bifdiag_numbers::Number;
use bifdiag_numbers::symmetric::PrincipalAxes;
use bifdiag_schema::PartDocument;
use clap::Args;

use super::values::{self, Named, Triple, nominal};
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
    /// Tensor of inertia about the fixed point (with --com and --mass)
    #[arg(long, value_name = "Ixx,Iyy,Izz,Ixy,Ixz,Iyz", allow_hyphen_values = true, value_parser = values::tensor, hide_short_help = true)]
    pub inertia: Option<[Measured; 6]>,
    /// Tensor of inertia about the centre of mass (with --com and --mass)
    #[arg(long, value_name = "Ixx,Iyy,Izz,Ixy,Ixz,Iyz", allow_hyphen_values = true, value_parser = values::tensor)]
    pub inertia_com: Option<[Measured; 6]>,
    /// A mesh (.stl, .obj, .ply) or an inertial block (.urdf, MJCF .xml)
    #[arg(long = "part", value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// Which link of a .urdf or .xml
    #[arg(long, value_name = "NAME", hide_short_help = true)]
    pub link: Option<String>,
    /// Density of a mesh, in the units of mass and length of --units; or give --mass
    #[arg(long, value_name = "density", allow_hyphen_values = true, value_parser = values::mass, hide_short_help = true)]
    pub density: Option<Number>,
    /// What the products of inertia are; needed when one of them is not 0
    #[arg(long, value_name = "tensor|integral", value_parser = values::named(&PRODUCTS), hide_short_help = true)]
    pub products: Option<Products>,
    /// Centre of mass; from the fixed point, or with --pivot in the same axes as that
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::measured_point)]
    pub com: Option<[Measured; 3]>,
    /// Mass
    #[arg(long, value_name = "m", allow_hyphen_values = true, value_parser = values::measured_mass)]
    pub mass: Option<Measured>,
    /// Units of mass, length and time, of the part and of all results (default: kg,m,s)
    #[arg(long, value_name = "kg,mm,s", value_parser = values::units, hide_short_help = true)]
    pub units: Option<Units>,
    /// Acceleration of gravity, always in m/s² (default: 9.80665)
    #[arg(long = "g", value_name = "g", allow_hyphen_values = true, value_parser = values::gravity, hide_short_help = true)]
    pub gravity: Option<Number>,
    /// The fixed point, in the axes in which the part is described (default: their origin)
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::center_of_mass, hide_short_help = true)]
    pub pivot: Option<Triple>,
    /// Accept a part that no distribution of mass has
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
}

impl GivenPart {
    /// This part, unless it is known to within so much only.
    fn exact(self) -> Result<Self, Failure> {
        match self.measured {
            None => Ok(self),
            Some(_) => Err(Failure::input(
                "±: only `bifdiag critical-spin` answers for numbers that are known to within so much; leave out ± and what \
                 follows it",
            )),
        }
    }

    /// The block of the documents.
    pub fn document(&self) -> PartDocument {
        bifdiag_documents::part(&self.part, &self.principal)
    }
}

impl PartArguments {
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
            let hint = self.hint(&part.properties);
            return Err(Failure::input(format!(
                "{option}: this part cannot exist: about its centre of mass {inequality} ({unit}). {hint}"
            )));
        }
        Ok(Some(given))
    }

    /// The part of the options, also when it cannot exist.
    pub fn shown(&self) -> Result<Option<GivenPart>, Failure> {
        self.read()?.map(GivenPart::exact).transpose()
    }

    fn read(&self) -> Result<Option<GivenPart>, Failure> {
        let Some(given) = self.given().next() else { return Ok(None) };
        let (option, properties) = self.properties(given)?;
        if self.gravity.is_none() {
            tracing::warn!("--g is not given: standard gravity is taken, {STANDARD_GRAVITY} m/s²");
        }
        let standard = || STANDARD_GRAVITY.parse().unwrap_or_else(|_| unreachable!("a number"));
        let gravity: Number = self.gravity.clone().unwrap_or_else(standard);
        let units = self.units.clone().unwrap_or_default();
        let part = Part { properties, gravity: gravity.value().clone(), units };
        let principal =
            part.principal().map_err(|error| Failure::input(format!("{option}: {error}")).because(error))?;
        Ok(Some(GivenPart { option, part, principal, measured: self.measured()? }))
    }

    /// The numbers as they were measured, from the fixed point; `None` where all are exact.
    fn measured(&self) -> Result<Option<MeasuredPart>, Failure> {
        let exact = |measured: &Measured| measured.within.is_zero();
        if self.file.is_some() {
            if self.mass.as_ref().is_none_or(exact) {
                return Ok(None);
            }
            return Err(Failure::input(
                "--mass with ± and --part: tensor and weight of a file grow with its mass, so that no spin depends on it; \
                 leave out ± and what follows it",
            ));
        }
        let list = self.inertia.as_ref().or(self.inertia_com.as_ref());
        let (Some(list), Some(com), Some(mass)) = (list, &self.com, &self.mass) else { return Ok(None) };
        let mut inputs = list.iter().chain(com).chain([mass]).cloned();
        let mut part = MeasuredPart {
            about_com: self.inertia_com.is_some(),
            inputs: std::array::from_fn(|_| inputs.next().unwrap_or_else(|| unreachable!("six, three and one"))),
        };
        if self.products == Some(Products::Integral) {
            for product in &mut part.inputs[3..6] {
                product.value = -product.value.clone();
            }
        }
        for (coordinate, pivot) in part.inputs[6..9].iter_mut().zip(self.pivot.iter().flat_map(Triple::values)) {
            coordinate.value -= pivot;
        }
        let is_exact = part.uncertain().next().is_none();
        Ok((!is_exact).then_some(part))
    }

    /// The mass properties seen from the fixed point, and the option that gave them.
    fn properties(&self, given: &'static str) -> Result<(&'static str, MassProperties), Failure> {
        if let Some(path) = &self.file {
            return Ok(("--part", self.of_file(path)?));
        }
        let of_files = [("--link", self.link.is_some()), ("--density", self.density.is_some())];
        if let Some((option, _)) = of_files.into_iter().find(|(_, given)| *given) {
            return Err(Failure::input(format!("{option} does nothing without --part")));
        }
        let missing = |missing, example| incomplete(given, missing, example);
        let (option, list) = match (&self.inertia, &self.inertia_com) {
            (Some(_), Some(_)) => return Err(two_parts("--inertia", "--inertia-com")),
            (Some(list), None) => ("--inertia", list),
            (None, Some(list)) => ("--inertia-com", list),
            (None, None) => {
                return Err(missing("--inertia or --inertia-com", "--inertia-com 0.24,0.15,0.17,0,0,0"));
            }
        };
        let com = self.com.as_ref().ok_or_else(|| missing("--com", "--com 0,0.02,0.15"))?;
        let mass = self.mass.as_ref().ok_or_else(|| missing("--mass", "--mass 2.5"))?;
        let (mass, com) = (mass.value.clone(), nominal(com));
        if self.inertia.is_some() {
            if self.pivot.is_some() {
                return Err(Failure::input(
                    "--pivot with --inertia: that tensor is about the fixed point already; give --inertia-com, or no --pivot",
                ));
            }
            let read =
                |products| MassProperties::about_origin(mass.clone(), com.clone(), &tensor_of(nominal(list), products));
            return Ok((option, self.with_products(option, list, read)?));
        }
        let read = |products| MassProperties::about_com(mass.clone(), com.clone(), tensor_of(nominal(list), products));
        let properties = self.with_products(option, list, read)?;
        Ok((option, self.pivot.iter().fold(properties, |properties, pivot| properties.seen_from(&pivot.values()))))
    }

    /// The mass properties of a file, seen from the pivot, in the units of the part.
    fn of_file(&self, path: &Path) -> Result<MassProperties, Failure> {
        let others = [("--inertia", self.inertia.is_some()), ("--inertia-com", self.inertia_com.is_some())];
        if let Some((second, _)) = others.into_iter().find(|(_, given)| *given) {
            return Err(two_parts("--part", second));
        }
        let useless = [("--com", self.com.is_some()), ("--products", self.products.is_some())];
        if let Some((option, _)) = useless.into_iter().find(|(_, given)| *given) {
            return Err(Failure::input(format!("{option} does nothing with --part: the file says it")));
        }
        let mass = self.mass.as_ref().map(|mass| Number::from_rational(mass.value.clone()));
        let wanted = FileOptions { link: self.link.as_deref(), density: self.density.as_ref(), mass: mass.as_ref() };
        let read = file::read(path, &wanted).map_err(|source| {
            let hint = match source {
                FileError::NoDensity | FileError::DensityAndMass => "; give --density or --mass",
                _ => "",
            };
            Failure::input(format!("--part {}: {source}{hint}", path.display())).because(source)
        })?;
        let origin = || [dashu_ratio::RBig::ZERO, dashu_ratio::RBig::ZERO, dashu_ratio::RBig::ZERO];
        let pivot = self.pivot.as_ref().map_or_else(origin, Triple::values);
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
                _ => "compare them with those that your program prints, or look up its convention",
            };
            let [tensor, integral] = [Products::Tensor, Products::Integral].map(|products| moments(list, products));
            return Err(Failure::input(format!(
                "--products is missing: a product of inertia in {option} is not 0, and programs differ in its sign. The \
                 principal moments would be {tensor} with --products tensor (Ixy = -∫ x y dm), {integral} with --products \
                 integral (Ixy = +∫ x y dm); {hint}"
            )));
        }
        read(self.products.unwrap_or(Products::Tensor)).map_err(mass_error)
    }

    /// What may be wrong with a part that cannot exist.
    fn hint(&self, properties: &MassProperties) -> String {
        let other = |products| match (&self.inertia, &self.inertia_com) {
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
        let about_com = self.inertia.as_ref().and_then(|list| {
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

/// A rational as it is shown: exactly where that is short.
pub fn shown(text: &str) -> String {
    const LONG: usize = 24;
    if text.len() <= LONG {
        return text.to_owned();
    }
    let value: Option<Number> = text.parse().ok();
    value.map_or_else(|| text.to_owned(), |value| format!("{}…", significant(value.to_f64(), 14)))
}
