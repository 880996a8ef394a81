#include "base/plural.h"
#include "exchange/bytes.h"
#include "exchange/facets.h"
#include "exchange/formats.h"
#include "exchange/scan.h"
#include "exchange/stl/stl.h"

#include <limits.h>

enum { HEADER = 80, BEFORE = 84, FACET = 50 };

/* ---- which form ---- */

/* Does the text begin as a solid does, and go on as one? */
static bool is_text(const bat_input *input)
{
    bat_span word;
    const size_t at = bat_past_white(input);
    bat_scan words = bat_scan_begin(input->data + at, input->size - at);
    if (!bat_next_word(&words, &word) || !bat_word_is_like(word, "solid"))
        return false;
    bat_stl_name(&words);
    return bat_next_word(&words, &word) &&
           (bat_word_is_like(word, "facet") || bat_word_is_like(word, "endsolid"));
}

/* The count of triangles after a header. */
static uint32_t promised(const bat_input *input)
{
    return bat_bytes_u32(input->data + HEADER);
}

/* Many programs begin the bytes with "solid" too: the size decides. */
static bool has_size_of_bytes(const bat_input *input)
{
    return input->size >= BEFORE &&
           (uint64_t)promised(input) * FACET == (uint64_t)input->size - BEFORE;
}

batten_status bat_stl_recognise(const bat_input *input, bool *is_such)
{
    static const char ending[] = ".stl";
    const size_t length = strlen(input->file), end = sizeof ending - 1;
    const bool is_named =
        length > end && bat_word_is_like((bat_span){input->file + length - end, end}, ending) &&
        input->size >= BEFORE && memchr(input->data, 0, input->size);
    *is_such = has_size_of_bytes(input) || is_text(input) || is_named;
    return BATTEN_OK;
}

/* ---- solids ---- */

batten_status bat_stl_add(bat_stl_solid *solid, int line, size_t index, const double corners[9],
                          const double normal[3])
{
    bat_input *input = solid->input;
    const size_t bad = bat_first_not_finite(corners, 9);
    if (bad < 9) {
        batten_notes_add(input->notes, input->file, line, "",
                         "triangle %zu is left out: %c of its corner %zu is not finite",
                         index + 1, "xyz"[bad % 3], bad / 3 + 1);
        input->left_out++;
        return BATTEN_OK;
    }
    double n[3];
    bat_facet_normal(corners, corners + 3, corners + 6, n);
    if (n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2] < 0)
        solid->against++;
    const size_t most =
        input->limits.entities < INT_MAX / 3 ? input->limits.entities : (size_t)INT_MAX / 3;
    batten_status status =
        bat_input_limit(input, line, solid->points.count + 1, most, "triangles");
    return status == BATTEN_OK ? bat_list_add(input, &solid->points, corners) : status;
}

static batten_status make_mesh(bat_stl_solid *solid, batten_mesh **out)
{
    const size_t count = solid->points.count;
    int *corners = NULL;
    batten_mesh *loose = NULL;
    batten_status status = bat_input_array(solid->input, 3 * count, sizeof *corners, &corners);
    if (status != BATTEN_OK)
        return status;
    for (size_t i = 0; i < 3 * count; i++)
        corners[i] = (int)i;
    const batten_mesh_parts parts = {.vertex_count = (int)(3 * count),
                                     .points = solid->points.items,
                                     .triangle_count = (int)count,
                                     .corners = corners};
    status = batten_mesh_create(&parts, &loose);
    bat_release(corners);
    if (status == BATTEN_OK)
        status = batten_mesh_weld(loose, out);
    batten_mesh_unref(loose);
    return status;
}

batten_status bat_stl_end(bat_stl_solid *solid, const char *name, batten_model *model)
{
    bat_input *input = solid->input;
    batten_mesh *mesh = NULL;
    if (solid->points.count == 0)
        return BATTEN_OK;
    batten_status status = bat_input_limit(input, 0, (size_t)batten_model_count(model) + 1,
                                           input->limits.entities, "solids");
    if (status == BATTEN_OK)
        status = make_mesh(solid, &mesh);
    if (status == BATTEN_OK)
        status = batten_model_add(
            model, &(batten_object){.name = name, .kind = BATTEN_OBJECT_MESH, .mesh = mesh});
    if (status == BATTEN_OK)
        bat_remark_flat(mesh, input->file, name, input->notes);
    if (status == BATTEN_OK && solid->against)
        batten_notes_add(input->notes, input->file, 0, name,
                         "the normals of %d of %zu triangles contradict the order of their "
                         "corners; the order is kept",
                         solid->against, solid->points.count);
    batten_mesh_unref(mesh);
    solid->points.count = 0;
    solid->against = 0;
    return status;
}

/* ---- bytes ---- */

/* How many triangles to read of those that are promised. */
static batten_status count_bytes(bat_input *input, size_t *count)
{
    if (input->size < BEFORE) /* without its byte order mark */
        return bat_input_fail(input, BATTEN_BAD_FORMAT, 0,
                              "a header has %d bytes; the file has %zu", BEFORE, input->size);
    const size_t said = promised(input), room = (input->size - BEFORE) / FACET;
    *count = said < room ? said : room;
    if (*count == 0 && input->size > BEFORE)
        return bat_input_fail(input, BATTEN_BAD_FORMAT, 0,
                              "the header promises %zu triangles, and %zu bytes follow it",
                              said, input->size - BEFORE);
    if (said == 0 || (uint64_t)said * FACET == input->size - BEFORE)
        return BATTEN_OK;
    if (said > room) {
        batten_notes_add(input->notes, input->file, 0, "",
                         "the header promises %zu triangles; the file has room for %zu", said,
                         room);
        input->is_cut = true;
        return BATTEN_OK;
    }
    const size_t behind = input->size - BEFORE - said * FACET;
    if (behind % FACET == 0) {
        batten_notes_add(input->notes, input->file, 0, "",
                         "the header promises %zu triangle%s; %zu more, left out", said,
                         bat_plural(said), behind / FACET);
        input->left_out += (int)(behind / FACET); /* files have at most 1 GiB */
    } else {
        batten_notes_add(input->notes, input->file, 0, "",
                         "bytes after the last of %zu triangles: %zu; not read", said, behind);
    }
    return BATTEN_OK;
}

static batten_status read_facets(bat_stl_solid *solid, size_t count)
{
    bat_input *input = solid->input;
    batten_status status = BATTEN_OK;
    size_t attributes = 0;
    for (size_t i = 0; status == BATTEN_OK && i < count; i++) {
        const char *at = input->data + BEFORE + i * FACET;
        double numbers[12];
        for (int k = 0; k < 12; k++)
            numbers[k] = bat_bytes_float(at + 4 * k, false);
        attributes += at[48] != 0 || at[49] != 0;
        status = bat_stl_add(solid, 0, i, numbers + 3, numbers);
        if (status == BATTEN_OK && i % 10000 == 9999)
            status = bat_input_step(input, (size_t)(at - input->data));
    }
    if (attributes)
        batten_notes_remark(input->notes, input->file, 0, "",
                            "the attribute bytes of %zu triangles are not read", attributes);
    return status;
}

batten_status bat_stl_read_bytes(bat_input *input, batten_model *model)
{
    bat_stl_solid solid = {input, {.size = 9 * sizeof(double)}, 0};
    size_t count = 0;
    batten_status status = count_bytes(input, &count);
    if (status == BATTEN_OK)
        status = read_facets(&solid, count);
    if (status == BATTEN_OK)
        status = bat_stl_end(&solid, "mesh", model);
    bat_release(solid.points.items);
    return status;
}

batten_status bat_read_stl(bat_input *input, batten_model **out)
{
    batten_model *model = NULL;
    const bool bytes = has_size_of_bytes(input) || (!is_text(input) && input->size >= BEFORE &&
                                                    memchr(input->data, 0, input->size));
    /* Zero bytes are also those of text in UTF-16. */
    batten_status status = has_size_of_bytes(input) ? BATTEN_OK
                           : bytes                  ? bat_input_past_mark(input)
                                                    : bat_input_as_text(input);
    if (status == BATTEN_OK && !bytes && !is_text(input))
        status = bat_input_fail(input, BATTEN_BAD_FORMAT, 0,
                                "this is no STL: neither 'solid' and 'facet' nor a header of "
                                "84 bytes and triangles");
    if (status == BATTEN_OK)
        status = batten_model_create(0, &model);
    if (status == BATTEN_OK)
        status = bytes ? bat_stl_read_bytes(input, model) : bat_stl_read_text(input, model);
    if (status == BATTEN_OK && batten_model_count(model) == 0 &&
        (input->left_out > 0 || input->is_cut))
        status = bat_input_fail(input, BATTEN_BAD_FORMAT, 0, "no triangle could be read");
    if (status == BATTEN_OK)
        *out = model;
    else
        batten_model_unref(model);
    return status;
}
