/*
 * Triangles of AP242 as meshes. Each face has its own part of a list of coordinates:
 *
 *     TRIANGULATED_FACE, COMPLEX_TRIANGULATED_FACE
 *         (name, coordinates, pnmax, normals, link, pnindex, ...)
 *     TRIANGULATED_SURFACE_SET, COMPLEX_TRIANGULATED_SURFACE_SET: the same without the link
 *
 * The plain ones end with triangles, the complex ones with strips and fans.
 */
#include "base/plural.h"
#include "exchange/step/read/import.h"

#include <limits.h>
#include <string.h>

typedef struct {
    const bat_step_target *target;
    const bat_step_file *file;
    bat_list points;    /* double[3] */
    bat_list triangles; /* int[3] */
    bat_list lists;     /* listed */
} mesh;

/* Where the points of a COORDINATES_LIST begin. */
typedef struct {
    uint32_t instance;
    int first, count;
} listed;

static const char *const wholes[] = {"TESSELLATED_SOLID", "TESSELLATED_SHELL",
                                     "TESSELLATED_GEOMETRIC_SET"};
static const struct {
    const char *keyword;
    int index; /* argument pnindex */
    bool is_complex;
} faces[] = {{"TRIANGULATED_FACE", 5, false},
             {"COMPLEX_TRIANGULATED_FACE", 5, true},
             {"TRIANGULATED_SURFACE_SET", 4, false},
             {"COMPLEX_TRIANGULATED_SURFACE_SET", 4, true}};
enum { FACES = sizeof faces / sizeof faces[0], WHOLES = sizeof wholes / sizeof wholes[0] };

static int face_kind(const bat_step_file *file, const bat_step_instance *item)
{
    for (int k = 0; k < FACES; k++)
        if (bat_step_as(file, item, faces[k].keyword))
            return k;
    return -1;
}

static const bat_step_record *whole(const bat_step_file *file, const bat_step_instance *item)
{
    for (int k = 0; k < WHOLES; k++) {
        const bat_step_record *record = bat_step_as(file, item, wholes[k]);
        if (record)
            return record;
    }
    return NULL;
}

bool bat_step_is_tessellated(const bat_step_file *file, const bat_step_instance *item)
{
    return face_kind(file, item) >= 0 || whole(file, item);
}

/* ---- coordinates ---- */

static batten_status read_coordinates(mesh *m, const bat_step_instance *instance, listed *out)
{
    const bat_step_record *record = bat_step_as(m->file, instance, "COORDINATES_LIST");
    const double scale = m->target->scale.length;
    int count = 0;
    size_t at = 0;
    if (!record)
        return bat_step_fail(m->file, instance, BATTEN_BAD_FORMAT,
                             "it is given where a COORDINATES_LIST is expected");
    batten_status status = bat_step_get_list(m->file, record, 2, &count, &at);
    if (status == BATTEN_OK && m->points.count + (size_t)count > INT_MAX)
        status =
            bat_step_fail(m->file, instance, BATTEN_TOO_LARGE, "there are too many points");
    *out = (listed){bat_step_index(m->file, instance), (int)m->points.count, count};
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        double point[3] = {0, 0, 0};
        int inner = 0;
        size_t number = 0;
        status = bat_step_item_list(m->file, record, &at, &inner, &number);
        if (status == BATTEN_OK && inner != 3)
            status = bat_step_fail(m->file, instance, BATTEN_BAD_FORMAT,
                                   "point %d has %d coordinates", k + 1, inner);
        for (int d = 0; status == BATTEN_OK && d < 3; d++) {
            status = bat_step_item_real(m->file, record, &number, &point[d]);
            point[d] *= scale;
        }
        if (status == BATTEN_OK)
            status = bat_list_add(m->file->input, &m->points, point);
    }
    return status == BATTEN_OK ? bat_list_add(m->file->input, &m->lists, out) : status;
}

/* Faces that follow one another mostly share their list. */
static batten_status find_coordinates(mesh *m, const bat_step_instance *instance, listed *out)
{
    const listed *lists = m->lists.items;
    if (m->lists.count &&
        lists[m->lists.count - 1].instance == bat_step_index(m->file, instance)) {
        *out = lists[m->lists.count - 1];
        return BATTEN_OK;
    }
    batten_status status = read_coordinates(m, instance, out);
    return status == BATTEN_OK
               ? bat_step_spend(&m->target->import->topology, instance, (size_t)out->count)
               : status;
}

/* ---- triangles ---- */

typedef struct {
    mesh *m;
    const bat_step_instance *face;
    const bat_step_record *record;
    listed list;
    int count; /* of pnindex; 0: it numbers the list itself */
    int *numbers;
} corners;

static batten_status corner(const corners *c, size_t *at, int *out)
{
    int number = 0;
    const int most = c->count ? c->count : c->list.count;
    batten_status status = bat_step_item_integer(c->m->file, c->record, at, &number);
    if (status == BATTEN_OK && (number < 1 || number > most))
        status = bat_step_fail(c->m->file, c->face, BATTEN_BAD_FORMAT,
                               "a corner is point %d, of %d", number, most);
    if (status == BATTEN_OK)
        *out = c->list.first + (c->count ? c->numbers[number - 1] : number - 1);
    return status;
}

static batten_status add_triangle(mesh *m, int a, int b, int c)
{
    const int triangle[3] = {a, b, c};
    return a == b || b == c || a == c ? BATTEN_OK
                                      : bat_list_add(m->file->input, &m->triangles, triangle);
}

typedef enum { TRIANGLES, STRIPS, FANS } form;

/* A list of rows of corners. */
static batten_status read_rows(const corners *c, int argument, form as)
{
    int rows = 0;
    size_t at = 0;
    batten_status status = bat_step_get_list(c->m->file, c->record, argument, &rows, &at);
    for (int k = 0; status == BATTEN_OK && k < rows; k++) {
        int count = 0, last[2] = {0, 0}, next = 0;
        size_t item = 0;
        status = bat_step_item_list(c->m->file, c->record, &at, &count, &item);
        if (status == BATTEN_OK && (count < 3 || (as == TRIANGLES && count != 3)))
            status = bat_step_fail(c->m->file, c->face, BATTEN_BAD_FORMAT,
                                   "row %d of triangles has %d corner%s", k + 1, count,
                                   bat_plural(count));
        for (int i = 0; status == BATTEN_OK && i < count; i++) {
            status = corner(c, &item, &next);
            if (status == BATTEN_OK && i >= 2)
                /* In a strip every second triangle runs the other way. */
                status = as == STRIPS && i % 2 ? add_triangle(c->m, last[1], last[0], next)
                                               : add_triangle(c->m, last[0], last[1], next);
            if (i == 0 || (as == STRIPS && i >= 2))
                last[0] = i == 0 ? next : last[1];
            if (i > 0)
                last[1] = next;
        }
    }
    return status;
}

static batten_status read_numbers(corners *c, int argument)
{
    size_t at = 0;
    batten_status status = bat_step_get_list(c->m->file, c->record, argument, &c->count, &at);
    if (status == BATTEN_OK && c->count)
        status = bat_input_array(c->m->file->input, (size_t)c->count, sizeof *c->numbers,
                                 &c->numbers);
    for (int k = 0; status == BATTEN_OK && k < c->count; k++) {
        status = bat_step_item_integer(c->m->file, c->record, &at, &c->numbers[k]);
        if (status == BATTEN_OK && (c->numbers[k] < 1 || c->numbers[k] > c->list.count))
            status = bat_step_fail(c->m->file, c->face, BATTEN_BAD_FORMAT,
                                   "index %d is point %d, of %d", k + 1, c->numbers[k],
                                   c->list.count);
        c->numbers[k]--;
    }
    return status;
}

static batten_status read_face(mesh *m, const bat_step_instance *face)
{
    const int kind = face_kind(m->file, face);
    const size_t triangles = m->triangles.count;
    const bat_step_instance *list = NULL;
    corners c = {.m = m, .face = face};
    if (kind < 0)
        return bat_step_fail(m->file, face, BATTEN_UNSUPPORTED,
                             "it is not a face of "
                             "triangles");
    c.record = bat_step_as(m->file, face, faces[kind].keyword);
    const int index = faces[kind].index;
    batten_status status = bat_step_get_reference(m->file, c.record, 1, &list);
    if (status == BATTEN_OK)
        status = find_coordinates(m, list, &c.list);
    if (status == BATTEN_OK)
        status = read_numbers(&c, index);
    if (status == BATTEN_OK)
        status = read_rows(&c, index + 1, faces[kind].is_complex ? STRIPS : TRIANGLES);
    if (status == BATTEN_OK && faces[kind].is_complex)
        status = read_rows(&c, index + 2, FANS);
    if (status != BATTEN_OK)
        m->triangles.count = triangles;
    bat_release(c.numbers);
    return status;
}

/* ---- the whole ---- */

static batten_status read_faces(mesh *m, const bat_step_instance *item)
{
    bat_step_import *import = m->target->import;
    const bat_step_record *record = whole(m->file, item);
    int count = 0;
    size_t at = 0;
    if (!record)
        return read_face(m, item);
    batten_status status = bat_step_get_list(m->file, record, 1, &count, &at);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        const bat_step_instance *face = NULL;
        status = bat_step_item_reference(m->file, record, &at, &face);
        if (status == BATTEN_OK)
            status = bat_step_spend(&import->topology, item, 1);
        if (status != BATTEN_OK)
            return status;
        status = read_face(m, face);
        if (status != BATTEN_OK)
            status = bat_step_leave_out(m->file, &import->census, face, status);
    }
    if (status == BATTEN_OK && m->triangles.count == 0)
        status = bat_step_fail(m->file, item, BATTEN_BAD_FORMAT, "it has no triangles");
    return status;
}

static batten_status add_mesh(const bat_step_target *target, const bat_step_instance *item,
                              const mesh *m)
{
    const batten_mesh_parts parts = {.vertex_count = (int)m->points.count,
                                     .points = m->points.items,
                                     .triangle_count = (int)m->triangles.count,
                                     .corners = m->triangles.items};
    const bat_step_instance *from[] = {item};
    batten_object object = {.kind = BATTEN_OBJECT_MESH};
    batten_mesh *made = NULL;
    char name[BAT_STEP_NAME];
    batten_status status = batten_mesh_create(&parts, &made);
    if (status != BATTEN_OK)
        return status;
    object.mesh = made;
    bat_step_dress(target, 1, from, &object, name);
    status = bat_step_add_object(target, item, &object);
    batten_mesh_unref(made);
    return status;
}

batten_status bat_step_read_tessellated(const bat_step_target *target,
                                        const bat_step_instance *item)
{
    bat_step_import *import = target->import;
    mesh m = {.target = target,
              .file = &import->file,
              .points = {.size = 3 * sizeof(double)},
              .triangles = {.size = 3 * sizeof(int)},
              .lists = {.size = sizeof(listed)}};
    batten_status status = read_faces(&m, item);
    if (status == BATTEN_OK && m.triangles.count > INT_MAX / 4)
        status = bat_step_fail(&import->file, item, BATTEN_TOO_LARGE,
                               "there are too many triangles");
    status = status == BATTEN_OK
                 ? add_mesh(target, item, &m)
                 : bat_step_leave_out(&import->file, &import->census, item, status);
    bat_release(m.points.items);
    bat_release(m.triangles.items);
    bat_release(m.lists.items);
    return status;
}
