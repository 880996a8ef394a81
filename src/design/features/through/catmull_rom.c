/* The feature 'catmull-rom': local polynomials blended with B-splines, after Catmull and
 * Rom. */
#include "design/shared/local.h"

#include <string.h>

static const batten_parameter parameters[] = {
    {"catmull-rom", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_CHORD_POWER("0.5"),
    {"blend", BATTEN_VALUE_COUNT, false, false, "2", NULL,
     "degree of the B-splines that blend the local polynomials"},
    {"local", BATTEN_VALUE_COUNT, false, false, "1", NULL,
     "degree of the local polynomials; below 'blend' - 1 the curve passes near the points"},
    BAT_PHANTOMS,
    BAT_AS,
    BAT_EACH,
    BAT_CLOSED,
};

static batten_status make_catmull_rom(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
    batten_curve_catmull_rom_report report = {0};
    options.blend = bat_count(run, "blend");
    options.local = bat_count(run, "local");
    options.alpha = bat_number(run, "alpha");
    options.given = data->abscissae;
    options.closed = bat_yes(run, "closed");
    options.phantoms = (batten_phantoms)bat_word(run, "beyond");
    double *t = bat_array((size_t)data->count + 1, sizeof *t);
    batten_status status = t ? bat_check_closed(run, data) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_curve_catmull_rom(
            (batten_points){data->dimension, data->count, data->points}, &options, t, &report,
            &made->curve);
    if (status == BATTEN_OK)
        memcpy(made->parameters, t, (size_t)data->count * sizeof *t);
    bat_release(t);
    if (status == BATTEN_OK && !report.through)
        bat_note(run, "'%s': the curve passes near the points, up to %g away", data->name,
                 report.error);
    return status;
}

static batten_status run_catmull_rom(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION, make_catmull_rom};
    return bat_through(run, &method);
}

const bat_feature bat_feature_catmull_rom = {
    .shown =
        {"catmull-rom", "Local polynomials blended with B-splines, after Catmull and Rom",
         "A polynomial runs through each few neighbouring points, and B-splines blend these\n"
         "polynomials. The curve is smooth without solving any equations, and moving a point\n"
         "changes four spans. With the default alpha, 0.5, no span has a cusp or crosses itself,\n"
         "however uneven the points; 0 swings beside short spans, 1 bulges on long ones. The\n"
         "default is the classical cubic, with continuous first derivative; 'blend: 3, local: 2' a\n"
         "quintic with continuous curvature, which suits few, even points better than many, uneven\n"
         "ones. 'local: 0' gives the B-spline that has the points as its control points. Where\n"
         "'blend' and 'local' are both even or both odd, the order of the points matters. For fair\n"
         "curves use 'interpolate': here curvature jumps at the points.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [1.2 m, 70 cm], [3 m, 20 cm], [4 m, 0]]}\n"
         "  sheer: {catmull-rom: ducks}\n",
         "[Utah74 paper 15] [CR74] [BG88] [YSK11]", "batten_curve_catmull_rom",
         BAT_PARAMETERS(parameters), false,
         .also = "Overhauser, cardinal blending, local interpolating spline, camera path",
         .formula =
             "    F(t) = Σ L_j(t) N_j(t),  N_j B-splines of degree blend,  L_j polynomials of degree local through the points around",
         .promise =
             "Polynomials of degree max(local, blend) are reproduced; with alpha 1/2 the default has no cusp and no loop within a span."},
    .run = run_catmull_rom};
