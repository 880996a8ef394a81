/* The feature 'bezier': the Bezier curve of a polygon. */
#include "base/plural.h"
#include "design/shared/through.h"

#include <batten/polygon.h>

enum { POINTS, EDGES };

static const batten_parameter parameters[] = {
    {"bezier", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "the polygon: a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    {"given", BATTEN_VALUE_WORD, false, false, "points", "points edges",
     "the corners of the polygon; or its first corner and then its edges, as in UNISURF"},
    {"weights", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "of the corners: a rational curve"},
};

static batten_status make_bezier(bat_run *run, const bat_data *data, bat_made *made)
{
    const bat_argument *given = bat_argument_of(run, "weights");
    double weights[BATTEN_MAX_DEGREE + 1];
    const int n = data->count;
    made->has_parameters = false;
    made->from_polygon = bat_word(run, "given") != EDGES;
    if (n > BATTEN_MAX_DEGREE + 1)
        return bat_fail(BATTEN_BAD_DEGREE,
                        "a polygon of %d corners gives degree %d; the highest is %d, and "
                        "'b-spline' takes polygons of any length",
                        n, n - 1, BATTEN_MAX_DEGREE);
    if (bat_word(run, "given") == EDGES)
        return batten_curve_from_edges(data->dimension, n - 1, data->points,
                                       data->points + data->dimension, &made->curve);
    if (given->count && given->count != n)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d weight%s for %d corner%s", given->count,
                        bat_plural(given->count), n, bat_plural(n));
    for (int i = 0; i < given->count; i++)
        weights[i] = given->items[i].number[0];
    return batten_curve_bezier(data->dimension, n - 1, data->points,
                               given->count ? weights : NULL, &made->curve);
}

static batten_status run_bezier(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE, make_bezier};
    return bat_through(run, &method);
}

const bat_feature bat_feature_bezier = {
    .shown =
        {"bezier", "The Bezier curve of a polygon",
         "One polynomial whose degree is one less than the number of corners, up to 25. It starts\n"
         "and ends with the polygon, along its first and last edges, and lies within its convex\n"
         "hull; moving a corner moves the whole curve. Values of a function at even steps, taken\n"
         "as heights, give its Bernstein approximation. With 'edges' the first point is the start\n"
         "and the others are the edges of the polygon: the form of UNISURF.",
         "features:\n"
         "  corners: {points: [[0, 0], [1, 2], [3, 2], [4, 0]]}\n"
         "  hood: {bezier: corners}\n",
         "[SL section I.4] [SL chapter IV] [Utah74 paper 7] [Bezier74] [Farin02]",
         "batten_curve_bezier", BAT_PARAMETERS(parameters), false,
         .also = "UNISURF, Bézier, Bernstein polynomial, de Casteljau, control polygon",
         .formula = "    C(t) = Σ b_i B_i^n(t),  B_i^n(t) = (n over i) t^i (1 − t)^{n−i}\n"
                    "    edges a_i:  C(t) = a_0 + Σ_{i≥1} a_i f_i(t),  f_i = Σ_{k≥i} B_k^n",
         .promise =
             "The curve lies in the convex hull of its polygon and no line meets it more often than the polygon."},
    .run = run_bezier};
