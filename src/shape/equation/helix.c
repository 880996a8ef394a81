/* The helix, by its equations. */
#include "base/base.h"

#include <batten/contours.h>

static batten_status check_helix(batten_interval radius, double pitch, double turns)
{
    if (!isfinite(radius.a) || !isfinite(radius.b) || !isfinite(pitch) || !isfinite(turns))
        return bat_fail(BATTEN_NOT_FINITE, "a number of the helix is not finite");
    if (radius.a < 0 || radius.b < 0 || !(radius.a + radius.b > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "radii of %g and %g; none may be below 0, nor may both be 0", radius.a,
                        radius.b);
    /* Each turn takes some ten pieces. */
    const double most = 10000;
    if (!(turns > 0) || turns > most)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%g turns; more than 0 and at most %g are needed",
                        turns, most);
    return BATTEN_OK;
}

batten_status batten_curve_helix(batten_interval radius, double pitch, double turns,
                                 double tolerance, double *error, batten_curve **out)
{
    static const char *const variable[] = {"t"};
    static const char *const texts[] = {"(r + g*t) * cos(2*pi*t)", "(r + g*t) * sin(2*pi*t)",
                                        "p*t"};
    batten_status status = check_helix(radius, pitch, turns);
    if (status != BATTEN_OK)
        return status;
    const batten_equation_constant constants[] = {
        {"r", radius.a}, {"g", (radius.b - radius.a) / turns}, {"p", pitch}};
    const batten_equation_names names = {1, 3, variable, constants};
    batten_equation *read[3] = {NULL, NULL, NULL};
    batten_equation_curves made = {0};
    for (int k = 0; k < 3 && status == BATTEN_OK; k++)
        status = batten_equation_read(texts[k], &names, &read[k]);
    if (status == BATTEN_OK)
        status = batten_curve_parametric(3, (const batten_equation *const *)read,
                                         (batten_interval){0, turns}, tolerance, NULL, &made);
    if (status == BATTEN_OK) {
        *error = made.error;
        *out = batten_curve_ref(made.curves[0]);
    }
    batten_equation_curves_release(&made);
    for (int k = 0; k < 3; k++)
        batten_equation_free(read[k]);
    return status;
}
