//! Codes in columns of relative equilibria: places in lists of words.

use bifdiag_equilibria::critical::Equilibrium;
use bifdiag_schema::Multiplicity;

/// The code of a word that is not in its list.
pub const NONE: i8 = -1;

/// The multiplicities, in the order of their codes.
pub const MULTIPLICITIES: [Multiplicity; 4] =
    [Multiplicity::Points(1), Multiplicity::Points(2), Multiplicity::Circle, Multiplicity::Sphere];

/// The code of a multiplicity; several points that meet have that of two.
#[must_use]
pub fn multiplicity(multiplicity: Multiplicity) -> i8 {
    match multiplicity {
        Multiplicity::Points(1) => 0,
        Multiplicity::Points(_) => 1,
        Multiplicity::Circle => 2,
        Multiplicity::Sphere => 3,
    }
}

/// The word for a multiplicity.
#[must_use]
pub fn multiplicity_word(multiplicity: Multiplicity) -> String {
    match multiplicity {
        Multiplicity::Points(count) => count.to_string(),
        Multiplicity::Circle => "circle".to_owned(),
        Multiplicity::Sphere => "sphere".to_owned(),
    }
}

/// The place of a word in its list, or [`NONE`].
#[must_use]
pub fn place<T: PartialEq>(words: &[T], word: &T) -> i8 {
    words.iter().zip(0..).find(|(known, _)| *known == word).map_or(NONE, |(_, place)| place)
}

/// Ids of curves and names of their branches, in the order in which they first occur.
#[derive(Clone, Debug, Default)]
pub struct Branches(pub Vec<(String, String)>);

impl Branches {
    /// The code of the curve of an equilibrium.
    pub fn code(&mut self, point: &Equilibrium) -> i32 {
        let id = point.curve.map_or_else(String::new, |curve| curve.to_string());
        let known = self.0.iter().position(|(known, _)| *known == id);
        let place = known.unwrap_or_else(|| {
            self.0.push((id, point.branch_name.to_string()));
            self.0.len() - 1
        });
        i32::try_from(place).unwrap_or(i32::MAX)
    }
}
