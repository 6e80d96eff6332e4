//! The families of integrands, and where each stands in the list of all.

/// What a family is.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    pub name: &'static str,
    pub count: usize,
    /// Each integrand counts divided by white noise's error; otherwise as it is.
    pub normalised: bool,
    /// Plain: what pictures are made of. Not so: an exclusive or, checkers, which are there for information.
    pub plain: bool,
    /// Its first place in the list of all.
    pub first: usize,
}

macro_rules! families {
    ($($id:ident = $name:literal, $count:expr, $normalised:literal, $plain:literal;)*) => {
        /// Places in [`FAMILIES`].
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Id { $($id),* }

        /// All families, one after the other.
        pub const FAMILIES: &[Family] = &placed([$(
            Family { name: $name, count: $count, normalised: $normalised, plain: $plain, first: 0 },
        )*]);
    };
}

// Every count is a multiple of four, for vectors, and for spectra, which are taken in pairs.
families! {
    Own = "half-planes, own pair", 64, false, true;
    Across = "half-planes, across pairs", 48, false, true;
    Space3 = "half-spaces, 3-D", 24, false, true;
    Space5 = "half-spaces, 5-D", 32, false, true;
    Space8 = "half-spaces, 8-D", 24, false, true;
    Product = "product of two half-planes", 32, false, true;
    Below = "A and B below a half", 24, false, true;
    Xor = "xor", 12, false, false;
    Checkers = "checkers", 12, false, false;
    SmoothPair = "smooth, own pair", FIXED + EDGES, true, true;
    Smooth5 = "smooth, 5-D", 24, true, true;
    Smooth8 = "smooth, 8-D", 24, true, true;
    Light = "direct light, one number picks", 16, true, true;
}

/// Smooth functions of a pair without a random part, once in each of the four pairs; then soft edges, eight a pair.
pub const FIXED: usize = 4 * 6;
pub const EDGES: usize = 4 * 8;
/// All integrands.
pub const ALL: usize = FAMILIES[FAMILIES.len() - 1].first + FAMILIES[FAMILIES.len() - 1].count;

const fn placed<const N: usize>(mut all: [Family; N]) -> [Family; N] {
    let mut k = 1;
    while k < N {
        all[k].first = all[k - 1].first + all[k - 1].count;
        k += 1;
    }
    all
}

impl Id {
    pub const fn family(self) -> &'static Family {
        &FAMILIES[self as usize]
    }

    pub const fn count(self) -> usize {
        self.family().count
    }
}

impl Family {
    pub const fn range(&self) -> core::ops::Range<usize> {
        self.first..self.first + self.count
    }

    /// How often the integrand at place `k` of this family counts: four soft edges to six fixed functions, as in the
    /// family of a single pair.
    pub fn weight(&self, k: usize) -> f64 {
        let edges_a_draw = 4;
        if self.first == Id::SmoothPair.family().first && k < FIXED { (EDGES / 4 / edges_a_draw) as f64 } else { 1.0 }
    }
}
