//! Table 1 of Schmidt, Dullin and Richter (2008): what lies over a component of U (Proposition 9.1, Theorem 10.6,
//! Proposition 10.7).

use bifdiag_schema::ComponentDocument;

/// A component of U: a sphere without `boundary_circles` discs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Component {
    pub boundary_circles: u32,
    /// Whether r̂ and −r̂ lie in it; `None` when r = 0.
    pub poles: Option<[bool; 2]>,
}

impl Component {
    fn pole_count(&self) -> u32 {
        self.poles.map_or(0, |poles| poles.into_iter().map(u32::from).sum())
    }

    /// k + n − 1 with k circles and n poles: the section is the double of the component without n discs.
    fn genus(&self) -> Option<u32> {
        self.poles.map(|_| (self.boundary_circles + self.pole_count()).saturating_sub(1))
    }

    /// The component as documents describe it.
    pub fn document(&self) -> ComponentDocument {
        let signs = |[plus, minus]: [bool; 2]| {
            [(plus, "+"), (minus, "-")].iter().filter(|(holds, _)| *holds).map(|(_, sign)| (*sign).to_owned()).collect()
        };
        ComponentDocument {
            boundary_circles: self.boundary_circles,
            poles: self.poles.map(signs),
            accessible_region: match self.boundary_circles {
                0 => "S2".to_owned(),
                1 => "D2".to_owned(),
                k => format!("S2-{k}D2"),
            },
            energy_surface: match self.boundary_circles {
                0 => "RP3".to_owned(),
                1 => "S3".to_owned(),
                2 => "S1xS2".to_owned(),
                3 => "(S1xS2)#(S1xS2)".to_owned(),
                k => format!("#{}(S1xS2)", k - 1),
            },
            section: self.genus().map(|genus| match genus {
                0 => "S2".to_owned(),
                1 => "T2".to_owned(),
                g => format!("M{g}"),
            }),
            genus: self.genus(),
        }
    }
}

/// The components of documents: by circles, number of poles, r̂ before −r̂.
pub(crate) fn documents(components: &[Component]) -> Vec<ComponentDocument> {
    let mut sorted = components.to_vec();
    sorted.sort_by_key(|c| (c.boundary_circles, c.pole_count(), c.poles.is_some_and(|[_, minus]| minus)));
    sorted.iter().map(Component::document).collect()
}

/// The sections' names joined by `+`; `None` when r = 0.
pub(crate) fn signature(components: &[ComponentDocument]) -> Option<String> {
    let names: Option<Vec<&str>> = components.iter().map(|c| c.section.as_deref()).collect();
    names.map(|names| names.join("+"))
}

/// Components in words: each accessible region with its poles.
pub(crate) fn words(components: &[ComponentDocument]) -> String {
    let word = |c: &ComponentDocument| {
        format!("{}({})", c.accessible_region, c.poles.as_ref().map_or_else(String::new, |poles| poles.concat()))
    };
    components.iter().map(word).collect::<Vec<_>>().join(" + ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn component(boundary_circles: u32, plus: bool, minus: bool) -> Component {
        Component { boundary_circles, poles: Some([plus, minus]) }
    }

    #[test]
    fn table_1_of_the_paper() {
        for (k, plus, minus, region, surface, section, genus) in [
            (1, false, false, "D2", "S3", "S2", 0),
            (2, false, false, "S2-2D2", "S1xS2", "T2", 1),
            (3, false, false, "S2-3D2", "(S1xS2)#(S1xS2)", "M2", 2),
            (1, true, false, "D2", "S3", "T2", 1),
            (2, false, true, "S2-2D2", "S1xS2", "M2", 2),
            (3, true, false, "S2-3D2", "(S1xS2)#(S1xS2)", "M3", 3),
            (0, true, true, "S2", "RP3", "T2", 1),
            (1, true, true, "D2", "S3", "M2", 2),
            (2, true, true, "S2-2D2", "S1xS2", "M3", 3),
            (3, true, true, "S2-3D2", "(S1xS2)#(S1xS2)", "M4", 4),
        ] {
            let found = component(k, plus, minus).document();
            assert_eq!((found.accessible_region.as_str(), found.energy_surface.as_str()), (region, surface));
            assert_eq!((found.section.as_deref(), found.genus), (Some(section), Some(genus)));
        }
    }

    #[test]
    fn components_are_sorted_by_circles_poles_and_sign() {
        let all = documents(&[
            component(1, false, true),
            component(2, false, false),
            component(1, true, false),
            component(1, false, false),
        ]);
        assert_eq!(signature(&all).as_deref(), Some("S2+T2+T2+T2"));
        assert_eq!(words(&all), "D2() + D2(+) + D2(-) + S2-2D2()");
    }

    #[test]
    fn without_a_centre_of_mass_there_is_no_section() {
        let euler = documents(&[Component { boundary_circles: 2, poles: None }]);
        assert_eq!((euler[0].genus, euler[0].section.as_deref(), euler[0].poles.as_deref()), (None, None, None));
        assert_eq!(signature(&euler), None);
    }
}
