/* The feature 'aerofoil': sections of wings in one form, so that any two make a skin. */
#include "base/plural.h"
#include "design/shared/through.h"
#include <batten/approximate.h>

static const batten_parameter parameters[] = {
    {"aerofoil", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "points of sections, each beginning and ending at the trailing edge"},
    {"chord", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "from the nose to the trailing edge; that of the points by default"},
    {"trailing-edge", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,
     "its height as a part of the chord: 0 closes it, 0.002 opens it; as it is by default"},
    {"thickness", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,
     "the largest, as a part of the chord; as it is by default"},
    {"blend", BATTEN_VALUE_NUMBER, false, false, "1", NULL,
     "how far forward a change of the trailing edge reaches, as a part of the chord"},
    {"panels", BATTEN_VALUE_COUNT, false, false, "160", NULL,
     "spans of the curve, dense at nose and tail; an even number"},
    BAT_EACH,
};

/* What was odd about the points, as far as it was put right. */
static void remark_order(bat_run *run, const char *name, const batten_curve_aerofoil_report *r)
{
    if (r->halves)
        bat_remark(run, "'%s': both sides run from the nose; the upper one is turned", name);
    if (r->mirrored)
        bat_remark(run, "'%s': the nose was on the right; the section is mirrored", name);
    if (r->reversed)
        bat_remark(run, "'%s': the lower side came first; the order is reversed", name);
    if (r->closed)
        bat_remark(run, "'%s': one end alone is at the trailing edge; its point is repeated",
                   name);
    if (r->repeated)
        bat_remark(run, "'%s': %d repeated point%s left out", name, r->repeated,
                   r->repeated == 1 ? " is" : "s are");
    if (r->base)
        bat_remark(run, "'%s': %d point%s on the base of the trailing edge %s left out", name,
                   r->base, bat_plural(r->base), r->base == 1 ? "is" : "are");
}

static void note_faults(bat_run *run, const char *name, const batten_curve_aerofoil_report *r)
{
    if (r->crossings)
        bat_note(run,
                 "'%s': its sides cross at %d place%s, first at %.4g of the chord; a larger "
                 "'trailing-edge' or a smaller 'blend' may help",
                 name, r->crossings, bat_plural(r->crossings), r->crossing);
    if (r->made.trailing_edge < 0)
        bat_note(run,
                 "'%s': its upper side ends %.3g of the chord below the lower one; "
                 "'trailing-edge' sets another height",
                 name, -r->made.trailing_edge);
    if (r->round_tail)
        bat_note(run,
                 "'%s': its tail is rounder than its nose; points must begin and end at the "
                 "trailing edge",
                 name);
}

static void remark_shape(bat_run *run, const char *name, const char *which,
                         const batten_aerofoil_shape *s)
{
    bat_remark(run,
               "'%s', %s: chord %.7g, thickness %.3f %% at %.1f %%, camber %.3f %% at %.1f %%, "
               "trailing edge %.4f %%",
               name, which, s->chord, 100 * s->thickness, 100 * s->thickness_at,
               100 * s->camber, 100 * s->camber_at, 100 * s->trailing_edge);
}

static double number_or(const bat_run *run, const char *parameter, double absent)
{
    return bat_has(run, parameter) ? bat_number(run, parameter) : absent;
}

/* In C values outside of these mean "as it is". */
static batten_status check_given(const bat_run *run)
{
    static const char *const above[] = {"chord", "thickness"};
    for (int i = 0; i < 2; i++)
        if (bat_has(run, above[i]) && !(bat_number(run, above[i]) > 0))
            return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' is %g; it must be above 0", above[i],
                            bat_number(run, above[i]));
    if (bat_has(run, "trailing-edge") && !(bat_number(run, "trailing-edge") >= 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "'trailing-edge' is %g; it must be 0 or more",
                        bat_number(run, "trailing-edge"));
    return BATTEN_OK;
}

static batten_status make_aerofoil(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_aerofoil_options options = batten_curve_aerofoil_defaults();
    batten_curve_aerofoil_report report;
    options.chord = number_or(run, "chord", 0);
    options.trailing_edge = number_or(run, "trailing-edge", -1);
    options.thickness = number_or(run, "thickness", 0);
    options.blend = bat_number(run, "blend");
    options.panels = bat_count(run, "panels");
    batten_status status = check_given(run);
    if (status == BATTEN_OK)
        status =
            batten_curve_aerofoil((batten_points){data->dimension, data->count, data->points},
                                  &options, &report, &made->curve);
    if (status != BATTEN_OK)
        return status;
    remark_order(run, data->name, &report);
    remark_shape(run, data->name, "given", &report.given);
    remark_shape(run, data->name, "made", &report.made);
    bat_remark(run, "'%s': moved by up to %.3g; then points lie within %.3g of the curve",
               data->name, report.moved, report.distance);
    note_faults(run, data->name, &report);
    made->has_parameters = false;
    made->is_elsewhere = true;
    made->has_error = true;
    made->error_max = report.distance;
    made->error_rms = report.rms;
    return BATTEN_OK;
}

static batten_status run_aerofoil(bat_run *run)
{
    return bat_through(run,
                       &(bat_method){.least = 5, .ways = BAT_IN_PLANE, .make = make_aerofoil});
}

const bat_feature bat_feature_aerofoil = {
    .shown =
        {"aerofoil", "Aerofoil sections in one form: chord, trailing edge, thickness, panels",
         "Makes sections of any source alike, so that any two of them make a skin: the nose at\n"
         "the origin, the trailing edge on the first axis, and a C2 cubic from there over the upper\n"
         "side to the nose and back below. All curves of as many panels have the same knots, which\n"
         "keeps a skin small. The nose is the point farthest from the middle of the trailing edge.\n"
         "Points may run either way, from the nose along both sides as in Lednicer's files, or with\n"
         "the nose on the right; repeated points and the base of a blunt trailing edge are left\n"
         "out; what was put right is remarked. To skin sections together give all of them the same\n"
         "'trailing-edge', for closed curves do not go with open ones.\n"
         "'thickness' changes what each side is above or below the middle between both at the same\n"
         "x, so the camber stays. What 'trailing-edge' adds or takes fades to nothing at the nose;\n"
         "a smaller 'blend' keeps it nearer to the tail. The remarks give both shapes, how far\n"
         "the changes moved a point, and how far the moved points are from the curve; a section\n"
         "that crosses itself is noted with the place.",
         "features:\n"
         "  row: {points: [[1, 0.002], [0.7, 0.055], [0.3, 0.09], [0.05, 0.05], [0, 0], [0.05, -0.03], [0.3, -0.04], [0.7, -0.02], [1, -0.002]]}\n"
         "  root: {aerofoil: row, chord: 2 m, thickness: 0.12, trailing-edge: 0}\n"
         "  tip: {aerofoil: row, chord: 1 m, thickness: 0.1, trailing-edge: 0}\n",
         "[Drela89], [deBoor01]", "batten_curve_aerofoil", BAT_PARAMETERS(parameters), false,
         .also =
             "airfoil, wing section, profile, trailing edge gap, repanel, normalise, chord, "
             "Selig, Lednicer, XFOIL, thickness, camber, foil, rudder, hydrofoil",
         .formula =
             "    y = m(x) ± [k (h(x) − g0 b(x)/2) + g b(x)/2],  b(x) = x exp((1 − x)(1 − 1/blend))",
         .promise =
             "Chord, thickness and trailing edge are measured on the curve that is delivered."},
    .run = run_aerofoil,
    .displacing = "aerofoil"};
