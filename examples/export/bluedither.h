/* bluedither.h: numbers per pixel whose error in the picture is blue noise, for C99 and C++11.
 *
 * SPDX-License-Identifier: @licence@
 * bluedither @version@, tables baked at @effort@ effort. Written by `cargo run -p export -- --lang c`: do not edit.
 *
 * Functions of the Rust crate bluedither, bit by bit the same, under the same names: `bd_`, the module or type, the name.
 * Here are the samplers Sampler, Keyed and White, and what they are made of; masks, also over time; shifts;
 * thresholds of a mask, levels, and rows of 1 bit. What is not here is in the crate, and most of it in its WGSL: Dithered,
 * lattices, the rest of strata, other halftones and formats of pixels, seed permutation.
 * Nothing but <stdint.h>; no memory, no state. Floats come from `draw` and `value` only, where no `_fx` follows.
 * Every argument of a function is defined; signed coordinates are cast to uint32_t, and tiles repeat. All is `static`: an
 * optimising compiler links a table with every source file that uses it, others with every one that includes this. So
 * use it in one, and write the tables that you need by `--mask`.
 *
 *     bd_sampler_t sampler = bd_sampler_with_spp(seed, spp);    or bd_sampler_new(seed), if the number is not known
 *     bd_sampler_pixel_t pixel = bd_sampler_pixel(sampler, x, y, frame);
 *     for (index = 0; index < spp; index++) {
 *         float lens[2], time;
 *         bd_sampler_draw2(&pixel, LENS, index, lens);          in [0, 1); LENS, TIME: numbers that name a purpose
 *         time = bd_sampler_draw1(&pixel, TIME, index);
 *     }
 *
 * `_fx`: 0.32 fixed point in a uint32_t, the value times 2^32. `_rev`: bit-reversed. `_log2`: of a power of two.
 * Numbers in more than one dimension come back in `out`.
 */
#ifndef BLUEDITHER_H
#define BLUEDITHER_H

#if !defined(__cplusplus) && (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L)
#error "bluedither.h needs C99 or C++11: choose it by -std=c99"
#endif

#include <stdint.h>

/* ---- unit: the only place where fixed point becomes a float ---- */

/* The float in [0, 1) at or just below a 0.32 number: its upper 24 bits, exactly. */
static inline float bd_unit_to_f32(uint32_t value_fx) {
    return (float)(value_fx >> 8) * (1.0f / 16777216.0f);
}

/* ---- hash: seeds and scrambles ---- */

static inline uint32_t bd_hash_reverse_bits(uint32_t n) {
    n = (n >> 1 & UINT32_C(0x55555555)) | (n & UINT32_C(0x55555555)) << 1;
    n = (n >> 2 & UINT32_C(0x33333333)) | (n & UINT32_C(0x33333333)) << 2;
    n = (n >> 4 & UINT32_C(0x0f0f0f0f)) | (n & UINT32_C(0x0f0f0f0f)) << 4;
    n = (n >> 8 & UINT32_C(0x00ff00ff)) | (n & UINT32_C(0x00ff00ff)) << 8;
    return n >> 16 | n << 16;
}

/* A bijection in which every input bit flips every output bit with a chance near one half (constants: hash-prospector,
 * C. Wellons and TheIronBorn). */
static inline uint32_t bd_hash_mix(uint32_t value) {
    uint32_t h = value ^ UINT32_C(0xe6fe3beb);
    h ^= h >> 16;
    h *= UINT32_C(0x21f0aaad);
    h ^= h >> 15;
    h *= UINT32_C(0xd35a2d97);
    return h ^ h >> 15;
}

/* A seed that depends on all bits of both and on their order; chain it for more. */
static inline uint32_t bd_hash_combine(uint32_t seed, uint32_t value) {
    return bd_hash_mix(bd_hash_mix(seed) + value);
}

/* 64 bits of seed from 64: a bijection (multiplier: P. Evensen, rrmxmx). */
static inline uint64_t bd_hash_mix_64(uint64_t value) {
    uint64_t h = value ^ UINT64_C(0x9e3779b97f4a7c15);
    h = (h ^ h >> 32) * UINT64_C(0x9fb21c651e98df25);
    h = (h ^ h >> 29) * UINT64_C(0x9fb21c651e98df25);
    return h ^ h >> 32;
}

/* Laine-Karras permutation (second version of N. Vegdahl): every bit is flipped by a hash of the bits below it. Hash
 * the seed first. */
static inline uint32_t bd_hash_laine_karras(uint32_t value_rev, uint32_t seed) {
    uint32_t n = value_rev;
    n ^= n * UINT32_C(0x3d20adea);
    n += seed;
    n *= seed >> 16 | 1;
    n ^= n * UINT32_C(0x05526c56);
    return n ^ n * UINT32_C(0x53a22864);
}

/* Nested uniform (Owen) scramble of a 0.32 number: digit k is flipped by a hash of the digits above it. */
static inline uint32_t bd_hash_owen(uint32_t value_fx, uint32_t seed) {
    return bd_hash_reverse_bits(bd_hash_laine_karras(bd_hash_reverse_bits(value_fx), seed));
}

/* Another seed from a seed, cheaper than bd_hash_mix. */
static inline uint32_t bd_hash_other(uint32_t seed) {
    return (uint32_t)(seed * UINT64_C(0x9e3779b97f4a7c15) >> 32);
}

/* Base-4 form of bd_hash_laine_karras: every pair of bits goes through a permutation of 0..3 that a hash of the pairs
 * below it has chosen. */
static inline uint32_t bd_hash_laine_karras_4(uint32_t value_rev, uint32_t seed) {
    const uint32_t first = UINT32_C(0x55555555);
    const uint32_t own = bd_hash_other(seed);
    const uint32_t hash = bd_hash_laine_karras(value_rev, own);
    const uint32_t choice = hash << 2 | own >> 30;
    const uint32_t third = hash << 4 | (own >> 26 & 0xf);
    uint32_t n = value_rev;
    n ^= (n & first) << 1;
    n ^= n >> 1 & choice & first;
    n ^= (n & choice >> 1 & first) << 1;
    n ^= n >> 1 & third & first;
    return bd_hash_laine_karras(n, seed);
}

/* Nested uniform scramble in base 4 of a 0.32 number. */
static inline uint32_t bd_hash_owen_4(uint32_t value_fx, uint32_t seed) {
    return bd_hash_reverse_bits(bd_hash_laine_karras_4(bd_hash_reverse_bits(value_fx), seed));
}

/* Shuffles sample numbers so that every set {0, ..., 2^k - 1} stays the same set; bit-reversed. Hash the seed first. */
static inline uint32_t bd_hash_shuffle_rev(uint32_t index_rev, uint32_t seed) {
    uint32_t n = index_rev;
    n ^= n * (seed & ~UINT32_C(1));
    n *= seed >> 20 | 1;
    return n ^ n * (seed >> 10 & ~UINT32_C(1));
}

/* bd_hash_shuffle_rev of an index that is not reversed. */
static inline uint32_t bd_hash_shuffle(uint32_t index, uint32_t seed) {
    return bd_hash_reverse_bits(bd_hash_shuffle_rev(bd_hash_reverse_bits(index), seed));
}

/* ---- torus: a tile repeats without a seam ---- */

/* A coordinate inside a tile of `size` pixels, a power of two. */
static inline uint32_t bd_torus_wrap(uint32_t coordinate, uint32_t size) {
    return coordinate & (size - 1);
}

/* How far from the pixel itself a tile of 2^size_log2 squared pixels is read: other domains, pads and frames read it
 * elsewhere, along the R2 sequence (M. Roberts 2018). Number domains 0, 1, 2, ... */
static inline void bd_torus_offset(uint32_t seed, uint32_t domain, uint32_t pad, uint32_t frame, uint32_t size_log2,
                                   uint32_t out[2]) {
    const uint32_t x = bd_hash_mix(seed), y = bd_hash_mix(x);
    const uint32_t shift = size_log2 < 32 ? 32 - size_log2 : 0;
    out[0] = x + domain * UINT32_C(0xc13fa9a9) + frame * UINT32_C(0x2780e141) + pad * UINT32_C(0x70416dd8);
    out[1] = y + domain * UINT32_C(0x91e10da5) + frame * UINT32_C(0xbc218b0d) + pad * UINT32_C(0x247e9a23);
    out[0] = shift < 32 ? out[0] >> shift : 0;
    out[1] = shift < 32 ? out[1] >> shift : 0;
}

/* ---- sobol: points of the (0, 2)-sequence, and their own scrambles ---- */

/* Point `index` of dimension 0, the van der Corput sequence. */
static inline uint32_t bd_sobol_dimension_0(uint32_t index) {
    return bd_hash_reverse_bits(index);
}

/* Point `index` of dimension 1, bit-reversed: Pascal's triangle modulo 2, by five butterflies. */
static inline uint32_t bd_sobol_dimension_1_rev(uint32_t index) {
    uint32_t n = index;
    n ^= n >> 1 & UINT32_C(0x55555555);
    n ^= n >> 2 & UINT32_C(0x33333333);
    n ^= n >> 4 & UINT32_C(0x0f0f0f0f);
    n ^= n >> 8 & UINT32_C(0x00ff00ff);
    return n ^ n >> 16;
}

static inline uint32_t bd_sobol_dimension_1(uint32_t index) {
    return bd_hash_reverse_bits(bd_sobol_dimension_1_rev(index));
}

/* Point `index` of the first two dimensions. */
static inline void bd_sobol_point(uint32_t index, uint32_t out[2]) {
    out[0] = bd_sobol_dimension_0(index);
    out[1] = bd_sobol_dimension_1(index);
}

/* bd_sobol_point with one independent Owen scramble a dimension. */
static inline void bd_sobol_owen_point(uint32_t index, uint32_t seed, uint32_t out[2]) {
    const uint32_t other = bd_hash_mix(seed ^ UINT32_C(0x94d049bb));
    out[0] = bd_hash_reverse_bits(bd_hash_laine_karras(index, bd_hash_mix(seed)));
    out[1] = bd_hash_reverse_bits(bd_hash_laine_karras(bd_sobol_dimension_1_rev(index), other));
}

/* Direction numbers of `count` dimensions, 32 each. */
typedef struct {
    const uint32_t (*numbers)[32];
    uint32_t count;
} bd_directions_t;

/* Point `index` of dimension `dimension` modulo the number of dimensions. As they are, the higher dimensions are poorly
 * spread in pairs over the first points: take bd_directions_owen. */
static inline uint32_t bd_directions_dimension(bd_directions_t directions, uint32_t index, uint32_t dimension) {
    const uint32_t *numbers = directions.numbers[dimension % directions.count];
    uint32_t sum = 0;
    for (; index != 0; index >>= 1, numbers++) {
        if (index & 1) {
            sum ^= *numbers;
        }
    }
    return sum;
}

/* The same, Owen-scrambled; dimensions beyond the last come again, each time in an order and by a scramble of their
 * own. */
static inline uint32_t bd_directions_owen(bd_directions_t directions, uint32_t index, uint32_t dimension,
                                          uint32_t seed) {
    const uint32_t round = dimension / directions.count;
    const uint32_t scramble = bd_hash_combine(seed, bd_hash_mix(dimension));
    const uint32_t shuffled = round == 0 ? index : bd_hash_shuffle(index, bd_hash_combine(seed, round));
    return bd_hash_owen(bd_directions_dimension(directions, shuffled, dimension), scramble);
}

/* ---- zorder: pixels along a Z curve ---- */

/* The Morton code of the lower 16 bits of both: bit k of x is bit 2k, bit k of y bit 2k+1. */
static inline uint32_t bd_zorder_morton_16(uint32_t x, uint32_t y) {
    uint64_t n = (uint64_t)(y & 0xffff) << 32 | (x & 0xffff);
    n = (n | n << 8) & UINT64_C(0x00ff00ff00ff00ff);
    n = (n | n << 4) & UINT64_C(0x0f0f0f0f0f0f0f0f);
    n = (n | n << 2) & UINT64_C(0x3333333333333333);
    n = (n | n << 1) & UINT64_C(0x5555555555555555);
    return (uint32_t)(n | n >> 31);
}

/* ---- strata: the unit interval or square in `count` cells of equal size, any count; 0 counts as 1 ---- */

/* The point at `inside` of cell `cell` (modulo `count`). A 64-bit division. */
static inline uint32_t bd_strata_place_1d(uint32_t cell, uint32_t count, uint32_t inside) {
    count = count == 0 ? 1 : count;
    return (uint32_t)(((uint64_t)(cell % count) << 32 | inside) / count);
}

/* How many rows of cells the square has: the root of `count`, rounded to the nearest. */
static inline uint64_t bd_strata_rows(uint64_t count) {
    uint64_t root = 0, bit;
    for (bit = UINT64_C(1) << 16; bit != 0; bit >>= 1) {
        if ((root | bit) * (root | bit) <= count) {
            root |= bit;
        }
    }
    return count - root * root > root ? root + 1 : root;
}

/* The point at `inside` of cell `cell` (modulo `count`) of the square. An integer root and five 64-bit divisions. */
static inline void bd_strata_place_2d(uint32_t cell, uint32_t count, const uint32_t inside[2], uint32_t out[2]) {
    const uint64_t n = count == 0 ? 1 : count;
    const uint64_t place = cell % n;
    const uint64_t rows = bd_strata_rows(n);
    const uint64_t row = ((place + 1) * rows - 1) / n;
    const uint64_t first = row * n / rows;
    const uint64_t cells = (row + 1) * n / rows - first;
    const uint64_t x = ((place - first) << 32 | inside[0]) / cells;
    const uint64_t y = ((first << 32) + cells * inside[1]) / n;
    out[0] = (uint32_t)x;
    out[1] = (uint32_t)y;
}

/* ---- shift: one point set for the image, moved in every pixel by its mask value (Cranley and Patterson 1976) ---- */

/* Global: one component, modulo 1. */
static inline uint32_t bd_shift_global(uint32_t point_fx, uint32_t offset_fx) {
    return point_fx + offset_fx;
}

/* Stratified, 1D: (cell + frac(local + offset)) / count. */
static inline uint32_t bd_shift_stratified_1d(uint32_t cell, uint32_t count, uint32_t local, uint32_t offset) {
    return bd_strata_place_1d(cell, count, local + offset);
}

/* Stratified, 2D: any count, equal areas. */
static inline void bd_shift_stratified_2d(uint32_t cell, uint32_t count, const uint32_t local[2],
                                          const uint32_t offset[2], uint32_t out[2]) {
    const uint32_t inside[2] = {local[0] + offset[0], local[1] + offset[1]};
    bd_strata_place_2d(cell, count, inside, out);
}

/* ---- mask: square tiles of ranks, looked up toroidally ---- */

/* One number a pixel: ranks 0..4^size_log2 - 1, row by row. */
typedef struct {
    const uint16_t *ranks;
    uint32_t size_log2;
} bd_scalar_mask_t;

/* Two numbers a pixel, interleaved. */
typedef struct {
    const uint16_t *ranks;
    uint32_t size_log2;
} bd_vector_mask_t;

/* A mask for each of 2^frames_log2 frames. */
typedef struct {
    const uint16_t *ranks;
    uint32_t size_log2, frames_log2;
} bd_time_mask_t;

static inline uint32_t bd_mask_place(uint32_t size_log2, uint32_t x, uint32_t y) {
    const uint32_t size = UINT32_C(1) << size_log2;
    return bd_torus_wrap(y, size) << size_log2 | bd_torus_wrap(x, size);
}

/* The 0.32 value of a rank: the centre of its cell. */
static inline uint32_t bd_mask_value_fx(uint32_t rank, uint32_t size_log2) {
    return (2 * rank + 1) << (31 - 2 * size_log2);
}

/* The rank at a pixel. */
static inline uint16_t bd_scalar_rank(bd_scalar_mask_t mask, uint32_t x, uint32_t y) {
    return mask.ranks[bd_mask_place(mask.size_log2, x, y)];
}

/* The value at a pixel. */
static inline uint32_t bd_scalar_value_fx(bd_scalar_mask_t mask, uint32_t x, uint32_t y) {
    return bd_mask_value_fx(bd_scalar_rank(mask, x, y), mask.size_log2);
}

/* The value at a pixel, in (0, 1). */
static inline float bd_scalar_value(bd_scalar_mask_t mask, uint32_t x, uint32_t y) {
    return bd_unit_to_f32(bd_scalar_value_fx(mask, x, y));
}

/* The ranks at a pixel. */
static inline void bd_vector_rank(bd_vector_mask_t mask, uint32_t x, uint32_t y, uint16_t out[2]) {
    const uint32_t place = 2 * bd_mask_place(mask.size_log2, x, y);
    out[0] = mask.ranks[place];
    out[1] = mask.ranks[place + 1];
}

/* The values at a pixel. */
static inline void bd_vector_value_fx(bd_vector_mask_t mask, uint32_t x, uint32_t y, uint32_t out[2]) {
    uint16_t ranks[2];
    bd_vector_rank(mask, x, y, ranks);
    out[0] = bd_mask_value_fx(ranks[0], mask.size_log2);
    out[1] = bd_mask_value_fx(ranks[1], mask.size_log2);
}

/* The mask of a frame; after the last the first comes again. */
static inline bd_scalar_mask_t bd_time_mask_frame(bd_time_mask_t masks, uint32_t frame) {
    bd_scalar_mask_t mask;
    const uint32_t place = bd_torus_wrap(frame, UINT32_C(1) << masks.frames_log2);
    mask.ranks = masks.ranks + (place << 2 * masks.size_log2);
    mask.size_log2 = masks.size_log2;
    return mask;
}

/* ---- dither: halftoning by the thresholds of a mask, integers only ---- */

/* The threshold of a channel (0..3, then again) at a pixel; frames look the mask up elsewhere. Channel 0 of frame 0 is
 * bd_scalar_value_fx. */
static inline uint32_t bd_dither_threshold_fx(bd_scalar_mask_t mask, uint32_t x, uint32_t y, uint32_t channel,
                                              uint32_t frame) {
    uint32_t first[2], place[2];
    bd_torus_offset(0, 0, 0, 0, mask.size_log2, first);
    bd_torus_offset(0, channel % 4, 0, frame, mask.size_log2, place);
    return bd_scalar_value_fx(mask, x + place[0] - first[0], y + place[1] - first[1]);
}

/* The level, 0..levels-1, of `value` of 0..max: the upper of its two neighbours where its way between them exceeds the
 * threshold. A value that is a level stays. Fewer than two levels or a `max` of 0 give 0. */
static inline uint16_t bd_quantise_level(uint16_t value, uint16_t max, uint16_t levels, uint32_t threshold_fx) {
    uint32_t scaled, lower, rest;
    if (max == 0 || levels < 2) {
        return 0;
    }
    scaled = (uint32_t)(value < max ? value : max) * (uint32_t)(levels - 1);
    lower = scaled / max;
    rest = scaled % max;
    return (uint16_t)(lower + (rest > (uint32_t)((uint64_t)threshold_fx * max >> 32)));
}

/* A row of grey to 1 bit: eight pixels a byte, the leftmost in the highest bit, 1 is white; unused bits are 0. `bits`
 * has room for (width + 7) / 8 bytes. */
static inline void bd_dither_gray1_row(bd_scalar_mask_t mask, uint32_t y, uint32_t frame, const uint8_t *gray,
                                       uint32_t width, uint8_t *bits) {
    uint32_t first[2], place[2], x;
    bd_torus_offset(0, 0, 0, 0, mask.size_log2, first);
    bd_torus_offset(0, 0, 0, frame, mask.size_log2, place);
    for (x = 0; x < width; x++) {
        const uint32_t threshold = bd_scalar_value_fx(mask, x + place[0] - first[0], y + place[1] - first[1]);
        const uint32_t bit = bd_quantise_level(gray[x], 255, 2, threshold);
        bits[x / 8] = (uint8_t)((x % 8 == 0 ? 0 : bits[x / 8]) | bit << (7 - x % 8));
    }
}

/* ---- what all samplers share ---- */

/* A number for every pair of every domain. */
static inline uint32_t bd_domain_own(uint32_t domain, uint32_t pad) {
    return domain ^ pad * UINT32_C(0x5bd1e995);
}

/* The first `count` numbers of a domain at an index, by the points of its four pairs, two numbers each. */
#define BD_PADDED(sampler)                                                                                             \
    static inline void sampler##_numbers(const sampler##_pixel_t *pixel, uint32_t domain, uint32_t index,              \
                                         uint32_t count, uint32_t *out) {                                              \
        const uint32_t index_rev = bd_hash_reverse_bits(index);                                                        \
        uint32_t k, point[2];                                                                                          \
        for (k = 0; k < count; k += 2) {                                                                               \
            sampler##_point(pixel, domain, k / 2, index_rev, point);                                                   \
            out[k] = point[0];                                                                                         \
            if (k + 1 < count) {                                                                                       \
                out[k + 1] = point[1];                                                                                 \
            }                                                                                                          \
        }                                                                                                              \
    }

/* `n` numbers, two to eight. */
#define BD_DRAW(sampler, n)                                                                                            \
    static inline void sampler##_draw##n##_fx(const sampler##_pixel_t *pixel, uint32_t domain, uint32_t index,         \
                                              uint32_t out[n]) {                                                       \
        sampler##_numbers(pixel, domain, index, n, out);                                                               \
    }                                                                                                                  \
    static inline void sampler##_draw##n(const sampler##_pixel_t *pixel, uint32_t domain, uint32_t index,              \
                                         float out[n]) {                                                               \
        uint32_t fx[n], k;                                                                                             \
        sampler##_numbers(pixel, domain, index, n, fx);                                                                \
        for (k = 0; k < n; k++) {                                                                                      \
            out[k] = bd_unit_to_f32(fx[k]);                                                                            \
        }                                                                                                              \
    }

/* Sample `index` for purpose `domain`: one to eight numbers, `_fx` or in [0, 1). Numbers 2k and 2k+1 are an own pair. */
#define BD_CALL_SHAPE(sampler)                                                                                         \
    static inline uint32_t sampler##_draw1_fx(const sampler##_pixel_t *pixel, uint32_t domain, uint32_t index) {       \
        uint32_t number;                                                                                               \
        sampler##_numbers(pixel, domain, index, 1, &number);                                                           \
        return number;                                                                                                 \
    }                                                                                                                  \
    static inline float sampler##_draw1(const sampler##_pixel_t *pixel, uint32_t domain, uint32_t index) {             \
        return bd_unit_to_f32(sampler##_draw1_fx(pixel, domain, index));                                               \
    }                                                                                                                  \
    BD_DRAW(sampler, 2)                                                                                                \
    BD_DRAW(sampler, 3)                                                                                                \
    BD_DRAW(sampler, 4)                                                                                                \
    BD_DRAW(sampler, 5)                                                                                                \
    BD_DRAW(sampler, 6)                                                                                                \
    BD_DRAW(sampler, 7)                                                                                                \
    BD_DRAW(sampler, 8)

/* ---- sequence: the sequence of Keyed ---- */

@sequence@

/* Point `index_rev`, bit-reversed, of the sequence that all pixels share. */
static inline void bd_sequence_point_rev(uint32_t index_rev, uint32_t out[2]) {
    const uint32_t *low = bd_sequence_nibbles[0][index_rev >> 28];
    const uint32_t *high = bd_sequence_nibbles[1][index_rev >> 24 & 15];
    uint32_t rest = index_rev << 8, bit;
    out[0] = low[0] ^ high[0];
    out[1] = low[1] ^ high[1];
    for (bit = 0; rest != 0; rest <<= 1, bit++) {
        if (rest >> 31) {
            out[0] ^= bd_sequence_columns[bit][0];
            out[1] ^= bd_sequence_columns[bit][1];
        }
    }
}

/* ---- net: the columns of the joint net ---- */

@net@

/* Adds, modulo 2, the first `count` columns for the bits that are set, to the first `words` words of a sum. */
static inline void bd_net_add_columns(uint32_t sum[4], const uint32_t columns[][4], uint32_t count, uint32_t bits,
                                      uint32_t words) {
    uint32_t bit, k;
    for (bit = 0; bit < count; bit++) {
        const uint32_t mask = 0 - (bits >> bit & 1);
        for (k = 0; k < words; k++) {
            sum[k] ^= columns[bit][k] & mask;
        }
    }
}

/* ---- sampler: the joint net, recommended ---- */

/* `bits` of a sample's number stand below those of the frame: 16 if the number of samples is not known. */
typedef struct {
    const uint32_t (*columns)[4];
    uint32_t bits, seed;
} bd_sampler_t;

/* The seed is that of all frames of one sequence. */
typedef struct {
    const uint32_t (*columns)[4];
    uint64_t seed;
    uint32_t x, y, frame, bits;
} bd_sampler_pixel_t;

/* Progressive: every power of two is a good moment to stop. */
static inline bd_sampler_t bd_sampler_new(uint32_t seed) {
    bd_sampler_t sampler;
    sampler.columns = bd_net_orders[8];
    sampler.bits = 16;
    sampler.seed = seed;
    return sampler;
}

/* `spp` samples per pixel, a power of two up to 64, or 256 (0 counts as 1), bluer than by bd_sampler_new once all are
 * drawn; other numbers are drawn as by that. */
static inline bd_sampler_t bd_sampler_with_spp(uint32_t seed, uint32_t spp) {
    bd_sampler_t sampler = bd_sampler_new(seed);
    uint32_t k;
    spp = spp == 0 ? 1 : spp;
    for (k = 0; k < 8; k++) {
        const uint32_t bits = k == 7 ? 8 : k;
        if (spp == UINT32_C(1) << bits) {
            sampler.columns = bd_net_orders[k];
            sampler.bits = bits;
        }
    }
    return sampler;
}

/* The samples of one pixel in one frame. */
static inline bd_sampler_pixel_t bd_sampler_pixel(bd_sampler_t sampler, uint32_t x, uint32_t y, uint32_t frame) {
    const uint32_t own = sampler.bits == 16 ? 15 : 16 - sampler.bits;
    bd_sampler_pixel_t pixel;
    pixel.columns = sampler.columns;
    pixel.seed = bd_hash_mix_64((uint64_t)sampler.seed << 32 | frame >> own);
    pixel.x = x;
    pixel.y = y;
    pixel.frame = frame & ((UINT32_C(1) << own) - 1);
    pixel.bits = sampler.bits;
    return pixel;
}

/* An order of numbers of 16 bits: bits are added to lower ones at random. */
static inline uint32_t bd_sampler_ordered(uint32_t number, uint32_t hash) {
    const uint32_t other = hash * UINT32_C(0x85ebca77), third = hash * UINT32_C(0xc2b2ae3d);
    number ^= number >> 1 & hash;
    number ^= number >> 2 & hash >> 16;
    number ^= number >> 4 & other >> 16;
    number ^= number >> 8 & other >> 8;
    number ^= number >> 1 & third >> 16;
    number ^= number >> 2 & third >> 12;
    return number ^ (number >> 4 & third >> 8);
}

/* The first `count` numbers of a domain at an index. */
static inline void bd_sampler_numbers(const bd_sampler_pixel_t *pixel, uint32_t domain, uint32_t index, uint32_t count,
                                      uint32_t *out) {
    static const uint32_t odd[4] = {UINT32_C(0x9e3779b1), UINT32_C(0x85ebca77), UINT32_C(0xc2b2ae3d),
                                    UINT32_C(0x27d4eb2f)};
    const uint32_t words = (count + 1) / 2;
    const uint64_t key = bd_hash_mix_64(pixel->seed ^ domain * UINT64_C(0x9e3779b97f4a7c15));
    const uint32_t low = (uint32_t)key, high = (uint32_t)(key >> 32);
    /* Every domain lies elsewhere on the plane, on a curve of its own. */
    const uint32_t x = pixel->x + high, y = pixel->y + (high << 16 | high >> 16);
    const uint32_t place = bd_zorder_morton_16(x >> 2, y >> 2);
    const uint32_t curve = bd_hash_laine_karras_4(bd_hash_reverse_bits(place), low);
    /* Eight variants of a block of 4x4 pixels. */
    const uint32_t variant = curve * odd[0] >> 29, swapped = variant & 4;
    const uint32_t v = (swapped ? x : y) & 3, u = ((swapped ? y : x) & 3) ^ (variant >> 1 & v >> 1);
    const uint32_t inside = u | (v ^ (variant & u >> 1)) << 2;
    /* The digital shift of 32x32 pixels. */
    const uint32_t shift = bd_hash_mix((curve & UINT32_C(0x03ffffff)) ^ low);
    /* The pixel's order of samples; one of frames that 32x32 pixels have in common. */
    const uint32_t own = bd_hash_mix(x ^ (y << 16 | y >> 16) ^ high), bits = pixel->bits;
    const uint32_t ranks = bits == 16 ? 0 : (UINT32_C(1) << bits) - 1;
    const uint32_t frame = (bits == 16 ? 0 : pixel->frame) ^ index >> bits, later = frame >> (16 - bits);
    const uint32_t mask = (UINT32_C(1) << bits) - 1;
    const uint32_t upper = bd_sampler_ordered(frame & ((UINT32_C(1) << (16 - bits)) - 1), shift) << bits;
    const uint32_t number = ((bd_sampler_ordered((index & mask) | upper, own) & mask) ^ (own >> 8 & ranks)) | upper;
    uint32_t rest[4], sum[4], k;
    for (k = 0; k < 4; k++) {
        sum[k] = rest[k] = shift * odd[k] ^ high * odd[3 - k];
    }
    bd_net_add_columns(sum, pixel->columns, 16, number, words);
    bd_net_add_columns(sum, pixel->columns + 16, 4, inside, words);
    bd_net_add_columns(sum, pixel->columns + 20, 6, bd_hash_reverse_bits(curve), words);
    if (bits == 16) {
        bd_net_add_columns(sum, bd_net_frames, 15, bd_sampler_ordered(pixel->frame, shift), words);
    }
    /* After 2^16 samples another sequence begins. */
    if (later != 0) {
        const uint64_t next = bd_hash_mix_64(key ^ (uint64_t)later << 32);
        for (k = 0; k < 4; k++) {
            const uint32_t anew = (uint32_t)(next >> 32) * odd[k] ^ (uint32_t)next;
            sum[k] ^= anew;
            rest[k] ^= anew;
        }
    }
    for (k = 0; k < count; k++) {
        const uint32_t digits = sum[k / 2], below = rest[(k / 2) ^ 1];
        out[k] = k % 2 == 0 ? (digits & UINT32_C(0xffff0000)) | (below & 0xffff) : digits << 16 | below >> 16;
    }
}

BD_CALL_SHAPE(bd_sampler)

/* ---- keyed: scrambling keys of a tile (Heitz et al. 2019) ---- */

/* The upper 16 digits of two keys a pixel, the first in the upper half. */
typedef struct {
    const uint32_t *digits;
    uint32_t size_log2;
} bd_keys_t;

typedef struct {
    bd_keys_t keys;
    uint32_t seed;
} bd_keyed_t;

typedef struct {
    bd_keyed_t sampler;
    uint32_t x, y, frame;
} bd_keyed_pixel_t;

/* The keys of a pixel; the lower 16 digits are 0. */
static inline void bd_keys_key(bd_keys_t keys, uint32_t x, uint32_t y, uint32_t out[2]) {
    const uint32_t digits = keys.digits[bd_mask_place(keys.size_log2, x, y)];
    out[0] = digits & UINT32_C(0xffff0000);
    out[1] = digits << 16;
}

/* With a table of this header or your own. */
static inline bd_keyed_t bd_keyed_with_keys(bd_keys_t keys, uint32_t seed) {
    bd_keyed_t sampler;
    sampler.keys = keys;
    sampler.seed = seed;
    return sampler;
}

static inline bd_keyed_pixel_t bd_keyed_pixel(bd_keyed_t sampler, uint32_t x, uint32_t y, uint32_t frame) {
    bd_keyed_pixel_t pixel;
    pixel.sampler = sampler;
    pixel.x = x;
    pixel.y = y;
    pixel.frame = frame;
    return pixel;
}

static inline void bd_keyed_point(const bd_keyed_pixel_t *pixel, uint32_t domain, uint32_t pad, uint32_t index_rev,
                                  uint32_t out[2]) {
    const bd_keyed_t sampler = pixel->sampler;
    const uint32_t seed =
        bd_hash_combine(bd_hash_combine(sampler.seed, bd_domain_own(domain, pad)), pixel->frame);
    uint32_t place[2], key[2], order;
    bd_torus_offset(sampler.seed, domain, pad, pixel->frame, sampler.keys.size_log2, place);
    bd_keys_key(sampler.keys, pixel->x + place[0], pixel->y + place[1], key);
    order = ((key[0] | key[1] >> 16) ^ seed) * UINT32_C(0x9e3779b1);
    order ^= order >> 15; /* the pixel's own; the lower digits are as random */
    bd_sequence_point_rev(bd_hash_shuffle_rev(index_rev, order), out);
    out[0] ^= key[0] | order >> 16;
    out[1] ^= key[1] | (order & 0xffff);
}

BD_PADDED(bd_keyed)
BD_CALL_SHAPE(bd_keyed)

/* ---- white: Owen-scrambled points, a seed for every pixel; for comparison ---- */

typedef struct {
    uint32_t seed;
} bd_white_t;

typedef struct {
    uint32_t seed;
} bd_white_pixel_t;

static inline bd_white_t bd_white_new(uint32_t seed) {
    bd_white_t sampler;
    sampler.seed = seed;
    return sampler;
}

/* The same: the number of samples makes no difference. */
static inline bd_white_t bd_white_with_spp(uint32_t seed, uint32_t spp) {
    (void)spp;
    return bd_white_new(seed);
}

static inline bd_white_pixel_t bd_white_pixel(bd_white_t sampler, uint32_t x, uint32_t y, uint32_t frame) {
    const uint32_t row = bd_hash_combine(bd_hash_combine(sampler.seed, frame), y);
    bd_white_pixel_t pixel;
    pixel.seed = bd_hash_combine(row, bd_hash_mix(x));
    return pixel;
}

static inline void bd_white_point(const bd_white_pixel_t *pixel, uint32_t domain, uint32_t pad, uint32_t index_rev,
                                  uint32_t out[2]) {
    const uint32_t seed = bd_hash_combine(pixel->seed, bd_domain_own(domain, pad));
    bd_sobol_owen_point(bd_hash_reverse_bits(bd_hash_shuffle_rev(index_rev, seed)), seed, out);
}

BD_PADDED(bd_white)
BD_CALL_SHAPE(bd_white)

/* ---- tables ---- */

@tables@
#undef BD_CALL_SHAPE
#undef BD_DRAW
#undef BD_PADDED

#endif /* BLUEDITHER_H */
