/* The feature 'b-spline': the uniform B-spline of a polygon. */
#include "design/shared/through.h"

#include <batten/polygon.h>

static const batten_parameter parameters[] = {
    {"b-spline", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "the polygon: a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
    {"degree", BATTEN_VALUE_COUNT, false, false, "3", NULL, "of the curve"},
    {"ends", BATTEN_VALUE_WORD, false, false, "clamped", "clamped free phantom repeated closed",
     "how the curve ends at the polygon"},
};

static batten_status make_b_spline(bat_run *run, const bat_data *data, bat_made *made)
{
    made->has_parameters = false;
    made->from_polygon = true;
    return batten_curve_uniform((batten_points){data->dimension, data->count, data->points},
                                bat_count(run, "degree"), NULL,
                                (batten_polygon_end)bat_word(run, "ends"), &made->curve);
}

static batten_status run_b_spline(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE, make_b_spline};
    return bat_through(run, &method);
}

const bat_feature bat_feature_b_spline = {
    .shown =
        {"b-spline", "The uniform B-spline of a polygon",
         "A smooth curve near a polygon: moving a corner changes the curve only nearby. Ends:\n"
         "'clamped' starts at the first corner along the first edge; 'free' starts inside the\n"
         "polygon, as Coons' segments do; 'phantom' (degree 3) starts at the first corner with\n"
         "curvature 0, by prolonging the first edge; 'repeated' starts straight, by repeating the\n"
         "end corners; 'closed' goes around. A corner given twice draws the curve close; given as\n"
         "often as the degree it is a corner of the curve.",
         "features:\n"
         "  corners: {points: [[0, 0], [1, 2], [3, 2], [4, 0], [6, 1]]}\n"
         "  hood: {b-spline: corners, ends: phantom}\n",
         "[SL chapter IV] [Utah74 paper 1] [Utah74 paper 6] [Coons74] [Riesenfeld73]",
         "batten_curve_uniform", BAT_PARAMETERS(parameters), false,
         .also = "uniform B-spline, cubic B-spline, Riesenfeld, control polygon, vertices",
         .formula =
             "    C(u) = Σ d_i N_{i,k}(u);  degree 3, a span:  C = ⅙ ((1−t)³ d_0 + (3t³ − 6t² + 4) d_1 + (−3t³ + 3t² + 3t + 1) d_2 + t³ d_3)",
         .promise =
             "Derivatives up to order k − 1 are continuous between distinct vertices; a vertex changes k + 1 spans."},
    .run = run_b_spline};
