/* A section along two rails. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/sweep/motion_rails.h"
#include "shape/sweep/true_sweep.h"
#include "spline/curve/curve.h"
#include <batten/approximate.h>

batten_surface_two_rails_options batten_surface_two_rails_defaults(void)
{
    return (batten_surface_two_rails_options){.size = sizeof(batten_surface_two_rails_options),
                                              .tolerance = 1e-6, /* with metres, a micrometre */
                                              .degree = 3};
}

/* The section with its ends in (0, 0) and (1, 0); *chord is how far they were apart. */
static batten_status stretch(const batten_curve *section, batten_curve **out, double *chord)
{
    batten_curve *space = NULL;
    batten_status status = batten_curve_to_dimension(section, 3, &space);
    if (status != BATTEN_OK)
        return status;
    const batten_interval domain = batten_curve_domain(space);
    double a[3] = {0}, b[3] = {0};
    status = batten_curve_evaluate(space, domain.a, 0, a);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(space, domain.b, 0, b);
    const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
    const double size = bat_largest(3 * space->count, space->points);
    const double length = bat_norm(2, (const double[2]){x, y});
    *chord = length;
    if (status == BATTEN_OK && !(*chord > BAT_ROUNDING * size))
        status =
            bat_fail(BATTEN_COINCIDENT,
                     "the section begins and ends in the same place, (%g, %g)", a[0], a[1]);
    if (status == BATTEN_OK && fabs(z) > BAT_ROUNDING * size)
        status =
            bat_fail(BATTEN_NOT_COMPATIBLE,
                     "the section begins at z = %g and ends at z = %g: its chord is laid from "
                     "rail to rail, so it must be drawn in the xy-plane",
                     a[2], b[2]);
    const double c = x / length, n = y / length; /* cosine and sine */
    const batten_affine map = {
        {{c / length, n / length, 0}, {-n / length, c / length, 0}, {0, 0, 1 / length}},
        {-(c * a[0] + n * a[1]) / length, (n * a[0] - c * a[1]) / length, -a[2] / length}};
    if (status == BATTEN_OK)
        status = batten_curve_transform(space, &map, out);
    batten_curve_unref(space);
    return status;
}

static batten_status take_rail(const batten_curve *given,
                               const batten_surface_two_rails_options *o, batten_curve **out,
                               double *error)
{
    batten_curve *space = NULL;
    batten_curve_even_speed_report report = {.error = 0};
    batten_status status = batten_curve_to_dimension(given, 3, &space);
    if (status == BATTEN_OK && o->match == BATTEN_RAILS_BY_LENGTH)
        status = batten_curve_even_speed(space, o->tolerance / 10, &report, out);
    else if (status == BATTEN_OK)
        *out = batten_curve_ref(space);
    *error = bat_max(*error, report.error);
    batten_curve_unref(space);
    return status;
}

static batten_status check_section(const batten_surface_two_rails_options *o)
{
    if (!isfinite(o->tolerance))
        return bat_fail(BATTEN_NOT_FINITE, "the tolerance is %g", o->tolerance);
    if (!(o->tolerance > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", o->tolerance);
    const double across = bat_vec3_norm(o->across);
    if (!isfinite(across))
        return bat_fail(BATTEN_NOT_FINITE, "the planes are across (%g, %g, %g)", o->across.x,
                        o->across.y, o->across.z);
    if (o->match == BATTEN_RAILS_BY_PLANES && across == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the planes have no direction across them");
    return BATTEN_OK;
}

/* The motion of the section, whose chord was so long. */
static batten_status make_motion(const batten_curve *first, const batten_curve *second,
                                 double chord, const batten_surface_two_rails_options *o,
                                 bat_motion **out, double *error)
{
    batten_curve *rails[2] = {NULL, NULL};
    batten_status status = take_rail(first, o, &rails[0], error);
    if (status == BATTEN_OK)
        status = take_rail(second, o, &rails[1], error);
    if (status == BATTEN_OK) {
        bat_rails between = {.rails = {rails[0], rails[1]},
                             .height = o->fixed_height ? chord : 0,
                             .tolerance = o->tolerance};
        if (o->match == BATTEN_RAILS_BY_PLANES)
            between.across = bat_vec3_scale(o->across, 1 / bat_vec3_norm(o->across));
        status = bat_motion_between(&between, out);
    }
    batten_curve_unref(rails[1]);
    batten_curve_unref(rails[0]);
    return status;
}

batten_status
batten_surface_two_rails(const batten_curve *section, const batten_curve *const rails[2],
                         const batten_surface_two_rails_options *options, const batten_job *job,
                         batten_surface_sweep_report *report, batten_surface **out)
{
    assert(section && rails[0] && rails[1] && out);
    batten_surface_two_rails_options chosen = batten_surface_two_rails_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_two_rails_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const batten_surface_two_rails_options *o = &chosen;
    batten_surface_sweep_report found = {.clearance = 1};
    bat_sweep sweep = {0};
    bat_work work = {job, 0};
    double chord = 0, moved = 0;
    status = check_section(o);
    if (status == BATTEN_OK)
        status = stretch(section, &sweep.section, &chord);
    if (status == BATTEN_OK)
        status = make_motion(rails[0], rails[1], chord, o, &sweep.motion, &moved);
    if (status == BATTEN_OK) {
        sweep.part = (batten_interval){0, 1};
        status = bat_sweep_fit(&sweep, o->degree, o->tolerance - moved, &work, &found, out);
    }
    bat_sweep_release(&sweep);
    found.error += moved;
    if (status == BATTEN_OK && report)
        *report = found;
    return status;
}
