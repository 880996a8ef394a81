/* The feature 'conic-pair': two conics from point to point with given directions and
 * curvatures. */
#include "design/shared/conics.h"

static const batten_parameter parameters[] = {
    {"conic-pair", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "two points, in a plane"},
    {"start-angle", BATTEN_VALUE_ANGLE, false, true, NULL, NULL,
     "direction at the start, from the first axis of the plane"},
    {"end-angle", BATTEN_VALUE_ANGLE, false, true, NULL, NULL, "direction at the end"},
    {"start-curvature", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,
     "curvature at the start, 1 by the unit, above 0 to the left; give both or none"},
    {"end-curvature", BATTEN_VALUE_NUMBER, false, false, NULL, NULL, "curvature at the end"},
    BAT_CONIC_SHARES,
    BAT_EACH,
};

static batten_status make_conic_pair(bat_run *run, const bat_data *data, bat_made *made)
{
    const bool first = bat_has(run, "start-curvature"), last = bat_has(run, "end-curvature");
    if (data->count != 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a conic pair has 2 points, not %d", data->count);
    if (first != last)
        return bat_fail(BATTEN_BAD_ARGUMENT, "one curvature is given; give both or none");
    const double a = bat_number(run, "start-angle"), b = bat_number(run, "end-angle");
    const double tangents[] = {bat_cos(a), bat_sin(a), bat_cos(b), bat_sin(b)};
    double curvatures[2] = {0, 0};
    batten_curve_conics_options options = batten_curve_conics_defaults();
    options.kind = first ? BATTEN_CONICS_PAIRS : BATTEN_CONICS_PARABOLAS;
    options.tangents = tangents;
    options.start_share = bat_number(run, "start-share");
    options.end_share = bat_number(run, "end-share");
    if (first) {
        curvatures[0] = bat_number(run, "start-curvature");
        curvatures[1] = bat_number(run, "end-curvature");
        options.curvatures = curvatures;
    }
    return bat_conics_make(run, data, &options, made);
}

static batten_status run_conic_pair(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make_conic_pair};
    return bat_through(run, &method);
}

const bat_feature bat_feature_conic_pair = {
    .shown =
        {"conic-pair", "Two conics from point to point with given directions and curvatures",
         "Joins two points in given directions by two conics that meet with one tangent. With\n"
         "curvatures given they have these at the ends, and equal curvatures where they meet: so a\n"
         "pair closes the gap between two curves with continuous curvature. Without curvatures it\n"
         "is two parabolas, the quadratic spline with one knot in its middle. The curve stays in\n"
         "the triangle of its tangents; the shares say how far along them the control points lie.\n"
         "Directions that bend to both sides give two conics that meet on the chord, and a note.",
         "features:\n"
         "  ends: {points: [[0, 0], [3 m, 0]]}\n"
         "  bilge: {conic-pair: ends, start-angle: 60 deg, end-angle: -30 deg}\n",
         "[SL section VI.5]", "batten_curve_conics", BAT_PARAMETERS(parameters), false,
         .also = "quadratic curve pair, two conics, closing a gap",
         .formula =
             "    A = P0 + λ (T − P0),  B = P3 + μ (T − P3),  J = (1 − ν) A + ν B;  conics (P0, A, J; w1), (J, B, P3; w2)\n"
             "    with curvatures: w1² = |(A − P0) × (J − A)|/(2 κ0 |A − P0|³), w2 alike, ν as in conic-spline;  without: w = 1, parabolas",
         .promise =
             "Directions, and curvatures where they are given, are met at both ends; the curve stays in the triangle P0 T P3."},
    .run = run_conic_pair};
