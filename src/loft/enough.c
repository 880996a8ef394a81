/* The least bound with which a hull can be lofted, where the one that was asked for is too small. */
#include "loft/lines/line.h"
#include "loft/report.h"

#include <batten/text.h>

#include <stdio.h>

/* Six doublings reach 64 times the bound; three halvings of the last doubling, by ratio, leave it
 * known to a tenth. */
enum { DOUBLINGS = 6, HALVINGS = 3, MOST_NAMED = 5 };

typedef struct {
    const batten_offset_table *table;
    const batten_loft_options *options;
    const batten_job *job;
    double enough;    /* 0: none yet */
    double widest;    /* of the bounds that were judged; not of those with which lines cross */
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

/* What ends a search; any other failure is of the bound alone, as when lines cross that have so much room. */
static bool ends_search(batten_status status)
{
    return status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED ||
           status == BATTEN_INCOMPLETE;
}

static batten_status try_bound(search *s, double within, bool *does)
{
    batten_loft_options wider = *s->options;
    bat_hull_panels panels;
    wider.within = within;
    batten_status status = bat_hull_panels_make(s->table, &wider, s->job, &panels);
    if (status == BATTEN_OK)
        status = bat_hull_panels_fit(&panels);
    *does = status == BATTEN_OK;
    if (status == BATTEN_OK) {
        s->enough = within;
        name_points(&panels, s);
    } else if (status == BATTEN_NOT_COMPATIBLE && s->enough == 0) {
        s->widest = bat_max(s->widest, within);
        if (!s->points[0])
            name_farthest(&panels, s);
    }
    bat_hull_panels_free(&panels);
    return ends_search(status) ? status : BATTEN_OK;
}

static batten_status find_least(search *s)
{
    double low = s->options->within, high = low;
    batten_status status = BATTEN_OK;
    bool does = false;
    for (int k = 0; k < DOUBLINGS && !does && status == BATTEN_OK; k++) {
        low = high;
        high = 2 * low;
        status = try_bound(s, high, &does);
    }
    const int halvings = does ? HALVINGS : 0;
    for (int k = 0; k < halvings && status == BATTEN_OK; k++) {
        const double middle = sqrt(low * high);
        status = try_bound(s, middle, &does);
        *(does ? &high : &low) = middle;
    }
    return status;
}

static batten_status refuse_all(const search *s)
{
    const bool one = s->options->knuckle_count == 0;
    char wider[40] = "";
    if (s->widest > s->options->within)
        batten_text_print(wider, sizeof wider, ", nor within %g", s->widest);
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "no smooth %s found within %g of every point of the table%s: it may have "
                    "a%s knuckle, or a point may be wrong%s%s",
                    one ? "surface was" : "panels were", s->options->within, wider,
                    one ? "" : "nother", s->points[0] ? "; the farthest off: " : "", s->points);
}

batten_status bat_loft_find_enough(const batten_offset_table *table,
                                   const batten_loft_options *options, const batten_job *job,
                                   double *enough)
{
    search s = {.table = table, .options = options, .job = job};
    const batten_status status = find_least(&s);
    *enough = s.enough;
    if (status != BATTEN_OK)
        return status;
    if (s.enough == 0)
        return refuse_all(&s);
    const bool one = options->knuckle_count == 0;
    char least[24];
    bat_loft_say_bound(s.enough, sizeof least, least);
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "no smooth %s found within %g of every point of the table; %s within %s%s%s",
                    one ? "surface was" : "panels were", options->within,
                    one ? "one was" : "some were", least,
                    s.points[0] ? ", held there by " : "", s.points);
}
