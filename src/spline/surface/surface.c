/* Surfaces of any kind: keeping them, and asking their kind. */
#include "spline/surface/surface.h"

#include <stdint.h>

batten_surface *batten_surface_ref(const batten_surface *surface)
{
    /* What is const to the holder is the shape; the count behind it is not part of it. */
    batten_surface *shared = (batten_surface *)(uintptr_t)surface;
    bat_references_add(&shared->references);
    return shared;
}

void batten_surface_unref(batten_surface *surface)
{
    if (surface && bat_references_drop(&surface->references))
        surface->kind->free(surface);
}

const char *batten_surface_kind(const batten_surface *surface)
{
    return surface->kind->name;
}

int batten_surface_dimension(const batten_surface *surface)
{
    return surface->dimension;
}

batten_interval batten_surface_domain(const batten_surface *surface, batten_direction direction)
{
    return surface->kind->domain(surface, direction);
}

int batten_surface_spans(const batten_surface *surface, batten_direction direction,
                         double *knots)
{
    return surface->kind->spans(surface, direction, knots);
}

bool batten_surface_is_closed(const batten_surface *surface, batten_direction direction,
                              double tolerance)
{
    assert(surface);
    return surface->kind->is_closed(surface, direction, tolerance);
}

batten_box batten_surface_box(const batten_surface *surface)
{
    return surface->kind->box(surface);
}

batten_status batten_surface_to_nurbs(const batten_surface *surface, double tolerance,
                                      double *error, batten_surface **out)
{
    assert(surface && out);
    return surface->kind->to_nurbs(surface, tolerance, out, error);
}

batten_status batten_surface_transform(const batten_surface *surface, const batten_affine *map,
                                       batten_surface **out)
{
    assert(surface && map && out);
    return surface->kind->transform(surface, map, out);
}

batten_status batten_surface_transform_sides(const batten_surface *surface,
                                             const batten_affine *map, batten_surface **out)
{
    assert(surface && map && out);
    batten_surface *image = NULL;
    batten_status status = surface->kind->transform(surface, map, &image);
    if (status != BATTEN_OK)
        return status;
    if (surface->dimension < 3 || !(batten_affine_determinant(*map) < 0)) {
        *out = image;
        return BATTEN_OK;
    }
    status = image->kind->turn_over(image, out);
    batten_surface_unref(image);
    return status;
}

batten_status batten_surface_isocurve(const batten_surface *surface, batten_direction direction,
                                      double at, batten_curve **out)
{
    assert(surface && out && (direction == BATTEN_U || direction == BATTEN_V));
    return surface->kind->isocurve(surface, direction, at, out);
}

bool batten_surface_is_periodic(const batten_surface *surface, batten_direction direction)
{
    return surface->kind->is_periodic(surface, direction);
}

void batten_surfaces_release(batten_surfaces *surfaces)
{
    for (int i = 0; i < surfaces->count; i++)
        batten_surface_unref(surfaces->at[i]);
    bat_release(surfaces->at);
    *surfaces = (batten_surfaces){0, NULL};
}
