/* Surfaces under a deformation: the image as a formula, and the spline near it. */
#include "shape/deform/lattice.h"
#include "shape/formula/formula.h"

#include <batten/measure.h>
#include <string.h>

typedef struct {
    batten_surface *surface;
    batten_deformation *deformation;
} image;

static batten_status evaluate_image(const void *data, const bat_surface_place *at, int order,
                                    double *out)
{
    const image *i = data;
    double given[3 * BAT_JET_SIZE] = {0};
    const batten_status status = i->surface->kind->evaluate(i->surface, at, order, given);
    if (status != BATTEN_OK)
        return status;
    if (order == 0) {
        bat_deformation_point(i->deformation, given, out);
        return BATTEN_OK;
    }
    bat_jet x[3], y[3];
    for (int c = 0; c < 3; c++)
        for (int m = 0; m < BAT_JET_SIZE; m++)
            x[c].d[m] = given[3 * m + c];
    bat_deformation_jets(i->deformation, x, y);
    for (int m = 0; m < BATTEN_SURFACE_DERIVATIVES(order); m++)
        for (int c = 0; c < 3; c++)
            out[3 * m + c] = y[c].d[m];
    return BATTEN_OK;
}

static void free_image(void *data)
{
    image *i = data;
    batten_surface_unref(i->surface);
    batten_deformation_unref(i->deformation);
    bat_release(i);
}

static const bat_formula formula = {"deformed", evaluate_image, NULL, free_image};

/* How many derivatives do not jump at the inner knots of a surface; of a formula nothing is known. */
static int smoothness_of(const batten_surface *surface, batten_direction direction)
{
    if (surface->kind != &bat_nurbs_kind)
        return 0;
    const bat_axis *axis = &bat_surface_nurbs(surface)->axes[direction];
    return bat_knots_smoothness(axis->degree, axis->count, axis->knots, 2);
}

static batten_status make_image(const batten_surface *surface,
                                const batten_deformation *deformation, batten_surface **out)
{
    bat_formula_axis axes[2];
    double *spans[2] = {NULL, NULL};
    image *made = bat_array(1, sizeof *made);
    batten_status status = made ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        const int count = batten_surface_spans(surface, (batten_direction)k, NULL);
        spans[k] = bat_array((size_t)count, sizeof **spans);
        status = spans[k] ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
        if (status == BATTEN_OK)
            batten_surface_spans(surface, (batten_direction)k, spans[k]);
        axes[k] =
            (bat_formula_axis){count, spans[k], smoothness_of(surface, (batten_direction)k)};
    }
    if (status == BATTEN_OK) {
        *made = (image){batten_surface_ref(surface), batten_deformation_ref(deformation)};
        status = bat_formula_create(&formula, made, 3, &axes[0], &axes[1],
                                    deformation->size + deformation->report.moved, out);
        if (status != BATTEN_OK)
            free_image(made);
    } else
        bat_release(made);
    bat_release(spans[0]);
    bat_release(spans[1]);
    return status;
}

/* The box of the control points suffices as a rule; the tight one takes longer. */
static batten_status check_surface(const batten_surface *surface,
                                   const batten_deformation *deformation)
{
    if (surface->dimension != 3)
        return bat_fail(BATTEN_UNSUPPORTED, "a surface in %d dimensions; 3 are needed",
                        surface->dimension);
    batten_box box = batten_surface_box(surface);
    double error = 0;
    if (bat_deformation_check(deformation, box, "the surface") == BATTEN_OK)
        return BATTEN_OK;
    /* A tenth of what rounding is granted on the sides of the box. */
    const double *e = deformation->extent;
    const double fine = 1e-10 * bat_min(e[0], bat_min(e[1], e[2]));
    const batten_status status = batten_surface_bounds(surface, fine, &error, &box);
    return status == BATTEN_OK ? bat_deformation_check(deformation, box, "the surface")
                               : status;
}

batten_status batten_surface_deform(const batten_surface *surface,
                                    const batten_deformation *deformation, double tolerance,
                                    double *error, batten_surface **out)
{
    assert(surface && deformation && out);
    batten_surface *made = NULL;
    double reached = 0;
    batten_status status = check_surface(surface, deformation);
    if (status == BATTEN_OK && !(tolerance >= 0 && isfinite(tolerance)))
        status = bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g", tolerance);
    if (status == BATTEN_OK)
        status = make_image(surface, deformation, &made);
    if (status == BATTEN_OK && tolerance > 0) {
        batten_surface *near = NULL;
        status =
            bat_surface_approximate(made, tolerance, BAT_APPROXIMATE_MOST, &near, &reached);
        batten_surface_unref(made);
        made = near;
    }
    if (status != BATTEN_OK)
        return status;
    if (error)
        *error = reached;
    *out = made;
    return BATTEN_OK;
}
