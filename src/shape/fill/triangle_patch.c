/* Transfinite triangles: from the ribbons to the surface that evaluates the formula. */
#include "shape/fill/triangle_patch.h"

#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <string.h>

/* Nearer to corners 1 and 2, in both parameters, derivatives are those at this distance: beyond
 * it quotients of squares of distances would lose all digits of second derivatives. */
#define NEAR 1e-6
/* Nearer, a point is the corner, but for rounding. */
#define AT_CORNER 1e-14

/* ---- the formula ---- */

static void place_at(double u, double v, bat_triangle_place *at)
{
    const bat_jet U = bat_jet_u(u), V = bat_jet_v(v), one = bat_jet_constant(1);
    at->b[0] = bat_jet_subtract(one, U);
    at->b[1] = bat_jet_multiply(U, bat_jet_subtract(one, V));
    at->b[2] = bat_jet_multiply(U, V);
    at->along[0] = V; /* u cancels: no quotient at the pole */
    for (int i = 1; i < 3; i++) {
        const bat_jet second = at->b[(i + 2) % 3];
        at->along[i] = bat_jet_divide(second, bat_jet_add(at->b[(i + 1) % 3], second));
    }
}

static void jets_at(const bat_triangle_patch *patch, double u, double v, bat_jets *out)
{
    bat_triangle_place at;
    place_at(u, v, &at);
    *out = (bat_jets){0};
    switch (patch->method) {
    case BATTEN_TRIANGLE_SIDE_VERTEX:
        bat_triangle_side_vertex(patch, &at, out);
        break;
    case BATTEN_TRIANGLE_PARALLELS:
        bat_triangle_parallels(patch, &at, out);
        break;
    case BATTEN_TRIANGLE_CORNERS:
        bat_triangle_corners(patch, &at, out);
        break;
    }
}

static batten_status evaluate(const void *data, const bat_surface_place *at, int order,
                              double *out)
{
    const bat_triangle_patch *patch = data;
    const double u = at->u, v = at->v;
    bat_jets value;
    const bool at_1 = 1 - u < NEAR && v < NEAR, at_2 = 1 - u < NEAR && 1 - v < NEAR;
    if (order > 0 && (at_1 || at_2)) {
        jets_at(patch, 1 - NEAR, at_1 ? NEAR : 1 - NEAR, &value);
        for (int i = 1; i < BATTEN_SURFACE_DERIVATIVES(order); i++)
            for (int c = 0; c < 3; c++)
                out[3 * i + c] = value.x[c].d[i];
    }
    if (1 - u < AT_CORNER && (v < AT_CORNER || 1 - v < AT_CORNER)) {
        memcpy(out, patch->corner[at_1 ? 1 : 2], sizeof patch->corner[0]);
        return BATTEN_OK;
    }
    jets_at(patch, u, v, &value);
    const int count = at_1 || at_2 ? 1 : BATTEN_SURFACE_DERIVATIVES(order);
    for (int i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            out[3 * i + c] = value.x[c].d[i];
    return BATTEN_OK;
}

static void patch_free(void *data)
{
    bat_triangle_patch *patch = data;
    for (int e = 0; e < 3; e++) {
        batten_curve_unref(patch->sides[e].curve);
        batten_curve_unref(patch->sides[e].slope);
    }
    bat_release(patch);
}

/* ---- making one ---- */

static batten_status check_ribbons(const batten_ribbon ribbons[3], double tolerance,
                                   double angle_tolerance)
{
    if (!(tolerance >= 0 && isfinite(tolerance)) ||
        !(angle_tolerance >= 0 && isfinite(angle_tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerances are %g and %g", tolerance,
                        angle_tolerance);
    for (int i = 0; i < 3; i++) {
        const batten_curve *curve = ribbons[i].curve, *slope = ribbons[i].slope;
        if (batten_curve_dimension(curve) != 3 || (slope && batten_curve_dimension(slope) != 3))
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "curve %d or its slope is not of dimension 3 but %d", i + 1,
                            batten_curve_dimension(curve));
    }
    return BATTEN_OK;
}

/* A coordinate as large as any: three times that of the curves and slopes, for what bulges. */
static double size_of(const bat_triangle_patch *patch)
{
    double size = 0;
    for (int e = 0; e < 3; e++) {
        const batten_box box = batten_curve_box(patch->sides[e].curve);
        const double ends[6] = {box.low.x,  box.low.y,  box.low.z,
                                box.high.x, box.high.y, box.high.z};
        size = bat_max(size, bat_largest(6, ends));
        if (patch->smooth)
            size = bat_max(size, bat_max(bat_largest(3, patch->sides[e].ends[0]),
                                         bat_largest(3, patch->sides[e].ends[1])));
    }
    return 3 * size;
}

static batten_status create_surface(bat_triangle_patch *patch, batten_surface **out)
{
    static const char *const kinds[] = {"side-vertex", "barnhill-birkhoff-gordon",
                                        "charrot-gregory"};
    static const double u[] = {0, 1};
    const bat_formula formula = {
        .kind = kinds[patch->method], .evaluate = evaluate, .free = patch_free};
    const batten_curve *first = patch->sides[0].curve;
    const int count = batten_curve_spans(first, NULL);
    double *v = bat_array((size_t)count, sizeof *v);
    if (!v)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(first, v);
    const bat_formula_axis axes[2] = {{2, u, 2}, {count, v, 1}};
    const batten_status status =
        bat_formula_create(&formula, patch, 3, &axes[0], &axes[1], size_of(patch), out);
    bat_release(v);
    return status;
}

batten_status batten_triangle_patch(const batten_ribbon ribbons[3],
                                    batten_triangle_method method, double tolerance,
                                    double angle_tolerance, batten_surface **out)
{
    assert(ribbons && ribbons[0].curve && ribbons[1].curve && ribbons[2].curve && out);
    const batten_curve *curves[3] = {ribbons[0].curve, ribbons[1].curve, ribbons[2].curve};
    batten_loop_place places[3];
    batten_status status = check_ribbons(ribbons, tolerance, angle_tolerance);
    if (status == BATTEN_OK)
        status = batten_curves_loop(3, curves, tolerance, places);
    if (status != BATTEN_OK)
        return status;
    bat_triangle_patch *patch = bat_array(1, sizeof *patch);
    if (!patch)
        return BATTEN_OUT_OF_MEMORY;
    patch->method = method;
    status = bat_triangle_fill(ribbons, places, angle_tolerance, patch);
    if (status == BATTEN_OK)
        status = create_surface(patch, out);
    if (status != BATTEN_OK)
        patch_free(patch);
    return status;
}
