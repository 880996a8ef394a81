/* CURVE_BOUNDED_SURFACE: a face whose bounds are curves without vertices. */
#include "exchange/step/read/topology.h"
#include "numeric/vector.h"

/* The curve of a boundary is one edge, or one for each of its segments as they follow. */
static batten_status read_boundary(bat_step_topology *t, const bat_step_instance *instance)
{
    batten_curve *curve = NULL;
    bat_step_use use = {0, false};
    const int one = 1;
    batten_status status = bat_step_read_curve(t->file, instance, &t->scale, &curve);
    if (status == BATTEN_OK)
        status = bat_step_spend(t, instance, (size_t)batten_curve_point_count(curve));
    if (status == BATTEN_OK)
        status = bat_step_add_edge(t, instance, curve, &use.edge);
    batten_curve_unref(curve);
    if (status == BATTEN_OK && bat_step_end_of(t, &use, 0) != bat_step_end_of(t, &use, 1))
        return bat_step_fail(t->file, instance, BATTEN_BAD_FORMAT,
                             "the boundary is not closed");
    if (status == BATTEN_OK)
        status = bat_list_add(t->file->input, &t->uses, &use);
    return status == BATTEN_OK ? bat_list_add(t->file->input, &t->loops, &one) : status;
}

static batten_status read_boundaries(bat_step_topology *t, const bat_step_record *record)
{
    int count = 0;
    size_t at = 0;
    t->uses.count = t->loops.count = 0;
    t->vertex_loop = -1;
    batten_status status = bat_step_get_list(t->file, record, 2, &count, &at);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        const bat_step_instance *boundary = NULL;
        status = bat_step_item_reference(t->file, record, &at, &boundary);
        if (status == BATTEN_OK)
            status = read_boundary(t, boundary);
    }
    return status;
}

static batten_status put_boundary(bat_step_topology *t, const batten_surface *surface,
                                  const char *name, bool reversed)
{
    const bat_step_use *uses = t->uses.items;
    const batten_body_face face = {.name = name, .surface = surface, .reversed = reversed};
    batten_status status = bat_builder_shell(&t->builder, false);
    if (status == BATTEN_OK)
        status = bat_builder_face(&t->builder, &face);
    for (size_t k = 0; status == BATTEN_OK && k < t->uses.count; k++) {
        status = bat_builder_loop(&t->builder);
        if (status == BATTEN_OK)
            status = bat_builder_use(&t->builder, uses[k].edge, false, NULL);
    }
    return status;
}

batten_status bat_step_body_bounded(bat_step_topology *t, const bat_step_instance *instance)
{
    const bat_step_record *record = bat_step_as(t->file, instance, "CURVE_BOUNDED_SURFACE");
    const bat_step_instance *basis = NULL;
    batten_surface *surface = NULL;
    char name[256] = "";
    bool implicit = false, is_file = false, is_against = false;
    const int mark = bat_builder_mark(&t->builder);
    if (!record)
        return bat_step_fail(t->file, instance, BATTEN_BAD_FORMAT,
                             "it is given where a CURVE_BOUNDED_SURFACE is expected");
    batten_status status = bat_step_get_string(t->file, record, 0, sizeof name, name);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(t->file, record, 1, &basis);
    if (status == BATTEN_OK)
        status = bat_step_get_logical(t->file, record, 3, &implicit);
    if (status == BATTEN_OK)
        status = read_boundaries(t, record);
    if (status == BATTEN_OK && implicit && t->loops.count)
        status = bat_step_fail(t->file, instance, BATTEN_UNSUPPORTED,
                               "holes in a whole surface are not read");
    if (status == BATTEN_OK)
        status = bat_step_face_surface(t, basis, &surface, &is_file, &is_against);
    if (status == BATTEN_OK)
        status = put_boundary(t, surface, name, is_against);
    if (status != BATTEN_OK)
        bat_builder_back(&t->builder, mark);
    batten_surface_unref(surface);
    return status;
}
