/* Every draw of every sampler: seed, samples, x, y, frame, domain, index from `a`. */
#include "checks.h"

#include <stddef.h>

/* Fixed point, and floats by their bits. */
#define SAMPLER(name, make)                                                                                            \
    static void name##_draw1(const uint32_t a[8], uint32_t r[4]) {                                                     \
        bd_##name##_pixel_t pixel = bd_##name##_pixel(make, a[2], a[3], a[4]);                                         \
        r[0] = bd_##name##_draw1_fx(&pixel, a[5], a[6]);                                                               \
        r[1] = bits(bd_##name##_draw1(&pixel, a[5], a[6]));                                                            \
    }                                                                                                                  \
    static void name##_draw2(const uint32_t a[8], uint32_t r[4]) {                                                     \
        bd_##name##_pixel_t pixel = bd_##name##_pixel(make, a[2], a[3], a[4]);                                         \
        float floats[2];                                                                                               \
        bd_##name##_draw2_fx(&pixel, a[5], a[6], r);                                                                   \
        bd_##name##_draw2(&pixel, a[5], a[6], floats);                                                                 \
        r[2] = bits(floats[0]);                                                                                        \
        r[3] = bits(floats[1]);                                                                                        \
    }                                                                                                                  \
    static void name##_draw3(const uint32_t a[8], uint32_t r[4]) {                                                     \
        bd_##name##_pixel_t pixel = bd_##name##_pixel(make, a[2], a[3], a[4]);                                         \
        uint32_t fx[3];                                                                                                \
        float floats[3];                                                                                               \
        bd_##name##_draw3_fx(&pixel, a[5], a[6], fx);                                                                  \
        bd_##name##_draw3(&pixel, a[5], a[6], floats);                                                                 \
        r[0] = fx[0] ^ bits(floats[0]);                                                                                \
        r[1] = fx[1] ^ bits(floats[1]);                                                                                \
        r[2] = fx[2] ^ bits(floats[2]);                                                                                \
    }                                                                                                                  \
    static void name##_draw4(const uint32_t a[8], uint32_t r[4]) {                                                     \
        bd_##name##_pixel_t pixel = bd_##name##_pixel(make, a[2], a[3], a[4]);                                         \
        float floats[4];                                                                                               \
        bd_##name##_draw4_fx(&pixel, a[5], a[6], r);                                                                   \
        bd_##name##_draw4(&pixel, a[5], a[6], floats);                                                                 \
        r[0] ^= bits(floats[0]);                                                                                       \
        r[1] ^= bits(floats[1]);                                                                                       \
        r[2] ^= bits(floats[2]);                                                                                       \
        r[3] ^= bits(floats[3]);                                                                                       \
    }

SAMPLER(sampler, (a[7] & 1) ? bd_sampler_new(a[0]) : bd_sampler_with_spp(a[0], a[1]))
SAMPLER(z_order, (a[7] & 1) ? bd_z_order_new(a[0]) : bd_z_order_with_spp(a[0], a[1]))
SAMPLER(white, (a[7] & 1) ? bd_white_new(a[0]) : bd_white_with_spp(a[0], a[1]))
SAMPLER(keyed, bd_keyed_with_keys((a[7] & 1) ? bd_keys_64 : bd_keys_64_spp_4, a[0]))

#define ENTRIES(name)                                                                                                  \
    {#name "_draw1", name##_draw1}, {#name "_draw2", name##_draw2}, {#name "_draw3", name##_draw3},                    \
        {#name "_draw4", name##_draw4}
const check_t checks_of_samplers[] = {
    ENTRIES(sampler), ENTRIES(z_order), ENTRIES(white), ENTRIES(keyed), {NULL, NULL},
};
