/* How far a surface leaves the box of the data: where there are no data it may swing. */
#include "shape/cloud/scattered.h"

#include <string.h>

enum { MOST_PLACES = 257 };

static void box_of(const bat_scatter *s, double low[3], double high[3])
{
    const size_t d = (size_t)s->dimension;
    for (size_t c = 0; c < d; c++) {
        low[c] = HUGE_VAL;
        high[c] = -HUGE_VAL;
        for (size_t t = 0; t < s->count; t++) {
            low[c] = bat_min(low[c], s->values[t * d + c] - s->centre[c]);
            high[c] = bat_max(high[c], s->values[t * d + c] - s->centre[c]);
        }
    }
}

/* The sides by which distances are measured: a flat box counts as having some height, lest the
 * noise of a plane be news. */
static void sides_of(int d, const double low[3], const double high[3], double sides[3])
{
    double longest = 0;
    for (int c = 0; c < d; c++)
        longest = bat_max(longest, high[c] - low[c]);
    for (int c = 0; c < d; c++)
        sides[c] = bat_max(high[c] - low[c], longest / 10);
}

static void find_outside(bat_scatter *s, const double *grid, const size_t counts[2],
                         const double *const places[2])
{
    const int d = s->dimension;
    batten_surface_fit_report *r = &s->report;
    double low[3], high[3], sides[3];
    box_of(s, low, high);
    sides_of(d, low, high, sides);
    for (size_t i = 0; i < counts[0] * counts[1]; i++)
        for (int c = 0; c < d; c++) {
            const double *at = grid + i * (size_t)d;
            const double by = bat_max(low[c] - at[c], at[c] - high[c]);
            if (!(by > 0 && by > r->outside_share * sides[c]))
                continue;
            r->outside = by;
            r->outside_share = by / sides[c];
            const double uv[2] = {places[0][i / counts[1]], places[1][i % counts[1]]};
            for (int k = 0; k < 2; k++)
                r->outside_at[k] = s->origin[k] + s->length * uv[k];
            for (int k = 0; k < d; k++)
                r->outside_at[d == 1 ? 2 : k] = s->centre[k] + at[k];
        }
}

/* Some places in every span, as long as they are not too many. */
batten_status bat_scatter_outside(bat_scatter *s)
{
    const size_t d = (size_t)s->dimension;
    size_t counts[2];
    double *places[2] = {NULL, NULL};
    batten_surface *surface = NULL;
    for (int k = 0; k < 2; k++) {
        counts[k] = (size_t)bat_min_int(MOST_PLACES, 4 * s->axis[k].count + 1);
        places[k] = bat_array(counts[k], sizeof *places[k]);
        for (size_t i = 0; places[k] && i < counts[k]; i++)
            places[k][i] = s->side[k] * ((double)i / (double)(counts[k] - 1));
    }
    double *grid = bat_array3(counts[0], counts[1], d * sizeof *grid);
    batten_status status = grid && places[0] && places[1] ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_scatter_net(s, &surface);
    if (status == BATTEN_OK)
        status = batten_surface_evaluate_grid(
            surface, (batten_uv_grid){counts[0], counts[1], places[0], places[1]}, 0, NULL,
            grid);
    s->report.outside = s->report.outside_share = 0;
    memset(s->report.outside_at, 0, sizeof s->report.outside_at);
    if (status == BATTEN_OK)
        find_outside(s, grid, counts, (const double *const *)places);
    batten_surface_unref(surface);
    bat_release(grid);
    bat_release(places[1]);
    bat_release(places[0]);
    return status;
}
