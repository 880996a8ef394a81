/* The faces of a solid: 510 over its loops 508. */
#include "exchange/iges/read/attributes.h"
#include "exchange/iges/read/references.h"
#include "exchange/iges/read/solid.h"
#include "exchange/iges/read/surfaces.h"
#include "exchange/iges/read/topology.h"
#include <string.h>

/* A loop going along an edge, as 508 says it. */
typedef struct {
    int edge;
    bool reversed;
    batten_curve *flat;
} use;

typedef struct {
    bat_iges_reading *reading;
    bat_builder *builder;
    bat_iges_ground *ground;
    bat_list uses;  /* of use: all loops, one after another */
    bat_list loops; /* of size_t: how many uses each has */
    bool reversed;
} face_of_solid;

static void end_face(face_of_solid *face)
{
    use *uses = face->uses.items;
    for (size_t k = 0; k < face->uses.count; k++)
        batten_curve_unref(uses[k].flat);
    bat_release(face->uses.items);
    bat_release(face->loops.items);
}

batten_status bat_iges_open_part(bat_iges_reading *reading, const bat_iges_entry *entry,
                                 bat_iges_item *item)
{
    batten_status status = bat_iges_open(reading, entry, item);
    bat_iges_shape_of(reading, entry)->is_met = true;
    if (status == BATTEN_OK && entry->transform)
        status =
            bat_fail(BATTEN_UNSUPPORTED, "the matrix of D%d, a part, is not read", entry->id);
    return status;
}

/* ---- 508: loops ---- */

/* The curve in (u, v) of the edge, when there is one and it says something. */
static batten_status read_flat(const bat_iges_item *item, face_of_solid *face, size_t at,
                               int count, use *made)
{
    const batten_curve *curve = NULL;
    int id = 0;
    if (count != 1 || !face->ground->has_parameters)
        return BATTEN_OK;
    batten_status status = bat_iges_integer(item->parameters, at + 6, &id);
    if (status == BATTEN_OK && id == 0)
        return BATTEN_OK;
    if (status == BATTEN_OK)
        status = bat_iges_curve(face->reading, id, &curve);
    return status == BATTEN_OK
               ? bat_iges_flatten(face->ground, curve,
                                  face->builder->parts.edges[made->edge].curve, &made->flat)
               : status;
}

/* From *at on: TYPE (1: a vertex, as at a pole), list, number, OF, K, then K times ISOP, curve.
 */
static batten_status read_use(const bat_iges_item *item, face_of_solid *face, size_t *at)
{
    int v[4] = {0}, count = 0;
    use made = {0, false, NULL};
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < 4; k++)
        status = bat_iges_integer(item->parameters, *at + k, &v[k]);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(item, *at + 4, *at + 5, 2, &count);
    if (status == BATTEN_OK && v[0] != 1) {
        status = bat_iges_body_edge(face->reading, face->builder, v[1], v[2], &made.edge);
        made.reversed = v[3] == 0;
        if (status == BATTEN_OK)
            status = read_flat(item, face, *at, count, &made);
        if (status == BATTEN_OK)
            status = bat_list_add(face->reading->input, &face->uses, &made);
        if (status == BATTEN_OK)
            ((size_t *)face->loops.items)[face->loops.count - 1]++;
        else
            batten_curve_unref(made.flat);
    }
    *at += 5 + 2 * (size_t)count;
    return status;
}

static batten_status read_loop(face_of_solid *face, int id)
{
    const bat_iges_entry *entry = NULL;
    bat_iges_item item;
    const size_t none = 0;
    size_t at = 2;
    int count = 0;
    batten_status status = bat_iges_find_type(face->reading, id, 508, &entry);
    if (status != BATTEN_OK)
        return status;
    status = bat_iges_open_part(face->reading, entry, &item);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(&item, 1, 2, 5, &count);
    if (status == BATTEN_OK)
        status = bat_list_add(face->reading->input, &face->loops, &none);
    for (int k = 0; status == BATTEN_OK && k < count; k++)
        status = read_use(&item, face, &at);
    bat_iges_close(&item);
    return status == BATTEN_OK ? bat_iges_count_read(face->reading, 508) : status;
}

/* ---- 510: faces ---- */

/* The part of an elementary surface that the edges need. */
static batten_status make_surface(face_of_solid *face, batten_surface **made)
{
    bat_list points = {.size = 3 * sizeof(double)};
    const use *uses = face->uses.items;
    bat_elementary *elementary = &face->ground->elementary;
    bat_around around;
    double error = 0;
    batten_status status = bat_around_begin(elementary, face->ground->tolerance, &around);
    for (size_t k = 0; status == BATTEN_OK && k < face->uses.count; k++) {
        const batten_curve *curve = face->builder->parts.edges[uses[k].edge].curve;
        status = bat_iges_sample(face->reading, curve, &points);
        if (status == BATTEN_OK)
            status = bat_around_add(&around, curve, uses[k].reversed);
    }
    elementary->goes_on = status == BATTEN_OK && bat_around_is_once(&around);
    if (status == BATTEN_OK)
        status = bat_elementary_surface(elementary, (int)points.count, points.items,
                                        face->ground->tolerance, made, &error);
    bat_release(points.items);
    return status;
}

static batten_status put_loops(const face_of_solid *face)
{
    const use *uses = face->uses.items;
    const size_t *counts = face->loops.items;
    batten_status status = BATTEN_OK;
    size_t first = 0;
    for (size_t l = 0; status == BATTEN_OK && l < face->loops.count; l++) {
        if (counts[l] > 0)
            status = bat_builder_loop(face->builder);
        for (size_t k = 0; status == BATTEN_OK && k < counts[l]; k++) {
            const use *u = &uses[first + (face->reversed ? counts[l] - 1 - k : k)];
            status =
                bat_builder_use(face->builder, u->edge, u->reversed != face->reversed, u->flat);
        }
        first += counts[l];
    }
    return status;
}

/* Name and colour of the face, and all of it into the builder. */
static batten_status put_face(bat_iges_item *item, face_of_solid *face)
{
    batten_surface *made = NULL;
    char *name = NULL;
    batten_body_face plain = {.reversed = face->reversed};
    batten_status status = face->ground->is_elementary ? make_surface(face, &made) : BATTEN_OK;
    if (status == BATTEN_OK)
        status = bat_iges_given_name(item, &name);
    if (status == BATTEN_OK)
        status = bat_iges_colour(face->reading, item->entry, &plain.has_colour, plain.colour);
    if (status == BATTEN_OK) {
        plain.name = name;
        plain.surface = made ? made : face->ground->surface;
        status = bat_builder_face(face->builder, &plain);
    }
    if (status == BATTEN_OK)
        status = put_loops(face);
    bat_release(name);
    batten_surface_unref(made);
    return status;
}

static double miss_of(const face_of_solid *face)
{
    const use *uses = face->uses.items;
    double miss = 0;
    for (size_t k = 0; k < face->uses.count; k++)
        miss = bat_max(miss, bat_iges_miss(face->ground,
                                           face->builder->parts.edges[uses[k].edge].curve,
                                           uses[k].flat));
    return miss;
}

batten_status bat_iges_put_face_of(bat_iges_item *item, bool agrees, bat_builder *builder)
{
    bat_iges_face plain;
    face_of_solid face = {.reading = item->reading,
                          .builder = builder,
                          .uses = {.size = sizeof(use)},
                          .loops = {.size = sizeof(size_t)},
                          .reversed = !agrees};
    int surface = 0, count = 0, id = 0;
    batten_status status = bat_iges_integer(item->parameters, 1, &surface);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(item, 2, 4, 1, &count);
    if (status != BATTEN_OK)
        return status;
    item->own = 4 + (size_t)count;
    bat_iges_face_begin(item->reading, item->entry, &plain);
    status = bat_iges_set_ground(&plain, surface);
    face.ground = &plain.ground;
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        status = bat_iges_integer(item->parameters, 4 + (size_t)k, &id);
        if (status == BATTEN_OK)
            status = read_loop(&face, id);
    }
    if (status == BATTEN_OK)
        status = put_face(item, &face);
    if (status == BATTEN_OK)
        item->reading->body_miss = bat_max(item->reading->body_miss, miss_of(&face));
    end_face(&face);
    bat_iges_face_end(&plain);
    return status;
}

batten_status bat_iges_add_face(bat_iges_reading *reading, int id, bool agrees,
                                bat_builder *builder, bool *whole)
{
    const bat_iges_entry *entry = NULL;
    bat_iges_item item;
    const int mark = bat_builder_mark(builder);
    batten_status status = bat_iges_find_type(reading, id, 510, &entry);
    if (status != BATTEN_OK)
        return status;
    status = bat_iges_open_part(reading, entry, &item);
    if (status == BATTEN_OK)
        status = bat_iges_put_face_of(&item, agrees, builder);
    bat_iges_close(&item);
    if (status == BATTEN_OK)
        return bat_iges_count_read(reading, 510);
    if (!bat_iges_is_fault_of_data(status))
        return status;
    bat_builder_back(builder, mark);
    bat_iges_note(reading, entry, "%.300s; the face is left out", batten_message());
    reading->input->left_out++;
    *whole = false;
    return bat_census_leave(reading->input, &reading->census,
                            bat_iges_row_of(reading, 510)->name);
}
