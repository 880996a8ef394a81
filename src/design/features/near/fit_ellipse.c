/* The feature 'fit-ellipse': the ellipse nearest to points of a plane. */
#include "design/features/near/primitive.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"fit-ellipse", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "points in a plane, or a table of offsets"},
    BAT_WHOLE,
    BAT_EACH,
};

/* The same curve from its end to its start, on [0, 1] again. */
static batten_status turn_back(batten_curve **curve)
{
    batten_curve *reversed = NULL, *made = NULL;
    batten_status status = batten_curve_reverse(*curve, &reversed);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(reversed, 0, 1, &made);
    batten_curve_unref(reversed);
    if (status == BATTEN_OK) {
        batten_curve_unref(*curve);
        *curve = made;
    }
    return status;
}

/* As the data run; the ellipse about the origin goes to its place. */
static batten_status draw_fit_ellipse(const batten_fitted_ellipse *e, bool whole,
                                      batten_curve **out)
{
    const double angle = whole ? 2 * BAT_PI : fabs(e->angle),
                 start = e->angle < 0 ? e->start - angle : e->start;
    const batten_affine map = {{{e->axis[0], -e->axis[1], 0}, {e->axis[1], e->axis[0], 0}},
                               {e->center[0], e->center[1], 0}};
    batten_curve *centred = NULL;
    batten_status status = batten_curve_ellipse(e->a, e->b, start, angle, &centred);
    if (status == BATTEN_OK && e->angle < 0)
        status = turn_back(&centred);
    if (status == BATTEN_OK)
        status = batten_curve_transform(centred, &map, out);
    batten_curve_unref(centred);
    return status;
}

static batten_status make_fit_ellipse(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_fitted_ellipse ellipse;
    batten_primitive_report report;
    batten_status status =
        batten_ellipse_fit((batten_points){2, data->count, data->points}, &report, &ellipse);
    if (status == BATTEN_OK) {
        made->has_parameters = false;
        bat_remark(run, "'%s': an ellipse with the semi-axes %.9g and %.9g", data->name,
                   ellipse.a, ellipse.b);
        status = draw_fit_ellipse(&ellipse, bat_yes(run, "whole"), &made->curve);
    }
    return bat_made_primitive(&report, status, made);
}

static batten_status run_fit_ellipse(bat_run *run)
{
    static const bat_method method = {5, BAT_IN_PLANE, make_fit_ellipse};
    return bat_through(run, &method);
}

const bat_feature bat_feature_fit_ellipse = {
    .shown =
        {"fit-ellipse", "The ellipse nearest to points of a plane",
         "For holes seen at an angle, pipe cuts, sterns and arches. It starts from a direct fit\n"
         "that cannot give any other conic, and then makes the sum of squared perpendicular\n"
         "distances least. The semi-axes are noted. With 'whole: no' only the part beside the\n"
         "points is drawn. Five points are needed; a short arc determines its ellipse poorly.\n"
         "Points on a line, and points from which the ellipse grows without end because they bend\n"
         "as a parabola or a hyperbola does, are refused.",
         "features:\n"
         "  marks: {points: [[2 m, 0], [1.4 m, 0.7 m], [0, 1 m], [-1.4 m, 0.7 m], [-2 m, 0], [0, -1 m]]}\n"
         "  arch: {fit-ellipse: marks}\n",
         "[FPF99], [HF98]", "batten_ellipse_fit", BAT_PARAMETERS(parameters), false,
         .also = "best ellipse, Fitzgibbon, Halir Flusser",
         .formula = "    Σ dist(Q_j, E)² → minimum over ellipses E",
         .promise =
             "The sum of squared distances at right angles is a minimum; never another conic."},
    .run = run_fit_ellipse};
