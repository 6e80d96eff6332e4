/* Evaluates functions of bluedither.h for src/c_checks.rs: `check NAME FILE` reads eight words a call from FILE and
 * writes four a call to standard output. */
#include "checks.h"

#include <stdio.h>
#include <string.h>

int main(int count, char **arguments) {
    const check_t *lists[] = {checks_of_functions, checks_of_samplers};
    FILE *calls = count == 3 ? fopen(arguments[2], "rb") : NULL;
    unsigned k;
    if (calls == NULL) {
        return 2;
    }
    for (k = 0; k < 2; k++) {
        const check_t *check;
        for (check = lists[k]; check->name != NULL; check++) {
            if (strcmp(check->name, arguments[1]) == 0) {
                uint32_t a[8], r[4];
                while (fread(a, sizeof(a), 1, calls) == 1) {
                    memset(r, 0, sizeof(r));
                    check->call(a, r);
                    if (fwrite(r, sizeof(r), 1, stdout) != 1) {
                        return 3;
                    }
                }
                return fclose(calls) == 0 && fflush(stdout) == 0 ? 0 : 3;
            }
        }
    }
    fprintf(stderr, "no check is named %s\n", arguments[1]);
    return 2;
}
