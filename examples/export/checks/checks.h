/* What the translation units of the checks share; each includes the header by itself. */
#include "bluedither.h"

typedef struct {
    const char *name;
    void (*call)(const uint32_t a[8], uint32_t r[4]);
} check_t;

extern const check_t checks_of_functions[];
extern const check_t checks_of_samplers[];

/* The bits of a float. */
static inline uint32_t bits(float value) {
    union {
        float value;
        uint32_t bits;
    } both;
    both.value = value;
    return both.bits;
}
