/* Triangles of a whole surface: as of a body of one face. */
#include "base/plural.h"
#include "body/border.h"
#include "numeric/box.h"

#include <batten/mesh.h>
#include <float.h>

/* The size of a surface, for what counts as the same point on its border. */
static double size_of(const batten_surface *surface)
{
    return bat_box_diagonal(batten_surface_box(surface));
}

static batten_status whole(const batten_surface *surface, batten_body **out)
{
    bat_builder builder;
    bat_border_count count = {0};
    /* Borders are computed twice, from both of their ends: what is one differs by rounding. */
    const double tolerance = bat_max(1e-9 * size_of(surface), DBL_MIN);
    bat_builder_begin(&builder, tolerance);
    batten_status status = bat_builder_shell(&builder, false);
    if (status == BATTEN_OK)
        status = bat_builder_face(&builder, &(batten_body_face){.surface = surface});
    if (status == BATTEN_OK)
        status = bat_border_loop(&builder, surface, false, tolerance, &count);
    builder.parts.is_traced = true;
    if (status == BATTEN_OK)
        return bat_builder_finish(&builder, false, out);
    bat_builder_end(&builder);
    return status;
}

batten_status batten_mesh_from_surface(const batten_surface *surface,
                                       const batten_mesh_options *options,
                                       const batten_job *job, batten_mesh_report *report,
                                       batten_mesh **out)
{
    assert(surface && out);
    batten_mesh_options chosen = batten_mesh_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_mesh_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    batten_body *body = NULL;
    if (batten_surface_dimension(surface) != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the surface has %d dimension%s, not 3",
                        batten_surface_dimension(surface),
                        bat_plural(batten_surface_dimension(surface)));
    status = whole(surface, &body);
    if (status == BATTEN_OK)
        status = batten_mesh_from_body(body, &chosen, job, NULL, report, out);
    batten_body_unref(body);
    return status;
}
