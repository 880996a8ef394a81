/* A stem or sternpost in one plane of the table: it runs upwards without turning back. */
#include "loft/outline.h"

/* So many samples in a span, and this part of the mean slope at each: the cubic between them does not fall. */
enum { SAMPLES_OF_SPAN = 4 };
static const double least_slope = 0.05;

/* x and y of all control points of an edge are held on the centre plane; where z is held too nothing can turn. */
static bool is_stem(const bat_loft *loft, int i)
{
    const int nv = loft->patch.nv;
    bool free = false;
    for (int j = 0; j < nv; j++) {
        const size_t at = 3 * ((size_t)i * (size_t)nv + (size_t)j);
        const double *p = loft->patch.points + at;
        if (!loft->held[at] || !loft->held[at + 1] || p[1] != 0)
            return false;
        free = free || !loft->held[at + 2];
    }
    return free;
}

/* The stem's height in the points given: from the lowest of its points to the highest; 0: fewer than two. */
static double height_of(const bat_loft *loft, double u)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int k = 0; k < loft->datum_count; k++)
        if (loft->data[k].on_u_edge && loft->data[k].u == u) {
            low = bat_min(low, loft->data[k].point[2]);
            high = bat_max(high, loft->data[k].point[2]);
        }
    return bat_max(high - low, 0);
}

static batten_status add_rises(const bat_loft *loft, double u, double least,
                               bat_loft_program *p)
{
    const bat_loft_measure measure = {.weight[0][1] = 1, .vector = {0, 0, -1}};
    const double *knots = loft->patch.v_knots;
    batten_status status = BATTEN_OK;
    for (int span = BAT_LOFT_DEGREE; span < loft->patch.nv; span++)
        for (int k = 0; k <= SAMPLES_OF_SPAN && status == BATTEN_OK; k++) {
            bat_loft_place place;
            const double share = (double)k / SAMPLES_OF_SPAN;
            bat_loft_place_at(&loft->patch, u,
                              (1 - share) * knots[span] + share * knots[span + 1], &place);
            status = bat_loft_add_row(p, &place, &measure, place.s[0][1][2] - least, HUGE_VAL);
        }
    return status;
}

batten_status bat_loft_add_stems(const bat_loft *loft, bat_loft_program *program)
{
    batten_status status = BATTEN_OK;
    for (int fore = 0; fore <= 1 && status == BATTEN_OK; fore++) {
        const double height = height_of(loft, fore);
        if (height > 0 && is_stem(loft, fore ? loft->patch.nu - 1 : 0))
            status = add_rises(loft, fore, least_slope * height, program);
    }
    return status;
}
