/* Quintic pieces joined to one curve, and results of equations that grow. */
#include "shape/equation/pieces.h"

#include "numeric/rounding.h"
#include <batten/curve.h>
#include <string.h>

/* ---- joints ---- */

/* Both are computed from the same equations: what differs is rounding, of the difference of legs. */
bool bat_quintics_agree(int dimension, const bat_quintic_piece *l, const bat_quintic_piece *r)
{
    const double h = l->b - l->a, k = r->b - r->a;
    if (l->is_chord || r->is_chord)
        return false;
    for (int c = 0; c < dimension; c++) {
        const double p = (l->leg[5][c] - l->leg[4][c]) / h;
        const double q = (r->leg[1][c] - r->leg[0][c]) / k;
        const double size = fabs(l->leg[4][c]) + fabs(l->leg[5][c]) + fabs(r->leg[1][c]);
        if (fabs(p - q) > BAT_EXACT * size / bat_min(h, k) + BAT_EXACT * fabs(p))
            return false;
        const double s = (l->leg[5][c] - 2 * l->leg[4][c] + l->leg[3][c]) / (h * h);
        const double t = (r->leg[2][c] - 2 * r->leg[1][c] + r->leg[0][c]) / (k * k);
        const double least = bat_min(h, k);
        if (fabs(s - t) > BAT_EXACT * size / (least * least) + BAT_ROUNDING * fabs(s))
            return false;
    }
    return true;
}

/* The control point whose knots are a, c, c, c, b, of pieces over [a, c] and [c, b]: on the line of two
 * Bezier points of the longer piece, which rounds least. */
static void find_middle(int dimension, const bat_quintic_piece *l, const bat_quintic_piece *r,
                        double *out)
{
    const double h = l->b - l->a, k = r->b - r->a;
    for (int c = 0; c < dimension; c++)
        out[c] = h >= k ? l->leg[4][c] + k / h * (l->leg[4][c] - l->leg[3][c])
                        : r->leg[1][c] + h / k * (r->leg[1][c] - r->leg[2][c]);
}

typedef struct {
    int dimension, point_count, knot_count;
    double *points, *knots;
} builder;

static void add_point(builder *b, const double *point)
{
    memcpy(b->points + (size_t)b->point_count++ * (size_t)b->dimension, point,
           (size_t)b->dimension * sizeof *point);
}

static void add_knots(builder *b, double at, int count)
{
    while (count-- > 0)
        b->knots[b->knot_count++] = at;
}

static void join_pieces(builder *b, int count, const bat_quintic_piece *pieces)
{
    double middle[3] = {0, 0, 0};
    add_knots(b, pieces[0].a, BAT_QUINTIC + 1);
    for (int k = 0; k < 3; k++)
        add_point(b, pieces[0].leg[k]);
    for (int i = 0; i < count; i++) {
        const bat_quintic_piece *l = &pieces[i], *r = &pieces[i + 1];
        add_point(b, l->leg[3]);
        if (i + 1 == count)
            break;
        const bool smooth = bat_quintics_agree(b->dimension, l, r);
        add_knots(b, l->b, smooth ? 3 : BAT_QUINTIC);
        if (smooth)
            find_middle(b->dimension, l, r, middle);
        add_point(b, smooth ? middle : l->leg[4]);
        for (int k = 0; k < 3 && !smooth; k++)
            add_point(b, r->leg[k]);
        if (smooth)
            add_point(b, r->leg[2]);
    }
    add_point(b, pieces[count - 1].leg[4]);
    add_point(b, pieces[count - 1].leg[5]);
    add_knots(b, pieces[count - 1].b, BAT_QUINTIC + 1);
}

batten_status bat_quintics_joined(int dimension, int count, const bat_quintic_piece *pieces,
                                  batten_curve **out)
{
    const size_t most = BAT_QUINTIC * (size_t)count + 1;
    builder b = {.dimension = dimension};
    b.points = bat_array(most * (size_t)dimension, sizeof *b.points);
    b.knots = bat_array(most + BAT_QUINTIC + 1, sizeof *b.knots);
    batten_status status = b.points && b.knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        join_pieces(&b, count, pieces);
        status = batten_curve_create((batten_points){dimension, b.point_count, b.points},
                                     BAT_QUINTIC, NULL, b.knots, out);
    }
    bat_release(b.points);
    bat_release(b.knots);
    return status;
}

/* ---- the result ---- */

/* Results are short lists: each further item moves the others. */
batten_status bat_equation_add_curve(batten_equation_curves *out, batten_curve *curve)
{
    batten_curve **grown = bat_resize(out->curves, (size_t)out->count + 1, sizeof *grown);
    if (!grown)
        return BATTEN_OUT_OF_MEMORY;
    grown[out->count++] = curve;
    out->curves = grown;
    return BATTEN_OK;
}

batten_status bat_equation_add_point(batten_equation_curves *out, batten_equation_point point)
{
    batten_equation_point *grown =
        bat_resize(out->points, (size_t)out->point_count + 1, sizeof *grown);
    if (!grown)
        return BATTEN_OUT_OF_MEMORY;
    grown[out->point_count++] = point;
    out->points = grown;
    return BATTEN_OK;
}

void batten_equation_curves_release(batten_equation_curves *curves)
{
    for (int i = 0; i < curves->count; i++)
        batten_curve_unref(curves->curves[i]);
    bat_release(curves->curves);
    bat_release(curves->points);
    bat_release(curves->undecided);
    *curves = (batten_equation_curves){0};
}
