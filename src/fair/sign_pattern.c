/* Which signs a sequence of curvatures is to have. */
#include "fair/sign_pattern.h"

batten_status bat_sign_pattern(int count, const double *curvature, int changes, int *signs)
{
    const size_t states = 2 * ((size_t)changes + 1);
    double *cost = bat_array3(2, states, sizeof *cost);
    unsigned char *turned = bat_array3((size_t)count, states, 1);
    if (!cost || !turned) {
        bat_release(cost);
        bat_release(turned);
        return BATTEN_OUT_OF_MEMORY;
    }
    /* State 2 k + q: k changes so far, sign +1 (q = 0) or -1. */
    for (int i = 0; i < count; i++) {
        const double *before = cost + (size_t)((i + 1) % 2) * states;
        double *now = cost + (size_t)(i % 2) * states;
        for (size_t s = 0; s < states; s++) {
            const double wrong = bat_max(s % 2 == 0 ? -curvature[i] : curvature[i], 0);
            const double stay = i == 0 ? (s < 2 ? 0 : HUGE_VAL) : before[s];
            const double turn = i == 0 || s < 2 ? HUGE_VAL : before[(s - 2) ^ 1];
            turned[(size_t)i * states + s] = turn < stay;
            now[s] = bat_min(stay, turn) + wrong;
        }
    }
    const double *last = cost + (size_t)((count - 1) % 2) * states;
    size_t s = 0;
    for (size_t k = 1; k < states; k++)
        s = last[k] < last[s] ? k : s;
    for (int i = count - 1; i >= 0; i--) {
        signs[i] = s % 2 == 0 ? 1 : -1;
        if (turned[(size_t)i * states + s])
            s = (s - 2) ^ 1;
    }
    bat_release(cost);
    bat_release(turned);
    return BATTEN_OK;
}
