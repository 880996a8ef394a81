/* The feature 'conic-spline': pairs of conics through points, curvature continuous without
 * a solve. */
#include "design/shared/conics.h"
#include "design/shared/local.h"

static const batten_parameter parameters[] = {
    {"conic-spline", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_CONIC_TANGENTS,
    {"curvatures", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "one for each point or for all, 1 by the unit, above 0 to the left; else by circles"},
    BAT_CONIC_SHARES,
    BAT_EACH,
    BAT_CLOSED,
};

static batten_status make_conic_spline(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_conics_options options = batten_curve_conics_defaults();
    double *tangents = NULL, *curvatures = NULL;
    options.closed = bat_yes(run, "closed");
    options.start_share = bat_number(run, "start-share");
    options.end_share = bat_number(run, "end-share");
    batten_status status = bat_vectors(run, data, "tangents", &tangents);
    if (status == BATTEN_OK && bat_argument_of(run, "curvatures")->count > 0)
        status = bat_numbers_each(run, "curvatures", data->count, "points", &curvatures);
    options.tangents = tangents;
    options.curvatures = curvatures;
    if (status == BATTEN_OK)
        status = bat_conics_make(run, data, &options, made);
    bat_release(tangents);
    bat_release(curvatures);
    return status;
}

static batten_status run_conic_spline(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make_conic_spline};
    return bat_through(run, &method);
}

const bat_feature bat_feature_conic_spline = {
    .shown =
        {"conic-spline", "Pairs of conics through points, curvature continuous without a solve",
         "Between two points there are two conics, which have the tangents and the curvatures at\n"
         "both points and equal curvatures where they meet. So any system that knows conics can\n"
         "hold the curve exactly, moving a point changes four spans and no others, and spans whose\n"
         "tangents bend to one side have no inflection. Data of one ellipse, parabola or\n"
         "hyperbola, with its tangents and curvatures, give it back; other smooth curves are\n"
         "approximated with an error of the fifth power of the step. Tangents and curvatures that\n"
         "are not given come from circles through three points. The shares may be set to draw a\n"
         "span fuller or flatter in its middle. A conic has no inflection: a span that bends to\n"
         "both sides is cut on its chord, and curvature jumps there, which is noted, as are spans\n"
         "whose curvatures bend against their tangents. The points lie in a plane.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 70 cm], [3 m, 20 cm], [3.2 m, -40 cm]]}\n"
         "  rim: {conic-spline: ducks}\n",
         "[SL section VI.5]", "batten_curve_conics", BAT_PARAMETERS(parameters), false,
         .also = "quadratic curve pair, G2 conics, rational quadratics",
         .formula =
             "    A = P0 + λ (T − P0),  B = P3 + μ (T − P3),  J = (1 − ν) A + ν B;  conics (P0, A, J; w1), (J, B, P3; w2)\n"
             "    w1² = |(A − P0) × (J − A)|/(2 κ0 |A − P0|³),  w2 alike;  ν = κ0^⅓ a/(κ0^⅓ a + κ3^⅓ b),  a = |A − P0|,  b = |P3 − B|",
         .promise =
             "Curvature is continuous at the points and at J, but where a span bends both ways."},
    .run = run_conic_spline};
