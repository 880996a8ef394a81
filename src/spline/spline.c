/* Allocation and release of the polynomial spline that curves and surfaces are built on. */
#include "spline/spline.h"

batten_status bat_spline_make(int degree, int count, size_t width, bat_spline *out)
{
    bat_spline made = {.degree = degree, .count = count, .width = width};
    made.knots = bat_array((size_t)count + (size_t)degree + 1, sizeof *made.knots);
    made.values = bat_array3((size_t)count, width, sizeof *made.values);
    if (!made.knots || !made.values) {
        bat_spline_free(&made);
        return BATTEN_OUT_OF_MEMORY;
    }
    *out = made;
    return BATTEN_OK;
}

void bat_spline_free(bat_spline *spline)
{
    bat_release(spline->knots);
    bat_release(spline->values);
    *spline = (bat_spline){0};
}
