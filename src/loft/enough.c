/* The least bound with which a hull can be lofted, where the one that was asked for is too small. */
#include "loft/report.h"

#include <stdio.h>

/* Six doublings reach 64 times the bound; three halvings of the last doubling, by ratio, leave it
 * known to a tenth. */
enum { DOUBLINGS = 6, HALVINGS = 3, MOST_NAMED = 5 };

typedef struct {
    const batten_offset_table *table;
    const batten_loft_options *options;
    const batten_job *job;
    double enough;    /* 0: none yet */
    char points[600]; /* those that hold it there; while none does, the farthest off */
} search;

/* "point 5 of station 3 (x = 2), ..." */
static void name_points(const bat_hull_panels *panels, search *s)
{
    size_t used = 0;
    int named = 0;
    s->points[0] = 0;
    for (int p = 0; p < panels->count; p++)
        for (int k = 0; k < panels->at[p].datum_count && named < MOST_NAMED; k++) {
            const bat_loft_datum *d = panels->at[p].data + k;
            if (!bat_loft_holds(panels, panels->at + p, d) || used >= sizeof s->points)
                continue;
            used += (size_t)snprintf(s->points + used, sizeof s->points - used,
                                     "%spoint %d of %s", named++ ? ", " : "", d->index + 1,
                                     batten_offset_table_label(s->table, d->station).text);
        }
}

/* The data beyond the first bound that was tried, the farthest first. */
static void name_farthest(const bat_hull_panels *panels, search *s)
{
    double before = HUGE_VAL;
    size_t used = 0;
    s->points[0] = 0;
    for (int named = 0; named < MOST_NAMED && used < sizeof s->points; named++) {
        const bat_loft_datum *worst = NULL;
        for (int p = 0; p < panels->count && panels->at; p++)
            for (int k = 0; k < panels->at[p].datum_count; k++) {
                const bat_loft_datum *d = panels->at[p].data + k;
                if (d->move > d->within && d->move < before &&
                    (!worst || d->move > worst->move))
                    worst = d;
            }
        if (!worst)
            return;
        before = worst->move;
        used += (size_t)snprintf(s->points + used, sizeof s->points - used, "%spoint %d of %s",
                                 named ? ", " : "", worst->index + 1,
                                 batten_offset_table_label(s->table, worst->station).text);
    }
}

/* Does this bound do? NOT_COMPATIBLE: it does not. */
static batten_status try_bound(search *s, double within)
{
    batten_loft_options wider = *s->options;
    bat_hull_panels panels;
    wider.within = within;
    batten_status status = bat_hull_panels_make(s->table, &wider, s->job, &panels);
    if (status == BATTEN_OK)
        status = bat_hull_panels_fit(&panels);
    if (status == BATTEN_OK) {
        s->enough = within;
        name_points(&panels, s);
    } else if (status == BATTEN_NOT_COMPATIBLE && s->enough == 0 && !s->points[0]) {
        name_farthest(&panels, s);
    }
    bat_hull_panels_free(&panels);
    return status;
}

static batten_status find_least(search *s)
{
    double low = s->options->within, high = low;
    batten_status status = BATTEN_NOT_COMPATIBLE;
    for (int k = 0; k < DOUBLINGS && status == BATTEN_NOT_COMPATIBLE; k++) {
        low = high;
        high = 2 * low;
        status = try_bound(s, high);
    }
    for (int k = 0; k < HALVINGS && status == BATTEN_OK; k++) {
        const double middle = sqrt(low * high);
        status = try_bound(s, middle);
        if (status == BATTEN_NOT_COMPATIBLE) {
            low = middle;
            status = BATTEN_OK;
        } else {
            high = middle;
        }
    }
    return status;
}

batten_status bat_loft_find_enough(const batten_offset_table *table,
                                   const batten_loft_options *options, const batten_job *job,
                                   double *enough)
{
    search s = {.table = table, .options = options, .job = job};
    const batten_status status = find_least(&s);
    *enough = s.enough;
    if (status != BATTEN_OK && status != BATTEN_NOT_COMPATIBLE)
        return status;
    const bool one = options->knuckle_count == 0;
    const char *none = one ? "no smooth surface was" : "no smooth panels were";
    if (s.enough > 0)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "%s found within %g of every point of the table; %s within %.4g%s%s",
                        none, options->within, one ? "one was" : "some were", s.enough,
                        s.points[0] ? ", held there by " : "", s.points);
    return bat_fail(
        BATTEN_NOT_COMPATIBLE,
        "%s found within %g of every point of the table, nor within %g: it may have "
        "a%s knuckle, or a point may be wrong%s%s",
        none, options->within, options->within * (1 << DOUBLINGS), one ? "" : "nother",
        s.points[0] ? "; the farthest off: " : "", s.points);
}
