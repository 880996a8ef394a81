/* The feature 'developable': a plate that bends from flat sheet. */
#include "base/plural.h"
#include "design/feature.h"

#include <batten/plate.h>

static const batten_parameter parameters[] = {
    {"developable", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "the two edges, in the same direction"},
    {"match", BATTEN_VALUE_WORD, false, false, "planes", "planes parameter",
     "rulings with one tangent plane; or between equal parameters, with the warp stated"},
    {"warp", BATTEN_VALUE_ANGLE, false, false, "0.5 deg", NULL,
     "the largest angle between the normals at the ends of a ruling that counts as "
     "developable"},
    {"regression", BATTEN_VALUE_WORD, false, false, "refuse", "refuse keep",
     "what becomes of plates whose rulings meet between the edges, or that fold back"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how closely the edges are followed; the tolerance of the design by default"},
};

static void report_developable(bat_run *run, const batten_developable *made)
{
    const double degree = BAT_PI / 180;
    bat_remark(run, "%s: warp at most %.4g degree%s, at u = %.4g; %d rulings%s%s",
               made->is_developable ? "developable" : "not developable", made->warp / degree,
               bat_plural_real(made->warp / degree, 4), made->warp_at, made->count,
               made->cone[0] ? ", begins with a cone" : "",
               made->cone[1] ? ", ends with a cone" : "");
    if (!made->is_developable)
        bat_note(run,
                 "warped by %.4g degree%s at u = %.4g: more than the %.4g that counts as "
                 "developable",
                 made->warp / degree, bat_plural_real(made->warp / degree, 4), made->warp_at,
                 bat_number(run, "warp") / degree);
    if (made->has_regression)
        bat_note(run, "rulings meet between the edges, at %.4g of the ruling at u = %.4g",
                 made->regression_share, made->regression_at);
}

static batten_status develop(bat_run *run, const batten_curve *first,
                             const batten_curve *second)
{
    batten_surface_developable_options options = batten_surface_developable_defaults();
    batten_developable made = {0};
    options.keep_matching = bat_word(run, "match") == 1;
    options.keep_regression = bat_word(run, "regression") == 1;
    options.warp = bat_number(run, "warp");
    options.tolerance = bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    batten_status status = batten_surface_developable(first, second, &options, &made);
    if (status == BATTEN_OK) {
        report_developable(run, &made);
        bat_report_error(run, made.error, made.error);
        status = bat_put_surface(run, status, batten_surface_ref(made.surface));
    }
    batten_developable_release(&made);
    return status;
}

static batten_status run_developable(bat_run *run)
{
    bat_objects curves;
    batten_status status = bat_gather(run, "developable", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    if (curves.count == 2)
        status = develop(run, curves.at[0]->curve, curves.at[1]->curve);
    else
        status = batten_fail(BATTEN_BAD_ARGUMENT, "a plate lies between 2 edges, not %d",
                             curves.count);
    bat_objects_release(&curves);
    return status;
}

const bat_feature bat_feature_developable = {
    .shown =
        {"developable", "A plate that bends from flat sheet",
         "The developable surface between two edges: along each ruling one plane touches it, so it\n"
         "is made from sheet without stretching. Where one edge ends before the other, the rest is\n"
         "a cone. Between edges that allow no developable surface it is the surface of nearly the\n"
         "least warp, and the warp is reported. 'unroll' lays it flat; 'cone-to' makes cones. u\n"
         "runs along the edges, v from the first to the second.",
         "features:\n"
         "  k: {points: [[0, 0, 0], [2 m, 0, -0.1 m], [4 m, 0, 0.2 m]]}\n"
         "  keel: {interpolate: k}\n"
         "  c: {points: [[0, 0.5 m, 0.2 m], [2 m, 0.7 m, 0.1 m], [4 m, 0.1 m, 0.5 m]]}\n"
         "  chine: {interpolate: c}\n"
         "  bottom: {developable: [keel, chine]}\n"
         "  sheet: {unroll: bottom}\n",
         "[PW01], [Aumann91]", "batten_surface_developable", BAT_PARAMETERS(parameters), false,
         .also = "developable surface, plate, torse, single curvature, sheet metal, hull plate",
         .formula =
             "    det(c1′(s), c2′(t), c2(t) − c1(s)) = 0 along each ruling from c1(s) to c2(t)",
         .promise =
             "Where the edges allow it one plane touches along each ruling; else the warp is near the least and reported."},
    .run = run_developable};
