/* Recognises STL, and reads it as text or as bytes. */
#include "base/plural.h"
#include "exchange/meshes/facets.h"
#include "exchange/reading/bytes.h"
#include "exchange/reading/scan.h"
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

static batten_status read_bytes(bat_input *input, batten_model *model)
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
                                "this is not STL: it has neither 'solid' and 'facet' nor a "
                                "header of "
                                "84 bytes and triangles");
    if (status == BATTEN_OK)
        status = batten_model_create(0, &model);
    if (status == BATTEN_OK)
        status = bytes ? read_bytes(input, model) : bat_stl_read_text(input, model);
    if (status == BATTEN_OK && batten_model_count(model) == 0 &&
        (input->left_out > 0 || input->is_cut))
        status = bat_input_fail(input, BATTEN_BAD_FORMAT, 0, "no triangle could be read");
    return bat_input_hand_over(status, model, out);
}
