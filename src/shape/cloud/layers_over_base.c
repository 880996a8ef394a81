/*
 * Does a cloud lie over its base once? Points of a closed body do not: what lies beside a point
 * in parameters may belong to the far side. Such neighbours are far apart in space, by the
 * spacing of the points and by the size of the cloud.
 */
#include "numeric/select.h"
#include "numeric/vector.h"
#include "shape/cloud/scattered.h"

enum { EACH = 4, MOST_BINS = 1024 };

/* Data by bins of the parameters: those of bin b are order[first[b]] and on. */
typedef struct {
    int counts[2];
    size_t *first; /* [bins + 1] */
    size_t *order; /* [count] */
} bins;

static size_t bin_of(const bat_scatter *s, const bins *b, size_t t)
{
    int at[2];
    for (int k = 0; k < 2; k++)
        at[k] = bat_min_int(b->counts[k] - 1,
                            (int)(s->uv[2 * t + (size_t)k] / s->side[k] * b->counts[k]));
    return (size_t)at[0] * (size_t)b->counts[1] + (size_t)at[1];
}

static void fill_bins(const bat_scatter *s, size_t all, bins *b)
{
    /* Counted two places on, so that filling leaves every beginning in its place. */
    for (size_t t = 0; t < s->count; t++)
        b->first[bin_of(s, b, t) + 2]++;
    for (size_t i = 2; i < all + 2; i++)
        b->first[i] += b->first[i - 1];
    for (size_t t = 0; t < s->count; t++)
        b->order[b->first[bin_of(s, b, t) + 1]++] = t;
}

static void choose_counts(const bat_scatter *s, bins *b)
{
    for (int k = 0; k < 2; k++) {
        const double wanted = sqrt((double)s->count / EACH * s->side[k] / s->side[1 - k]);
        b->counts[k] = (int)bat_min(MOST_BINS, bat_max(1, wanted));
    }
}

static batten_status sort_into_bins(const bat_scatter *s, bins *b)
{
    choose_counts(s, b);
    const size_t all = (size_t)b->counts[0] * (size_t)b->counts[1];
    b->first = bat_array(all + 2, sizeof *b->first);
    b->order = bat_array(s->count, sizeof *b->order);
    if (b->first && b->order)
        fill_bins(s, all, b);
    return b->first && b->order ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* How far it is away, by the parameters and in space. */
typedef struct {
    double nearest, distance;
} neighbour;

enum { MOST_IN_BIN = 32 };

static void look_into_bin(const bat_scatter *s, const bins *b, size_t bin, size_t t,
                          neighbour *found)
{
    const size_t begin = b->first[bin];
    for (size_t n = begin; n < b->first[bin + 1] && n < begin + MOST_IN_BIN; n++) {
        const size_t other = b->order[n];
        const double off = bat_distance(2, s->uv + 2 * t, s->uv + 2 * other);
        if (other == t || off >= found->nearest)
            continue;
        *found = (neighbour){off, bat_distance(3, s->centred + 3 * t, s->centred + 3 * other)};
    }
}

/* How far in space the datum is that is nearest in parameters, among those of a bin and of the
 * bins around it; 0 when there is none. A bin with very many is looked at in part: the cost
 * stays linear. */
static double apart_from_neighbours(const bat_scatter *s, const bins *b, size_t t)
{
    const size_t here = bin_of(s, b, t);
    const int i = (int)(here / (size_t)b->counts[1]), j = (int)(here % (size_t)b->counts[1]);
    neighbour found = {HUGE_VAL, 0};
    for (int a = bat_max_int(0, i - 1); a <= bat_min_int(b->counts[0] - 1, i + 1); a++)
        for (int c = bat_max_int(0, j - 1); c <= bat_min_int(b->counts[1] - 1, j + 1); c++) {
            look_into_bin(s, b, (size_t)a * (size_t)b->counts[1] + (size_t)c, t, &found);
        }
    return found.distance;
}

/* How wide the points are along each axis; the least of it. */
static double find_sides(const bat_scatter *s, double side[3])
{
    double shortest = HUGE_VAL;
    for (size_t c = 0; c < 3; c++) {
        side[c] = 0;
        for (size_t t = 0; t < s->count; t++)
            side[c] = bat_max(side[c], 2 * fabs(s->centred[3 * t + c]));
        shortest = bat_min(shortest, side[c]);
    }
    return shortest;
}

/* Beyond this neighbours are far apart: five times the spacing of points in the two longer
 * sides of the box, and a twentieth of its diagonal. */
static double far_apart(const bat_scatter *s)
{
    double side[3], product = 1;
    const double shortest = find_sides(s, side);
    const double diagonal = bat_norm(3, side);
    for (int c = 0, left = 0; c < 3; c++) {
        const bool out = side[c] == shortest && !left;
        left += out;
        product *= out ? 1 : sqrt(side[c]);
    }
    return bat_max(5 * product / sqrt((double)s->count), diagonal / 20);
}

batten_status bat_scatter_layers(bat_scatter *s)
{
    bins b = {{0, 0}, NULL, NULL};
    double *far = bat_array(s->count, sizeof *far);
    batten_status status = far ? sort_into_bins(s, &b) : BATTEN_OUT_OF_MEMORY;
    const double limit = far_apart(s);
    size_t count = 0;
    for (size_t t = 0; status == BATTEN_OK && t < s->count; t++) {
        const double distance = apart_from_neighbours(s, &b, t);
        if (distance > limit)
            far[count++] = distance;
    }
    s->report.layered = (double)count / (double)s->count;
    s->report.layers_apart = count > 0 ? bat_select(count, far, count / 2) : 0;
    bat_release(b.order);
    bat_release(b.first);
    bat_release(far);
    return status;
}
