/* A curve as chords, each with a bound on how far the curve leaves it, and boxes of them. */
#include "inspect/nearest/meetings.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

/* How far a Bezier piece is from its chord at equal parameters, at most. */
static double piece_sag(int p, const double *rows)
{
    double bend = 0;
    for (int i = 1; i < p; i++) {
        double second[3];
        for (int c = 0; c < 3; c++)
            second[c] = rows[3 * (i + 1) + c] - 2 * rows[3 * i + c] + rows[3 * (i - 1) + c];
        bend = bat_max(bend, bat_norm(3, second));
    }
    return p * (p - 1) / 8.0 * bend;
}

static int chords_of_piece(int p, const double *rows, double sag)
{
    double length = 0;
    for (int i = 0; i < p; i++)
        length += bat_distance(3, rows + 3 * i, rows + 3 * i + 3);
    return length > 0 ? (int)bat_min(32, bat_max(1, ceil(sqrt(sag / length * 100)))) : 1;
}

/* Count the chords, or with arrays write where they begin and how far the curve leaves them. */
static int divide(const batten_curve *bezier, const double *knots, int pieces, double *at,
                  double *sags)
{
    const int p = bezier->degree;
    int count = 0;
    for (int k = 0; k < pieces; k++) {
        const double *rows = bezier->points + (size_t)(k * p) * 3;
        const double sag = piece_sag(p, rows);
        const int n = chords_of_piece(p, rows, sag);
        for (int i = 0; at && i < n; i++) {
            at[count + i] = knots[k] + (knots[k + 1] - knots[k]) * ((double)i / n);
            sags[count + i] = sag / n / n;
        }
        count += n;
    }
    if (at)
        at[count] = knots[pieces];
    return count;
}

static void hold(double *box, const double *low, const double *high, double more)
{
    for (int c = 0; c < 3; c++) {
        box[c] = bat_min(box[c], low[c] - more);
        box[3 + c] = bat_max(box[3 + c], high[c] + more);
    }
}

static void make_boxes(bat_trace *t)
{
    for (int i = 2 * t->width - 1; i > 0; i--) {
        double *box = t->boxes + 6 * i;
        const int k = i - t->width;
        for (int c = 0; c < 3; c++) {
            box[c] = HUGE_VAL;
            box[3 + c] = -HUGE_VAL;
        }
        for (int side = 0; side < 2; side++) {
            const double *child = t->boxes + 6 * (k < 0 ? 2 * i + side : 0);
            const double *point = t->points + 3 * bat_max_int(0, k + side);
            if (k < 0)
                hold(box, child, child + 3, 0);
            else if (k < t->count)
                hold(box, point, point, t->sag[k]);
        }
    }
}

static batten_status fill_chords(bat_trace *t, const batten_curve *bezier, const double *knots,
                                 int pieces)
{
    t->count = divide(bezier, knots, pieces, NULL, NULL);
    for (t->width = 1; t->width < t->count;)
        t->width *= 2;
    const size_t n = (size_t)t->count + 1;
    t->at = bat_array(n, sizeof *t->at);
    t->sag = bat_array(n, sizeof *t->sag);
    t->points = bat_array3(n, 3, sizeof *t->points);
    t->boxes = bat_array3(2 * (size_t)t->width, 6, sizeof *t->boxes);
    if (!t->at || !t->sag || !t->points || !t->boxes)
        return BATTEN_OUT_OF_MEMORY;
    divide(bezier, knots, pieces, t->at, t->sag);
    const batten_status status =
        batten_curve_evaluate_many(t->curve, n, t->at, 0, NULL, t->points);
    if (status == BATTEN_OK)
        make_boxes(t);
    return status;
}

batten_status bat_trace_make(const batten_curve *curve, bat_trace *out)
{
    bat_trace t = {.curve = curve};
    batten_curve *bezier = NULL;
    const int count = batten_curve_spans(curve, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    batten_status status = knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_curve_to_bezier(curve, &bezier);
    if (status == BATTEN_OK) {
        batten_curve_spans(curve, knots);
        status = fill_chords(&t, bezier, knots, count - 1);
    }
    if (status == BATTEN_OK)
        *out = t;
    else
        bat_trace_free(&t);
    batten_curve_unref(bezier);
    bat_release(knots);
    return status;
}

void bat_trace_free(bat_trace *t)
{
    bat_release(t->at);
    bat_release(t->sag);
    bat_release(t->points);
    bat_release(t->boxes);
}
