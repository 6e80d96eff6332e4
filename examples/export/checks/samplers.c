/* Every draw of every sampler: seed, samples, x, y, frame, domain, index from `a`. */
#include "checks.h"

#include <stddef.h>

/* Fixed point, and floats by their bits; of more than two numbers, what they come to. */
#define DRAW(name, make, n)                                                                                            \
    static void name##_draw##n(const uint32_t a[8], uint32_t r[4]) {                                                   \
        bd_##name##_pixel_t pixel = bd_##name##_pixel(make, a[2], a[3], a[4]);                                         \
        uint32_t fx[n], k;                                                                                             \
        float floats[n];                                                                                               \
        bd_##name##_draw##n##_fx(&pixel, a[5], a[6], fx);                                                              \
        bd_##name##_draw##n(&pixel, a[5], a[6], floats);                                                               \
        for (k = 0; k < n; k++) {                                                                                      \
            r[k % 4] = bd_hash_combine(r[k % 4] + fx[k], bits(floats[k]));                                             \
        }                                                                                                              \
    }
#define SAMPLER(name, make)                                                                                            \
    static void name##_draw1(const uint32_t a[8], uint32_t r[4]) {                                                     \
        bd_##name##_pixel_t pixel = bd_##name##_pixel(make, a[2], a[3], a[4]);                                         \
        r[0] = bd_##name##_draw1_fx(&pixel, a[5], a[6]);                                                               \
        r[1] = bits(bd_##name##_draw1(&pixel, a[5], a[6]));                                                            \
    }                                                                                                                  \
    DRAW(name, make, 2)                                                                                                \
    DRAW(name, make, 3)                                                                                                \
    DRAW(name, make, 4)                                                                                                \
    DRAW(name, make, 5)                                                                                                \
    DRAW(name, make, 6)                                                                                                \
    DRAW(name, make, 7)                                                                                                \
    DRAW(name, make, 8)

SAMPLER(sampler, (a[7] & 1) ? bd_sampler_new(a[0]) : bd_sampler_with_spp(a[0], a[1]))
SAMPLER(white, (a[7] & 1) ? bd_white_new(a[0]) : bd_white_with_spp(a[0], a[1]))
SAMPLER(keyed, bd_keyed_with_keys(bd_keys_64, a[0]))

#define ENTRIES(name)                                                                                                  \
    {#name "_draw1", name##_draw1}, {#name "_draw2", name##_draw2}, {#name "_draw3", name##_draw3},                    \
        {#name "_draw4", name##_draw4}, {#name "_draw5", name##_draw5}, {#name "_draw6", name##_draw6},                \
        {#name "_draw7", name##_draw7}, {#name "_draw8", name##_draw8}
const check_t checks_of_samplers[] = {
    ENTRIES(sampler), ENTRIES(white), ENTRIES(keyed), {NULL, NULL},
};
