/* Both halves of a hull among its surfaces: those of one side must be the images of the other's. */
#include "hydrostatics/hull.h"
#include <batten/nearest.h>

/* A surface is on one side when it crosses the centre plane by no more than this, and is an image
 * when so many points each way are this near to one; both as parts of the size. */
static const double CROSSES = 1e-4, NEAR = 1e-6;
enum { SAMPLES = 5 };

typedef struct {
    double low, high; /* y */
} reach;

static reach reach_of(const batten_surface *surface)
{
    const batten_box box = batten_surface_box(surface);
    return (reach){box.low.y, box.high.y};
}

/* Points of a surface, mirrored. */
static batten_status sample_image(const batten_surface *surface, double *points)
{
    const batten_interval u = batten_surface_domain(surface, BATTEN_U);
    const batten_interval v = batten_surface_domain(surface, BATTEN_V);
    batten_status status = BATTEN_OK;
    for (int i = 0; i < SAMPLES; i++)
        for (int j = 0; j < SAMPLES && status == BATTEN_OK; j++) {
            const double s = i / (SAMPLES - 1.), t = j / (SAMPLES - 1.);
            double *p = points + 3 * (i * SAMPLES + j);
            status = batten_surface_evaluate(surface, (1 - s) * u.a + s * u.b,
                                             (1 - t) * v.a + t * v.b, 0, p);
            p[1] = -p[1];
        }
    return status;
}

static batten_status is_image(const batten_surface *surface, const batten_surface *of,
                              double near, bool *image)
{
    double points[3 * SAMPLES * SAMPLES];
    batten_deviation deviation;
    batten_status status = sample_image(surface, points);
    if (status == BATTEN_OK)
        status = batten_surface_deviation(of, (batten_points){3, SAMPLES * SAMPLES, points},
                                          NULL, NULL, NULL, &deviation);
    *image = status == BATTEN_OK && deviation.max <= near;
    return status;
}

static batten_status find_original(const batten_hull *hull, int index, int count,
                                   const batten_surface *const *surfaces, bool *found)
{
    batten_status status = BATTEN_OK;
    *found = false;
    for (int k = 0; k < count && !*found && status == BATTEN_OK; k++)
        if (reach_of(surfaces[k]).low >= -CROSSES * hull->size && k != index)
            status = is_image(surfaces[index], surfaces[k], NEAR * hull->size, found);
    return status;
}

/* One surface of the side of negative y, or across the plane. */
static batten_status judge_side(const batten_hull *hull, int index, int count,
                                const batten_surface *const *surfaces, bool *image)
{
    const reach r = reach_of(surfaces[index]);
    const double allowed = CROSSES * hull->size;
    if (r.high > allowed)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "surface %d of the hull reaches from y = %g to %g, across the centre "
                        "plane: give one half, or the whole hull with 'whole'",
                        index + 1, r.low, r.high);
    const batten_status status = find_original(hull, index, count, surfaces, image);
    if (status == BATTEN_OK && !*image)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "surface %d of the hull, to y = %g, is no image of one on the other "
                        "side: give one half, or the whole hull with 'whole'",
                        index + 1, r.low);
    return status;
}

batten_status bat_hull_find_images(const batten_hull *hull, int count,
                                   const batten_surface *const *surfaces, bool *images)
{
    bool on_high_side = false;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count; i++)
        on_high_side |= reach_of(surfaces[i]).high > CROSSES * hull->size;
    for (int i = 0; i < count && on_high_side && status == BATTEN_OK; i++)
        if (reach_of(surfaces[i]).low < -CROSSES * hull->size)
            status = judge_side(hull, i, count, surfaces, &images[i]);
    return status;
}
