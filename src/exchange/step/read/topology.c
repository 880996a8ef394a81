/* Faces and shells into the builder of a body. */
#include "exchange/step/read/topology.h"

#include <string.h>

/* What wraps a face or shell may be wrapped again, so often at most. */
enum { WRAPS = 16 };

batten_status bat_step_topology_open(bat_step_file *file, bat_census *census,
                                     bat_step_style *style, const void *context,
                                     bat_step_topology *t)
{
    *t = (bat_step_topology){.file = file,
                             .census = census,
                             .style = style,
                             .context = context,
                             .work = file->input->size + 100000,
                             .edges = {.size = sizeof(bat_step_edge)},
                             .surfaces = {.size = sizeof(batten_surface *)},
                             .roots = {.size = sizeof(int)},
                             .pairs = {.size = sizeof(int)},
                             .counts = {.size = sizeof(int)},
                             .faces = {.size = sizeof(uint32_t)},
                             .uses = {.size = sizeof(bat_step_use)},
                             .loops = {.size = sizeof(int)},
                             .points = {.size = 3 * sizeof(double)}};
    return bat_input_array(file->input, file->instances.count + 1, sizeof *t->made, &t->made);
}

static void drop_surfaces(bat_step_topology *t)
{
    batten_surface **surfaces = t->surfaces.items;
    for (size_t k = 0; k < t->surfaces.count; k++)
        batten_surface_unref(surfaces[k]);
    t->surfaces.count = 0;
}

void bat_step_topology_close(bat_step_topology *t)
{
    bat_list *lists[] = {&t->edges, &t->surfaces, &t->roots, &t->pairs, &t->counts,
                         &t->faces, &t->uses,     &t->loops, &t->points};
    if (t->body)
        bat_builder_end(&t->builder);
    drop_surfaces(t);
    for (size_t k = 0; k < sizeof lists / sizeof lists[0]; k++)
        bat_release(lists[k]->items);
    bat_release(t->made);
}

void bat_step_body_begin(bat_step_topology *t, const bat_step_scale *scale)
{
    t->body++;
    t->scale = *scale;
    bat_builder_begin(&t->builder, scale->tolerance);
    drop_surfaces(t);
    t->edges.count = t->roots.count = t->faces.count = 0;
    if (t->pairs.count)
        memset(t->pairs.items, 0xff, t->pairs.count * sizeof(int));
    t->pair_count = 0;
    t->has_spline = false;
    t->left_out = 0;
}

/* Edges get the vertices that stand for theirs. */
static void apply_roots(bat_step_topology *t)
{
    batten_body_edge *edges = (batten_body_edge *)(uintptr_t)t->builder.parts.edges;
    for (int i = 0; t->roots.count && i < t->builder.parts.edge_count; i++)
        for (int k = 0; k < 2; k++)
            edges[i].vertices[k] = bat_step_root(t, edges[i].vertices[k]);
}

batten_status bat_step_body_end(bat_step_topology *t, bool is_solid, batten_body **out)
{
    *out = NULL;
    if (t->builder.parts.face_count == 0) {
        bat_builder_end(&t->builder);
        return BATTEN_OK;
    }
    apply_roots(t);
    batten_status status = bat_step_sort_edges(t);
    if (status == BATTEN_OK)
        return bat_builder_finish(&t->builder, is_solid, out);
    bat_builder_end(&t->builder);
    return status;
}

/* ---- faces ---- */

/* Through the ORIENTED_FACEs to the face itself. */
static batten_status unwrap_face(const bat_step_topology *t, const bat_step_instance **face,
                                 bool *flipped)
{
    const bat_step_instance *outer = *face;
    for (int k = 0; k < WRAPS; k++) {
        const bat_step_record *record = bat_step_as(t->file, *face, "ORIENTED_FACE");
        bool forward = true;
        if (!record)
            return BATTEN_OK;
        batten_status status = bat_step_get_reference(t->file, record, 2, face);
        if (status == BATTEN_OK)
            status = bat_step_get_logical(t->file, record, 3, &forward);
        if (status != BATTEN_OK)
            return status;
        *flipped ^= !forward;
    }
    return bat_step_fail(t->file, outer, BATTEN_BAD_FORMAT, "it refers to itself");
}

static const bat_step_record *face_record(const bat_step_topology *t,
                                          const bat_step_instance *face)
{
    static const char *const keywords[] = {"ADVANCED_FACE", "FACE_SURFACE", "FACE"};
    for (size_t k = 0; k < sizeof keywords / sizeof keywords[0]; k++) {
        const bat_step_record *record = bat_step_as(t->file, face, keywords[k]);
        if (record && bat_step_argument_count(t->file, record) >= 2)
            return record;
    }
    return NULL;
}

/* The face with its loops, on the surface argument 2 says, or on a plane of its own. */
static batten_status put_face(bat_step_topology *t, const bat_step_instance *face,
                              const bat_step_record *record, bool flipped)
{
    const bat_step_instance *geometry = NULL;
    batten_surface *surface = NULL;
    char name[256] = "";
    bool forward = true, is_file = false, is_against = false;
    const bool is_bare = bat_step_argument_count(t->file, record) == 2;
    batten_status status = bat_step_get_string(t->file, record, 0, sizeof name, name);
    if (status == BATTEN_OK && !is_bare)
        status = bat_step_get_reference(t->file, record, 2, &geometry);
    if (status == BATTEN_OK && !is_bare)
        status = bat_step_get_logical(t->file, record, 3, &forward);
    if (status == BATTEN_OK)
        status = is_bare ? bat_step_polygon_plane(t, face, &surface)
                         : bat_step_face_surface(t, geometry, &surface, &is_file, &is_against);
    if (status != BATTEN_OK)
        return status;
    /* The plane of a polygon was made of its loop as it runs now. */
    batten_body_face made = {.name = name,
                             .surface = surface,
                             .reversed = is_bare ? false : (forward == flipped) != is_against};
    t->style(t->context, face, &made);
    status = bat_builder_face(&t->builder, &made);
    if (status == BATTEN_OK)
        status = bat_step_put_loops(t, is_file ? geometry : NULL);
    batten_surface_unref(surface);
    t->has_spline |= is_file;
    return status;
}

static batten_status read_face(bat_step_topology *t, const bat_step_instance *outer,
                               bool flipped)
{
    char keyword[BAT_STEP_KEYWORD_SIZE];
    const bat_step_instance *face = outer;
    const int mark = bat_builder_mark(&t->builder);
    batten_status status = bat_input_step(t->file->input, outer->at);
    if (status != BATTEN_OK)
        return status;
    status = unwrap_face(t, &face, &flipped);
    const bat_step_record *record = status == BATTEN_OK ? face_record(t, face) : NULL;
    bat_step_made *made = bat_step_made_of(t, face);
    if (status == BATTEN_OK && !record)
        status = bat_step_fail(t->file, face, BATTEN_BAD_FORMAT,
                               "it is given where a face is expected");
    if (status == BATTEN_OK && made->stamp == bat_step_stamp(t, BAT_STEP_FACE))
        status = bat_step_fail(t->file, face, BATTEN_BAD_FORMAT,
                               "the face is part of two shells, or twice of one");
    if (status == BATTEN_OK)
        status = bat_step_read_bounds(t, face, record, flipped);
    if (status == BATTEN_OK)
        status = put_face(t, face, record, flipped);
    const uint32_t index = bat_step_index(t->file, face);
    if (status == BATTEN_OK)
        status = bat_list_add(t->file->input, &t->faces, &index);
    if (status == BATTEN_OK) {
        made->stamp = bat_step_stamp(t, BAT_STEP_FACE);
        return bat_census_read(t->file->input, t->census,
                               bat_step_keyword(t->file, face, keyword));
    }
    bat_builder_back(&t->builder, mark);
    t->left_out++;
    return bat_step_leave_out(t->file, t->census, face, status);
}

batten_status bat_step_body_face(bat_step_topology *t, const bat_step_instance *instance)
{
    batten_status status = bat_builder_shell(&t->builder, false);
    return status == BATTEN_OK ? read_face(t, instance, false) : status;
}

/* ---- shells ---- */

static batten_status unwrap_shell(const bat_step_topology *t, const bat_step_instance **shell,
                                  bool *flipped)
{
    const bat_step_instance *outer = *shell;
    for (int k = 0; k < WRAPS; k++) {
        const bat_step_record *record = bat_step_as(t->file, *shell, "ORIENTED_CLOSED_SHELL");
        bool forward = true;
        if (!record)
            record = bat_step_as(t->file, *shell, "ORIENTED_OPEN_SHELL");
        if (!record)
            return BATTEN_OK;
        batten_status status = bat_step_get_reference(t->file, record, 2, shell);
        if (status == BATTEN_OK)
            status = bat_step_get_logical(t->file, record, 3, &forward);
        if (status != BATTEN_OK)
            return status;
        *flipped ^= !forward;
    }
    return bat_step_fail(t->file, outer, BATTEN_BAD_FORMAT, "it refers to itself");
}

static const bat_step_record *shell_record(const bat_step_topology *t,
                                           const bat_step_instance *shell, bool *closed)
{
    static const char *const keywords[] = {"CLOSED_SHELL", "OPEN_SHELL", "CONNECTED_FACE_SET"};
    for (size_t k = 0; k < sizeof keywords / sizeof keywords[0]; k++) {
        const bat_step_record *record = bat_step_as(t->file, shell, keywords[k]);
        *closed = k == 0;
        if (record && bat_step_argument_count(t->file, record) >= 2)
            return record;
    }
    return NULL;
}

/* Edges with one use in the faces from `mark` on, in a shell that is said to be closed. */
static batten_status check_closed(bat_step_topology *t, const bat_step_instance *shell,
                                  int mark)
{
    const batten_body_parts *p = &t->builder.parts;
    const int none = 0;
    int open = 0;
    batten_status status = BATTEN_OK;
    if (mark >= p->face_count)
        return BATTEN_OK;
    const int first_loop = p->faces[mark].first;
    const int first = first_loop < p->loop_count ? p->loops[first_loop].first : p->use_count;
    while (status == BATTEN_OK && t->counts.count < (size_t)p->edge_count)
        status = bat_list_add(t->file->input, &t->counts, &none);
    if (status != BATTEN_OK)
        return status;
    int *counts = t->counts.items; /* zero before and after */
    for (int i = first; i < p->use_count; i++)
        counts[p->uses[i].edge]++;
    for (int i = first; i < p->use_count; i++)
        open += counts[p->uses[i].edge] == 1 && p->edges[p->uses[i].edge].curve;
    for (int i = first; i < p->use_count; i++)
        counts[p->uses[i].edge] = 0;
    if (open)
        bat_step_warn(t->file, shell,
                      "it is declared closed, but %d of its edges are of one face only: not "
                      "watertight",
                      open);
    return BATTEN_OK;
}

batten_status bat_step_body_shell(bat_step_topology *t, const bat_step_instance *instance,
                                  bool reversed)
{
    const bat_step_instance *shell = instance;
    const int mark = bat_builder_mark(&t->builder), left_out = t->left_out;
    int count = 0;
    size_t at = 0;
    bool flipped = reversed, closed = false;
    batten_status status = unwrap_shell(t, &shell, &flipped);
    if (status != BATTEN_OK)
        return status;
    const bat_step_record *record = shell_record(t, shell, &closed);
    if (!record)
        return bat_step_fail(t->file, shell, BATTEN_BAD_FORMAT,
                             "it is given where a shell is expected");
    status = bat_step_get_list(t->file, record, 1, &count, &at);
    if (status == BATTEN_OK && count == 0)
        return bat_step_fail(t->file, shell, BATTEN_BAD_FORMAT, "the shell has no faces");
    if (status == BATTEN_OK)
        status = bat_step_spend(t, shell, (size_t)count);
    if (status == BATTEN_OK)
        status = bat_builder_shell(&t->builder, closed);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        const bat_step_instance *face = NULL;
        status = bat_step_item_reference(t->file, record, &at, &face);
        if (status == BATTEN_OK) {
            status = read_face(t, face, flipped);
        } else {
            t->left_out++;
            status = bat_step_leave_out(t->file, t->census, shell, status);
        }
    }
    if (status == BATTEN_OK && closed && t->left_out == left_out)
        status = check_closed(t, shell, mark);
    return status;
}
