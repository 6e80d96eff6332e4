/* One line a function: arguments from `a`, results to `r`. */
#include "checks.h"

#include <stddef.h>

#define CHECK(name, body)                                                                                              \
    static void name(const uint32_t a[8], uint32_t r[4]) {                                                             \
        body;                                                                                                          \
    }

CHECK(unit_to_f32, r[0] = bits(bd_unit_to_f32(a[0])))
CHECK(hash_mix, r[0] = bd_hash_mix(a[0]))
CHECK(hash_combine, r[0] = bd_hash_combine(a[0], a[1]))
CHECK(hash_laine_karras, r[0] = bd_hash_laine_karras(a[0], a[1]))
CHECK(hash_owen, r[0] = bd_hash_owen(a[0], a[1]))
CHECK(hash_other, r[0] = bd_hash_other(a[0]))
CHECK(hash_laine_karras_4, r[0] = bd_hash_laine_karras_4(a[0], a[1]))
CHECK(hash_owen_4, r[0] = bd_hash_owen_4(a[0], a[1]))
CHECK(hash_shuffle_rev, r[0] = bd_hash_shuffle_rev(a[0], a[1]))
CHECK(hash_shuffle, r[0] = bd_hash_shuffle(a[0], a[1]))
CHECK(hash_mix_64, uint64_t h = bd_hash_mix_64((uint64_t)a[0] << 32 | a[1]); r[0] = (uint32_t)(h >> 32);
      r[1] = (uint32_t)h)
CHECK(torus_wrap, r[0] = bd_torus_wrap(a[0], UINT32_C(1) << a[1] % 32))
CHECK(torus_offset, bd_torus_offset(a[0], a[1], a[2], a[3], a[4], r);
      bd_torus_offset(a[0], a[1], a[2], a[3], a[5] % 33, r + 2))
CHECK(sobol_point, bd_sobol_point(a[0], r))
CHECK(sobol_dimension_1_rev, r[0] = bd_sobol_dimension_1_rev(a[0]))
CHECK(sobol_owen_point, bd_sobol_owen_point(a[0], a[1], r))
CHECK(directions_dimension, r[0] = bd_directions_dimension(bd_sobol_16, a[0], a[1]))
CHECK(directions_owen, r[0] = bd_directions_owen(bd_sobol_16, a[0], a[1], a[2]))
CHECK(zorder_morton_16, r[0] = bd_zorder_morton_16(a[0], a[1]))
CHECK(strata_place_1d, r[0] = bd_strata_place_1d(a[0], a[1], a[2]))
CHECK(strata_place_2d, bd_strata_place_2d(a[0], a[1], a + 2, r))
CHECK(shift_global, r[0] = bd_shift_global(a[0], a[1]))
CHECK(shift_stratified_1d, r[0] = bd_shift_stratified_1d(a[0], a[1], a[2], a[3]))
CHECK(shift_stratified_2d, bd_shift_stratified_2d(a[0], a[1], a + 2, a + 4, r))
CHECK(scalar_rank, r[0] = bd_scalar_rank(bd_threshold_64, a[0], a[1]);
      r[1] = bd_scalar_rank(bd_threshold_256, a[0], a[1]); r[2] = bd_scalar_rank(bd_threshold_16, a[0], a[1]))
CHECK(scalar_value, r[0] = bd_scalar_value_fx(bd_threshold_64, a[0], a[1]);
      r[1] = bd_scalar_value_fx(bd_threshold_256, a[0], a[1]);
      r[2] = bits(bd_scalar_value(bd_threshold_16, a[0], a[1])))
CHECK(vector_value, bd_vector_value_fx(bd_offset_2d_64, a[0], a[1], r);
      bd_vector_value_fx(bd_lattice_64, a[0], a[1], r + 2))
CHECK(time_mask_frame, r[0] = bd_scalar_rank(bd_time_mask_frame(bd_threshold_over_time_32, a[2]), a[0], a[1]);
      r[1] = bd_scalar_rank(bd_time_mask_frame(bd_threshold_over_time_64, a[2]), a[0], a[1]))
CHECK(keys_key, bd_keys_key(bd_keys_64, a[0], a[1], r); bd_keys_key(bd_keys_128, a[0], a[1], r + 2))
CHECK(dither_threshold_fx, r[0] = bd_dither_threshold_fx(bd_threshold_64, a[0], a[1], a[2], a[3]);
      r[1] = bd_dither_threshold_fx(bd_threshold_16, a[0], a[1], a[2], a[3]))
CHECK(quantise_level, r[0] = bd_quantise_level((uint16_t)a[0], (uint16_t)a[1], (uint16_t)a[2], a[3]))

/* Rows of 0 to 24 pixels, of the bytes of the last six words. */
static void dither_gray1_row(const uint32_t a[8], uint32_t r[4]) {
    uint8_t gray[24], packed[4];
    uint32_t k;
    for (k = 0; k < 24; k++) {
        gray[k] = (uint8_t)(a[2 + k / 4] >> 8 * (k % 4));
    }
    for (k = 0; k < 4; k++) {
        packed[k] = 0xa5;
    }
    bd_dither_gray1_row(bd_threshold_64, a[0], a[1], gray, a[1] % 25, packed);
    for (k = 0; k < 4; k++) {
        r[k] = packed[k];
    }
}

#define ENTRY(name) {#name, name}
const check_t checks_of_functions[] = {
    ENTRY(unit_to_f32), ENTRY(hash_mix), ENTRY(hash_combine), ENTRY(hash_laine_karras), ENTRY(hash_owen),
    ENTRY(hash_other), ENTRY(hash_laine_karras_4), ENTRY(hash_owen_4), ENTRY(hash_shuffle_rev), ENTRY(hash_shuffle),
    ENTRY(hash_mix_64), ENTRY(torus_wrap), ENTRY(torus_offset), ENTRY(sobol_point), ENTRY(sobol_dimension_1_rev),
    ENTRY(sobol_owen_point), ENTRY(directions_dimension), ENTRY(directions_owen), ENTRY(zorder_morton_16),
    ENTRY(strata_place_1d), ENTRY(strata_place_2d),
    ENTRY(shift_global), ENTRY(shift_stratified_1d), ENTRY(shift_stratified_2d), ENTRY(scalar_rank),
    ENTRY(scalar_value), ENTRY(vector_value), ENTRY(time_mask_frame), ENTRY(keys_key), ENTRY(dither_threshold_fx),
    ENTRY(quantise_level), ENTRY(dither_gray1_row),
    {NULL, NULL},
};
