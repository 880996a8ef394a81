/* Meshes for the tests of their formats, and what must hold of every one of these. */
#ifndef TESTS_EXCHANGE_MESHES_H
#define TESTS_EXCHANGE_MESHES_H
#include "exchange/reading.h"

static inline const batten_mesh_parts *mesh_at(const batten_model *model, int index)
{
    CHECK(batten_model_object(model, index)->kind == BATTEN_OBJECT_MESH);
    return batten_mesh_view(batten_model_object(model, index)->mesh);
}

static inline void add_mesh(batten_model *model, const char *name,
                            const batten_mesh_parts *parts)
{
    batten_mesh *mesh = NULL;
    CHECK_OK(batten_mesh_create(parts, &mesh));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = name, .kind = BATTEN_OBJECT_MESH, .mesh = mesh}));
    batten_mesh_unref(mesh);
}

/* A tetrahedron whose coordinates floats hold, and its corners. */
static const double tetrahedron_points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
static const int tetrahedron_corners[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};

static inline batten_mesh_parts tetrahedron(void)
{
    return (batten_mesh_parts){.vertex_count = 4,
                               .points = tetrahedron_points,
                               .triangle_count = 4,
                               .corners = tetrahedron_corners};
}

static inline bool same_rows(const double *a, const double *b, size_t count)
{
    return (!a && !b) || (a && b && memcmp(a, b, count * sizeof *a) == 0);
}

static inline void check_same_mesh(const batten_mesh_parts *a, const batten_mesh_parts *b)
{
    CHECK_INT(b->vertex_count, a->vertex_count);
    CHECK_INT(b->triangle_count, a->triangle_count);
    CHECK(same_rows(a->points, b->points, 3 * (size_t)a->vertex_count));
    CHECK(memcmp(a->corners, b->corners, 3 * (size_t)a->triangle_count * sizeof(int)) == 0);
    CHECK(same_rows(a->normals, b->normals, 9 * (size_t)a->triangle_count));
    CHECK((a->colours == NULL) == (b->colours == NULL));
    for (int i = 0; a->colours && i < 3 * a->vertex_count; i++)
        CHECK_NEAR(b->colours[i], a->colours[i], 0.5 / 255 + 1e-15);
    CHECK_INT(b->attribute_count, a->attribute_count);
    for (int k = 0; k < a->attribute_count; k++) {
        CHECK_TEXT(b->attributes[k].name, a->attributes[k].name);
        CHECK(same_rows(a->attributes[k].values, b->attributes[k].values,
                        (size_t)a->vertex_count));
    }
}

static inline batten_status write_form(const batten_model *model, batten_format format,
                                       bool as_text, batten_notes *notes, char **data,
                                       size_t *size)
{
    batten_write_options options = batten_write_defaults();
    options.format = format;
    options.as_text = as_text;
    return batten_write_memory(model, &options, notes, data, size);
}

/* Written, read and written again it is the same bytes; the model that was read. */
static inline batten_model *check_second(const batten_model *model, batten_format format,
                                         bool as_text)
{
    char *first = NULL, *second = NULL;
    size_t first_size = 0, second_size = 0;
    batten_model *back = NULL;
    CHECK_OK(write_form(model, format, as_text, NULL, &first, &first_size));
    CHECK_OK(read_bytes(first, first_size, format, NULL, &back));
    CHECK_OK(write_form(back, format, as_text, NULL, &second, &second_size));
    CHECK_INT((long long)second_size, (long long)first_size);
    CHECK(memcmp(first, second, first_size) == 0);
    batten_release(first);
    batten_release(second);
    return back;
}

/* Cut anywhere before `whole` bytes it is refused, or read in part. */
static inline void check_cuts(const char *data, size_t whole, batten_format format)
{
    char *memory = test_array(whole, 1);
    for (size_t k = 0; k < whole; k++) {
        batten_model *model = NULL;
        char *copy = memory + whole - k; /* reading past the end shows under the sanitizer */
        memcpy(copy, data, k);
        batten_status status = read_bytes(copy, k, format, NULL, &model);
        if (test_memory_failed(status, BATTEN_BAD_FORMAT))
            status = read_bytes(copy, k, format, NULL, &model);
        CHECK(status != BATTEN_OK);
        CHECK((status == BATTEN_PARTLY_READ) == (model != NULL));
        batten_model_unref(model);
    }
}

/* Read in part, with a note that has these words. */
static inline batten_model *read_partly(const char *data, size_t size, batten_format format,
                                        const char *words)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_STATUS(read_bytes(data, size, format, notes, &model), BATTEN_PARTLY_READ);
    if (batten_notes_dropped(notes) == 0 && !has_note(notes, words))
        CHECK_TEXT(batten_notes_count(notes) ? batten_notes_at(notes, 0)->text : "", words);
    batten_notes_free(notes);
    return model;
}

#endif
