//! How long build.rs optimises.

/// The level that the environment variable `BLUEDITHER_EFFORT` asked for when the crate was built.
///
/// Masks differ between levels, and are the same on every machine within one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// `quick`: an eighth of the swaps, for iterating and for emulated hosts.
    Quick,
    /// `normal`, the default: half a second for the default features.
    Normal,
    /// `thorough`: fifty times the swaps of normal, about a seventh to a fifth less error from the offset masks.
    Thorough,
}

impl Effort {
    /// All levels, least first.
    pub const ALL: [Self; 3] = [Self::Quick, Self::Normal, Self::Thorough];

    /// The word that selects it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Quick => "quick",
            Self::Normal => "normal",
            Self::Thorough => "thorough",
        }
    }
}
