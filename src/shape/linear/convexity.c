/* Will a cubic spline function be convex? Answered without solving for it. */
#include "shape/linear/end_conditions.h"
#include "shape/local/hermite_data.h"

/* A row of the equations of the second derivatives M: lower M[i - 1] + diagonal M[i] + upper
 * M[i + 1] = right. */
typedef struct {
    double lower, diagonal, upper, right;
} moment_row;

/* By how much the slope changes at each inner point, but for rounding, for its share of the two spans. */
static void fill_inner(const bat_chords *c, moment_row *rows)
{
    double before = bat_chord_rounding(c, 0);
    for (int i = 1; i + 1 < c->count; i++) {
        const double after = bat_chord_rounding(c, i), by = c->d[i] - c->d[i - 1];
        const double width = c->h[i - 1] + c->h[i];
        const double change = fabs(by) <= before + after ? 0 : by;
        rows[i] = (moment_row){c->h[i - 1] / width, 2, c->h[i] / width, 6 * change / width};
        before = after;
    }
}

/* An end, by its span h and either how much its slope must change along it or its second
 * derivative. One with M[0] = M[1] has no row of its own: its neighbour takes the coefficient.
 */
static moment_row end_row(batten_end_kind kind, double h, double difference, double second)
{
    if (kind == BATTEN_END_CLAMPED)
        return (moment_row){1, 2, 1, 6 * difference / h};
    return (moment_row){0, 2, 0, kind == BATTEN_END_SECOND ? 2 * second : 0};
}

static void fill(const bat_chords *c, const batten_end_kind kinds[2], double values[2][3],
                 moment_row *rows)
{
    const int n = c->count - 1;
    fill_inner(c, rows);
    rows[0] = end_row(kinds[0], c->h[0], c->d[0] - values[0][0], values[0][0]);
    rows[n] = end_row(kinds[1], c->h[n - 1], values[1][0] - c->d[n - 1], values[1][0]);
    rows[0].lower = rows[n].upper = 0;
    if (kinds[0] == BATTEN_END_PARABOLIC) {
        rows[1].diagonal += rows[1].lower;
        rows[1].lower = 0;
    }
    if (kinds[1] == BATTEN_END_PARABOLIC) {
        rows[n - 1].diagonal += rows[n - 1].upper;
        rows[n - 1].upper = 0;
    }
}

/* 1, -1, or 0 where the slopes both rise and fall. */
static int sign_of_points(int count, const moment_row *rows)
{
    bool rises = false, falls = false;
    for (int i = 1; i + 1 < count; i++) {
        rises = rises || rows[i].right > 0;
        falls = falls || rows[i].right < 0;
    }
    return falls ? (rises ? 0 : -1) : 1;
}

/* The first row whose right side is less than what its neighbours take of it: with D the
 * diagonal and B the rest, (D + B)^-1 = sum of (D^-1 B)^2k (I - D^-1 B) D^-1, and B >= 0. */
static int first_failing(int count, const moment_row *rows, int sign)
{
    for (int i = 0; i < count; i++) {
        double taken = 0;
        if (i > 0)
            taken += rows[i].lower * (rows[i - 1].right / rows[i - 1].diagonal);
        if (i + 1 < count)
            taken += rows[i].upper * (rows[i + 1].right / rows[i + 1].diagonal);
        if (!(sign * rows[i].right >= sign * taken))
            return i;
    }
    return -1;
}

static batten_status find(const bat_chords *c, const batten_end_kind kinds[2],
                          double values[2][3], batten_convexity *out)
{
    moment_row *rows = bat_array((size_t)c->count, sizeof *rows);
    if (!rows)
        return BATTEN_OUT_OF_MEMORY;
    fill(c, kinds, values, rows);
    out->points = sign_of_points(c->count, rows);
    out->at = out->points == 0 ? -1 : first_failing(c->count, rows, out->points);
    out->promised = out->points != 0 && out->at < 0;
    bat_release(rows);
    return BATTEN_OK;
}

batten_status batten_spline_convexity(int count, const double *x, const double *y,
                                      const batten_end *start, const batten_end *end,
                                      batten_convexity *out)
{
    assert(x && y && out);
    const batten_end natural = {.kind = BATTEN_END_NATURAL};
    const batten_end ends[2] = {start ? *start : natural, end ? *end : natural};
    bat_ends found = {.values = {{0}}};
    bat_chords chords;
    batten_status status = bat_chords_make(count, x, y, &chords);
    if (status != BATTEN_OK)
        return status;
    status = bat_ends_plain((batten_points){1, count, y}, x, ends,
                            "splines that are asked for convexity", &found);
    if (status == BATTEN_OK)
        status = find(&chords, found.kinds, found.values, out);
    bat_chords_free(&chords);
    return status;
}
