//! Calls functions by every public name from a `no_std` program whose panic handler does not link: if the optimised
//! code could panic anywhere, this crate would not build. `.ci/run` also sees to it that no name is forgotten.
//!
//! Build it with `RUSTFLAGS="-Clink-arg=-nostdlib -Clink-arg=-lc -Clink-arg=-Wl,--no-undefined,--gc-sections"`.
#![no_std]

mod halftones;
mod parts;
mod shader;
mod time;

use bluedither::tables::{OFFSET_2D_64, THRESHOLD_64};
use bluedither::{Dithered, Keyed, Keys, Sampler, White};

unsafe extern "C" {
    /// Defined nowhere.
    fn the_optimised_code_can_panic() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    unsafe { the_optimised_code_can_panic() }
}

static KEYS: Keys<4> = Keys::new([[[1, 2], [3, 4], [5, 6], [7, 8]]; 4]);

/// Numbers that only the caller knows.
#[repr(C)]
pub struct Place {
    seed: u32,
    spp: u32,
    x: u32,
    y: u32,
    frame: u32,
    domain: u32,
    index: u32,
}

/// Every draw of a sampler, with slices of unknown length.
macro_rules! drawn {
    ($place:ident, $floats:ident, $words:ident, $($sampler:expr;)*) => {{
        let Place { x, y, frame, domain, index, spp, .. } = *$place;
        let mut sum = 0.0;
        $({
            let sampler = $sampler;
            let pixel = sampler.pixel(x, y, frame);
            sum += pixel.draw::<1>(domain, index)[0] + pixel.draw::<2>(domain, index)[1];
            sum += pixel.draw::<3>(domain, index)[2] + pixel.draw::<4>(domain, index)[3];
            sum += pixel.draw::<5>(domain, index)[4] + pixel.draw::<6>(domain, index)[5];
            sum += pixel.draw::<7>(domain, index)[6] + pixel.draw::<8>(domain, index)[7];
            sum += pixel.draw_fx::<8>(domain, index)[7] as f32;
            pixel.fill(domain, index, $floats);
            pixel.fill_fx(domain, index, $words);
            sampler.fill_row(x, y, frame, domain, index, $floats);
            sampler.fill_row_fx(x, y, frame, domain, index, $words);
            sum += pixel.pattern::<2, 16>(domain, spp).iter().map(|point| point[0]).sum::<f32>();
        })*
        sum
    }};
}

/// All samplers.
#[unsafe(no_mangle)]
pub extern "C" fn samplers(place: &Place, n: usize, floats: &mut [[f32; 8]; 9], words: &mut [[u32; 7]; 9]) -> f32 {
    let Place { seed, spp, .. } = *place;
    let (Some(floats), Some(words)) = (floats.get_mut(..n), words.get_mut(..n)) else { return 0.0 };
    drawn!(place, floats, words,
        Sampler::new(seed);
        Sampler::with_spp(seed, spp);
        Dithered::new(seed);
        Dithered::with_spp(seed, spp);
        Dithered::with_masks(&THRESHOLD_64, &OFFSET_2D_64, seed).stratified(spp);
        Dithered::new(seed).stratified_1d(spp);
        Dithered::new(seed).stratified(spp).global();
        Keyed::with_spp(seed, spp);
        Keyed::with_keys(&KEYS, seed);
        Dithered::lattice(seed);
        Dithered::new(seed).on_lattice();
        White::with_spp(seed, spp);
    )
}
