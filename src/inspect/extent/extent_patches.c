/* The Bezier patches of a surface whose extent is sought, cut at its creases. */
#include "inspect/extent/extent_patches.h"
#include "spline/surface/surface.h"

/* ---- patches of a surface ---- */

void bat_extent_patches_end(bat_extent_patches *p)
{
    batten_surface_unref(p->bezier);
    for (int k = 0; k < 2; k++) {
        bat_release(p->breaks[k]);
        bat_release(p->creases[k]);
    }
}

/* Inner knots as often there as the degree says. */
static void find_creases(const batten_surface *surface, batten_direction along, int count,
                         const double *breaks, bool *creases)
{
    const double *knots = batten_surface_knots(surface, along);
    const int n = batten_surface_knot_count(surface, along);
    const int degree = batten_surface_degree(surface, along);
    for (int i = 0, k = 0; i < count; i++) {
        int times = 0;
        for (; k < n && knots[k] <= breaks[i]; k++)
            times += knots[k] == breaks[i];
        creases[i] = i > 0 && i + 1 < count && times >= degree;
    }
}

batten_status bat_extent_patches_begin(const batten_surface *surface, bat_extent_patches *p)
{
    *p = (bat_extent_patches){.bezier = NULL};
    batten_status status = batten_surface_to_bezier(surface, &p->bezier);
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        const batten_direction along = (batten_direction)k;
        const int count = batten_surface_spans(surface, along, NULL);
        p->spans[k] = count - 1;
        p->breaks[k] = bat_array((size_t)count, sizeof *p->breaks[k]);
        p->creases[k] = bat_array((size_t)count, sizeof *p->creases[k]);
        if (!p->breaks[k] || !p->creases[k]) {
            status = BATTEN_OUT_OF_MEMORY;
            break;
        }
        batten_surface_spans(surface, along, p->breaks[k]);
        find_creases(surface, along, count, p->breaks[k], p->creases[k]);
    }
    return status;
}
