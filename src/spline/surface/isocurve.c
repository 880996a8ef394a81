/* Curves of constant parameter on NURBS surfaces. */
#include "spline/surface/surface.h"

#include "spline/curve/curve.h"
#include "spline/surface/kernel.h"

#include <string.h>

void bat_nurbs_row(const bat_nurbs *nurbs, batten_direction direction, double at,
                   batten_side side, int order, double *row)
{
    const bat_axis *axis = &nurbs->axes[direction];
    const size_t width = nurbs->width, line = (size_t)nurbs->axes[BATTEN_V].count * width;
    const int span = bat_axis_span(axis, at, side);
    const size_t first = (size_t)bat_axis_first_point(axis, span);
    double all[3 * (BATTEN_MAX_DEGREE + 1)];
    assert(order <= 2);
    bat_axis_basis(axis, span, at, order, all);
    const double *basis = all + order * (axis->degree + 1);
    if (direction == BATTEN_U) {
        bat_combine_rows(axis->degree + 1, line, basis, nurbs->net + first * line, line, row);
        return;
    }
    for (size_t i = 0; i < (size_t)nurbs->axes[BATTEN_U].count; i++)
        bat_combine_rows(axis->degree + 1, width, basis, nurbs->net + i * line + first * width,
                         width, row + i * width);
}

static void fill_curve(const bat_nurbs *nurbs, const double *row, batten_curve *curve)
{
    const int d = curve->dimension;
    for (int i = 0; i < curve->count; i++, row += nurbs->width) {
        double *point = curve->points + i * d;
        if (nurbs->weights) {
            bat_project(d, row, point);
            curve->weights[i] = row[d] / nurbs->weight_scale;
        } else {
            memcpy(point, row, (size_t)d * sizeof *point);
        }
    }
}

batten_status bat_nurbs_isocurve(const batten_surface *surface, batten_direction direction,
                                 double at, batten_curve **out)
{
    const bat_nurbs *nurbs = bat_nurbs_of(surface);
    const bat_axis *along = &nurbs->axes[bat_other(direction)];
    batten_status status = bat_axis_place(&nurbs->axes[direction], BATTEN_FROM_RIGHT, &at);
    if (status != BATTEN_OK)
        return status;
    double *row = bat_array3((size_t)along->count, nurbs->width, sizeof *row);
    batten_curve *curve = NULL;
    status = row ? bat_curve_make(surface->dimension, along->degree, along->count,
                                  nurbs->weights != NULL, &curve)
                 : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        bat_nurbs_row(nurbs, direction, at, BATTEN_FROM_RIGHT, 0, row);
        fill_curve(nurbs, row, curve);
        memcpy(curve->knots, along->knots,
               ((size_t)along->count + (size_t)along->degree + 1) * sizeof *curve->knots);
        curve->periodic = along->periodic;
        status = bat_curve_finish(curve, out);
    }
    bat_release(row);
    return status;
}
