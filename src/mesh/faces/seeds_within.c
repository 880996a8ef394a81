/* Seeds inside the border of a face: line after line of the lattice, by the sides across it. */
#include "mesh/faces/rim.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* A seed on the line. */
typedef struct {
    double line, along;
    int seed;
} seed_place;

typedef struct {
    int d;              /* lines are where this coordinate is the same */
    int place_count;    /* without those at the ends of the box: there nothing is inside */
    seed_place *places; /* [place_count] line after line, along each */
    int line_count;
    double *lines;     /* [line_count] rising */
    int *first_place;  /* [line_count + 1] */
    int *first_across; /* [line_count + 2] into `across` */
    double *across;    /* where sides are across lines */
} sweep;

static void sweep_end(sweep *s)
{
    bat_release(s->places);
    bat_release(s->lines);
    bat_release(s->first_place);
    bat_release(s->first_across);
    bat_release(s->across);
}

static int compare_places(const void *a, const void *b)
{
    const seed_place *p = a, *q = b;
    if (p->line != q->line)
        return p->line < q->line ? -1 : 1;
    if (p->along != q->along)
        return p->along < q->along ? -1 : 1;
    return (p->seed > q->seed) - (p->seed < q->seed);
}

static int compare_numbers(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Cells are about square, so there are fewer lines across the shorter way. */
static batten_status order_seeds(sweep *s, const bat_lattice *l)
{
    const size_t room = (size_t)l->seed_count + 2;
    double end[2];
    for (int k = 0; k < 2; k++)
        end[k] = l->axis[k].x[l->axis[k].count - 1];
    s->d = end[1] <= end[0];
    s->places = bat_array(room, sizeof *s->places);
    s->lines = bat_array(room, sizeof *s->lines);
    s->first_place = bat_array(room, sizeof *s->first_place);
    s->first_across = bat_array(room, sizeof *s->first_across);
    if (!s->places || !s->lines || !s->first_place || !s->first_across)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < l->seed_count; i++) {
        const double at[2] = {l->seeds[i].x, l->seeds[i].y};
        if (at[0] > 0 && at[0] < end[0] && at[1] > 0 && at[1] < end[1])
            s->places[s->place_count++] = (seed_place){at[s->d], at[1 - s->d], i};
    }
    qsort(s->places, (size_t)s->place_count, sizeof *s->places, compare_places);
    for (int i = 0; i < s->place_count; i++)
        if (i == 0 || s->places[i].line > s->places[i - 1].line) {
            s->first_place[s->line_count] = i;
            s->lines[s->line_count++] = s->places[i].line;
        }
    s->first_place[s->line_count] = s->place_count;
    return BATTEN_OK;
}

/* The first line at x or behind. */
static int line_from(const sweep *s, double x)
{
    int low = 0, high = s->line_count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (s->lines[middle] < x)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* The lines from `*first` to before `*end` cross the side: at its lower end, not at its upper.
 */
static void lines_across(const sweep *s, const bat_rim *rim, int side, int *first, int *end)
{
    const double a = rim->at[side][s->d], b = rim->at[rim->corners[side].next][s->d];
    *first = line_from(s, bat_min(a, b));
    *end = line_from(s, bat_max(a, b));
}

/* Many long sides across many lines are more than it would take to walk. */
static bool count_across(sweep *s, const bat_rim *rim)
{
    const double most = bat_min(8.0 * ((double)s->place_count + rim->count), INT_MAX / 2);
    double all = 0;
    for (int i = 0; i < rim->count && all <= most; i++) {
        int first, end;
        lines_across(s, rim, i, &first, &end);
        all += end - first;
        for (int j = first; j < end && all <= most; j++)
            s->first_across[j + 1]++;
    }
    for (int j = 0; j < s->line_count; j++)
        s->first_across[j + 1] += s->first_across[j];
    return all <= most;
}

static batten_status find_across(sweep *s, const bat_rim *rim)
{
    const int d = s->d, count = s->first_across[s->line_count];
    int *next = bat_array((size_t)s->line_count, sizeof *next);
    s->across = bat_array((size_t)count, sizeof *s->across);
    if (!next || !s->across) {
        bat_release(next);
        return BATTEN_OUT_OF_MEMORY;
    }
    memcpy(next, s->first_across, (size_t)s->line_count * sizeof *next);
    for (int i = 0; i < rim->count; i++) {
        const double *a = rim->at[i], *b = rim->at[rim->corners[i].next];
        int first, end;
        lines_across(s, rim, i, &first, &end);
        for (int j = first; j < end; j++)
            s->across[next[j]++] =
                a[1 - d] + (s->lines[j] - a[d]) / (b[d] - a[d]) * (b[1 - d] - a[1 - d]);
    }
    bat_release(next);
    for (int j = 0; j < s->line_count; j++)
        qsort(s->across + s->first_across[j],
              (size_t)(s->first_across[j + 1] - s->first_across[j]), sizeof *s->across,
              compare_numbers);
    return BATTEN_OK;
}

/* Those that are behind an odd number of sides, each place once. `is_known`: the sides are. */
static void mark(const sweep *s, bool is_known, bool *keep)
{
    for (int j = 0; j < s->line_count; j++) {
        int before = s->first_across[j];
        for (int i = s->first_place[j]; i < s->first_place[j + 1]; i++) {
            const seed_place *p = &s->places[i];
            while (is_known && before < s->first_across[j + 1] && s->across[before] < p->along)
                before++;
            keep[p->seed] = (!is_known || (before - s->first_across[j]) % 2 == 1) &&
                            (i == s->first_place[j] || p->along > p[-1].along);
        }
    }
}

batten_status bat_rim_choose_seeds(const bat_rim *rim, bat_lattice *l)
{
    sweep s = {0};
    bool *keep = bat_array((size_t)l->seed_count, sizeof *keep);
    batten_status status = keep ? order_seeds(&s, l) : BATTEN_OUT_OF_MEMORY;
    const bool is_known = status == BATTEN_OK && count_across(&s, rim);
    if (is_known)
        status = find_across(&s, rim);
    if (status == BATTEN_OK) {
        int count = 0;
        mark(&s, is_known, keep);
        for (int i = 0; i < l->seed_count; i++)
            if (keep[i])
                l->seeds[count++] = l->seeds[i];
        l->seed_count = count;
    }
    sweep_end(&s);
    bat_release(keep);
    return status;
}
