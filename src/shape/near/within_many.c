/*
 * Curves within a tolerance of very many data, in a number of fits that does not grow with them: knots come by samples
 * of the data, each as large as its knots need, and go in many regions by one fit. A B-spline is local, so that what
 * happens in one region says nothing about those beyond its neighbours.
 */
#include "shape/near/within_many.h"
#include "numeric/vector.h"

#include <string.h>

/* ---- knots that come ---- */

/* A sample has so many data, or so many for each knot: spans in a sample can be halved three times before their data
 * are too few. */
enum { LEAST_SAMPLE = 5000, DATA_OF_KNOT = 32 };

typedef struct {
    bat_within work;
    double *points, *parameters;
} data_sample;

static void end_sample(data_sample *s)
{
    bat_release(s->points);
    bat_release(s->parameters);
}

/* Of a sample of `count`, evenly by their numbers, with both ends; a ring has its first datum only. */
static size_t datum_of(const bat_within *w, int count, int i)
{
    const int steps = w->periodic ? count : count - 1,
              all = w->periodic ? w->count : w->count - 1;
    return (size_t)((int64_t)i * all / steps);
}

static batten_status begin_sample(const bat_within *w, int count, data_sample *s)
{
    const size_t d = (size_t)w->dimension;
    s->work = *w;
    s->points = bat_array3((size_t)count, d, sizeof *s->points);
    s->parameters = bat_array((size_t)count + 1, sizeof *s->parameters);
    if (!s->points || !s->parameters)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++) {
        const size_t from = datum_of(w, count, i);
        memcpy(s->points + (size_t)i * d, w->points + from * d, d * sizeof *s->points);
        s->parameters[i] = w->start[from];
    }
    if (w->periodic)
        s->parameters[count] = w->start[w->count];
    s->work.count = count;
    s->work.points = s->points;
    s->work.start = s->work.parameters = s->parameters;
    s->work.bows = NULL;
    return BATTEN_OK;
}

/* One fit of a sample; *t takes its new knots, if there are any. */
static batten_status refine_by_sample(bat_within *w, int count, bat_trial *t, bool *grown)
{
    data_sample s = {.points = NULL};
    bat_trial fitted = {0}, next = {0};
    batten_status status = begin_sample(w, count, &s);
    if (status == BATTEN_OK)
        status = bat_trial_begin(t->count, &fitted);
    if (status == BATTEN_OK) {
        memcpy(fitted.inner, t->inner, (size_t)t->count * sizeof *t->inner);
        status = bat_trial_fit(&s.work, &fitted);
    }
    w->fits = s.work.fits;
    if (status == BATTEN_OK && fitted.curve && fitted.max > w->tolerance)
        status = bat_trial_refine(&s.work, &fitted, &next);
    *grown = status == BATTEN_OK && next.count > t->count;
    if (*grown) {
        bat_trial_end(t);
        *t = next;
    } else {
        bat_trial_end(&next);
    }
    bat_trial_end(&fitted);
    end_sample(&s);
    return status;
}

batten_status bat_within_first_knots(bat_within *w, bat_trial *t)
{
    batten_status status = BATTEN_OK;
    double least = LEAST_SAMPLE;
    while (status == BATTEN_OK) {
        const double wanted = bat_max(least, DATA_OF_KNOT * (t->count + 1.0));
        bool grown = false;
        if (wanted > w->count / 2.0)
            return BATTEN_OK;
        status = refine_by_sample(w, (int)wanted, t, &grown);
        if (!grown)
            least = 4 * wanted;
    }
    return status;
}

/* ---- knots that go ---- */

/* Knots of a region: more than a change reaches, and few enough to be tried by halves in some dozen fits. */
enum { REGION = 48, MOST_HALVINGS = 8, MOST_REPAIRS = 3 };

typedef struct {
    int from, to; /* of `order` */
} ranked_block;

typedef struct {
    int depth;
    ranked_block waiting[MOST_HALVINGS];
    ranked_block tried; /* empty: none */
    bool is_off;        /* in the last fit */
} knot_region;

typedef struct {
    bat_within *work;
    const bat_trial *whole; /* all knots */
    int region_count;
    knot_region *regions;
    int *order;       /* ranked knots, region by region */
    bool *gone, *let; /* [whole->count] in the next fit; in `best` */
    bat_trial best;   /* no curve: `whole` */
} thinning;

static int region_of(const thinning *t, int knot)
{
    return bat_min_int(knot / REGION, t->region_count - 1);
}

/* From the order of all to that of each region. */
static batten_status deal_out(thinning *t, int count, const int *ranked)
{
    int *next = bat_array((size_t)t->region_count + 1, sizeof *next);
    if (!next)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++)
        next[region_of(t, ranked[i]) + 1]++;
    for (int r = 0; r < t->region_count; r++)
        next[r + 1] += next[r];
    for (int r = 0; r < t->region_count; r++) {
        t->regions[r].waiting[0] = (ranked_block){next[r], next[r + 1]};
        t->regions[r].depth = next[r + 1] > next[r];
    }
    for (int i = 0; i < count; i++)
        t->order[next[region_of(t, ranked[i])]++] = ranked[i];
    bat_release(next);
    return BATTEN_OK;
}

static void mark_gone(thinning *t, ranked_block b, bool gone)
{
    for (int i = b.from; i < b.to; i++)
        t->gone[t->order[i]] = gone;
}

/* A block of every other region; false when none waits there. */
static bool take_blocks(thinning *t, int parity)
{
    bool any = false;
    for (int r = 0; r < t->region_count; r++) {
        knot_region *region = &t->regions[r];
        region->tried = (ranked_block){0, 0};
        if (r % 2 != parity || region->depth == 0)
            continue;
        region->tried = region->waiting[--region->depth];
        mark_gone(t, region->tried, true);
        any = true;
    }
    return any;
}

/* The knots that stay, fitted. */
static batten_status fit_rest(thinning *t, bat_trial *out)
{
    const bat_trial *all = t->whole;
    int gone = 0;
    for (int i = 0; i < all->count; i++)
        gone += t->gone[i];
    batten_status status = bat_trial_begin(all->count - gone, out);
    for (int i = 0, k = 0; status == BATTEN_OK && i < all->count; i++)
        if (!t->gone[i])
            out->inner[k++] = all->inner[i];
    return status == BATTEN_OK ? bat_trial_fit(t->work, out) : status;
}

/* Which regions have a datum that is too far off, or whose neighbours have. */
static void find_off(thinning *t, const bat_trial *fitted)
{
    const int count = t->region_count;
    for (int r = 0; r < count; r++)
        t->regions[r].is_off = !fitted->curve;
    for (int i = 0, r = 0; fitted->curve && i < fitted->data_count; i++) {
        while (r + 1 < count && fitted->parameters[i] >= t->whole->inner[(r + 1) * REGION])
            r++;
        t->regions[r].is_off =
            t->regions[r].is_off || !(fitted->distances[i] <= t->work->tolerance);
    }
}

static bool is_off_about(const thinning *t, int r)
{
    const int n = t->region_count,
              before = r > 0               ? r - 1
                       : t->work->periodic ? n - 1
                                           : r,
              after = r + 1 < n           ? r + 1
                      : t->work->periodic ? 0
                                          : r;
    return t->regions[r].is_off || t->regions[before].is_off || t->regions[after].is_off;
}

static void keep_best(thinning *t, bat_trial *fitted)
{
    bat_trial_end(&t->best);
    t->best = *fitted;
    *fitted = (bat_trial){0};
    memcpy(t->let, t->gone, (size_t)t->whole->count * sizeof *t->let);
}

/* Blocks that cannot go come back, and wait as halves. */
static void judge_blocks(thinning *t, const bat_trial *fitted)
{
    find_off(t, fitted);
    for (int r = 0; r < t->region_count; r++) {
        knot_region *region = &t->regions[r];
        const ranked_block b = region->tried;
        const int middle = b.from + (b.to - b.from) / 2;
        if (b.to == b.from || !is_off_about(t, r))
            continue;
        mark_gone(t, b, false);
        if (middle > b.from) {
            region->waiting[region->depth++] = (ranked_block){middle, b.to};
            region->waiting[region->depth++] = (ranked_block){b.from, middle};
        }
    }
}

/* Where knots that went together are missed, all that went since the best curve come back. */
static batten_status repair(thinning *t)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < MOST_REPAIRS; i++) {
        bat_trial fitted = {0};
        if (memcmp(t->gone, t->let, (size_t)t->whole->count * sizeof *t->let) == 0)
            return BATTEN_OK;
        status = fit_rest(t, &fitted);
        if (status == BATTEN_OK && bat_trial_is_near(t->work, &fitted)) {
            keep_best(t, &fitted);
            return BATTEN_OK;
        }
        find_off(t, &fitted);
        for (int k = 0; status == BATTEN_OK && k < t->whole->count; k++)
            if (is_off_about(t, region_of(t, k)))
                t->gone[k] = t->let[k];
        bat_trial_end(&fitted);
    }
    return status;
}

static batten_status thin_out(thinning *t, int most)
{
    batten_status status = BATTEN_OK;
    bool waits[2] = {true, true};
    for (int round = 0; status == BATTEN_OK && (waits[0] || waits[1]) && t->work->fits < most;
         round++) {
        bat_trial fitted = {0};
        waits[round % 2] = take_blocks(t, round % 2);
        if (!waits[round % 2])
            continue;
        status = fit_rest(t, &fitted);
        if (status == BATTEN_OK && bat_trial_is_near(t->work, &fitted))
            keep_best(t, &fitted);
        else if (status == BATTEN_OK)
            judge_blocks(t, &fitted);
        bat_trial_end(&fitted);
    }
    return status == BATTEN_OK ? repair(t) : status;
}

batten_status bat_within_thin(bat_within *w, bat_trial *whole, int count, const int *ranked,
                              int most, int *removed)
{
    const size_t n = (size_t)whole->count;
    thinning t = {
        .work = w, .whole = whole, .region_count = bat_max_int(1, whole->count / REGION)};
    t.regions = bat_array((size_t)t.region_count, sizeof *t.regions);
    t.order = bat_array((size_t)count + 1, sizeof *t.order);
    t.gone = bat_array(n + 1, sizeof *t.gone);
    t.let = bat_array(n + 1, sizeof *t.let);
    batten_status status = t.regions && t.order && t.gone && t.let ? deal_out(&t, count, ranked)
                                                                   : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = thin_out(&t, most);
    *removed = 0;
    if (status == BATTEN_OK && t.best.curve) {
        *removed = whole->count - t.best.count;
        bat_trial_end(whole);
        *whole = t.best;
    } else {
        bat_trial_end(&t.best);
    }
    bat_release(t.regions);
    bat_release(t.order);
    bat_release(t.gone);
    bat_release(t.let);
    return status;
}
