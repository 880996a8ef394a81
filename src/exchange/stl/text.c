/* The readable form: solid, facet normal, outer loop, three vertices, endloop, endfacet ... */
#include "exchange/reading/scan.h"
#include "exchange/stl/stl.h"

#include <string.h>

typedef struct {
    bat_input *input;
    batten_model *model;
    bat_scan words;
    bat_stl_solid solid;
    size_t facets;  /* of this solid, with those left out */
    bool inside;    /* a solid has begun and not ended */
    bool passing;   /* what is left of a triangle that was left out */
    bat_span comma; /* a word of the triangle that has one, where a number should be */
    char *name;
} reading;

static bool expect(reading *r, const char *text)
{
    bat_span word;
    return bat_next_word(&r->words, &word) && bat_word_is_like(word, text);
}

/* Does a triangle, or "solid", begin at the word? */
static bool ends_name(bat_span word, bat_scan after)
{
    bat_span next;
    return bat_word_is_like(word, "facet") && bat_next_in_line(&after, &next) &&
           (bat_word_is_like(next, "normal") || bat_word_is_like(next, "outer"));
}

bat_span bat_stl_name(bat_scan *words)
{
    bat_scan look = *words, name = *words;
    const char *end = NULL;
    bat_span word;
    while (!end && bat_next_in_line(&look, &word))
        end = ends_name(word, look) ? word.bytes : NULL;
    if (!end)
        return bat_rest_of_line(words);
    words->at = end;
    name.end = end;
    return bat_rest_of_line(&name);
}

/* After "endsolid": on one line the next solid may follow. */
static void pass_name(bat_scan *words)
{
    bat_scan line = *words, look;
    const bat_span name = bat_stl_name(&line);
    bat_span word;
    look = bat_scan_begin(name.bytes, name.length);
    while (bat_next_in_line(&look, &word))
        if (line.at < line.end && bat_word_is_like(word, "solid") &&
            !bat_is_white(
                *line.at)) { /* a triangle stands there, and not the end of the line */
            words->at = word.bytes;
            return;
        }
    *words = line;
}

/* NaN and numbers beyond a double come as NaN, for the triangle to be left out. */
static bool read_numbers(reading *r, int count, double *numbers)
{
    for (int k = 0; k < count; k++) {
        bat_span word;
        if (!bat_next_word(&r->words, &word))
            return false;
        if (bat_word_real(r->input, r->words.line, word, &numbers[k]))
            continue;
        numbers[k] = NAN;
        if (memchr(word.bytes, ',', word.length) && !r->comma.length)
            r->comma = word;
    }
    return true;
}

/* After "facet" to "endfacet"; the normal may be missing. */
static bool read_facet(reading *r, double corners[9], double normal[3])
{
    bat_span word;
    if (!bat_next_word(&r->words, &word))
        return false;
    if (bat_word_is_like(word, "normal")) {
        if (!read_numbers(r, 3, normal) || !bat_next_word(&r->words, &word))
            return false;
    }
    if (!bat_word_is_like(word, "outer") || !expect(r, "loop"))
        return false;
    for (int k = 0; k < 3; k++)
        if (!expect(r, "vertex") || !read_numbers(r, 3, corners + 3 * k))
            return false;
    return expect(r, "endloop") && expect(r, "endfacet");
}

/* What is wrong is left out; reading goes on at the next facet or end. */
static batten_status add_facet(reading *r)
{
    double corners[9], normal[3] = {0, 0, 0};
    const int line = r->words.line;
    const size_t index = r->facets++;
    char shown[BAT_SHOWN_SIZE];
    r->comma = (bat_span){NULL, 0};
    const bool is_whole = read_facet(r, corners, normal);
    if (is_whole && r->comma.length && bat_first_not_finite(corners, 9) < 9) {
        r->input->left_out++;
        batten_notes_add(r->input->notes, r->input->file, line, "",
                         "triangle %zu is left out: '%.40s' is not a number; decimals follow "
                         "a point",
                         index + 1, bat_shown(r->comma.bytes, r->comma.length, shown));
        return BATTEN_OK;
    }
    if (is_whole)
        return bat_stl_add(&r->solid, line, index, corners, normal);
    if (r->words.at >= r->words.end) {
        r->input->is_cut = true;
        batten_notes_add(r->input->notes, r->input->file, line, "",
                         "the file ends within triangle %zu", index + 1);
    } else {
        r->input->left_out++;
        r->passing = true;
        batten_notes_add(r->input->notes, r->input->file, line, "",
                         "triangle %zu is left out: line %d is not what follows in a facet",
                         index + 1, r->words.line);
    }
    return BATTEN_OK;
}

static batten_status begin_solid(reading *r)
{
    const bat_span name = bat_stl_name(&r->words);
    batten_status status = bat_input_limit(r->input, r->words.line, name.length,
                                           r->input->limits.string_bytes, "bytes in a name");
    bat_release(r->name);
    r->name = NULL;
    if (status == BATTEN_OK)
        status = bat_input_array(r->input, name.length + 1, 1, &r->name);
    if (status != BATTEN_OK)
        return status;
    bat_word_copy(name, name.length + 1, r->name);
    r->inside = true;
    r->passing = false;
    r->facets = 0;
    return BATTEN_OK;
}

static batten_status end_solid(reading *r)
{
    batten_status status = bat_stl_end(&r->solid, r->name[0] ? r->name : "mesh", r->model);
    r->inside = r->passing = false;
    return status;
}

/* A word that belongs neither to a triangle nor to a solid; those that follow it are passed. */
static void note_stray(reading *r, bat_span word)
{
    char shown[BAT_SHOWN_SIZE];
    const bool is_facet = bat_word_is_like(word, "facet");
    if (r->passing && !is_facet)
        return;
    r->passing = true;
    r->input->left_out += is_facet;
    batten_notes_add(r->input->notes, r->input->file, r->words.line, "",
                     is_facet ? "a triangle outside of a solid is left out: '%.40s'"
                              : "unexpected word '%.40s' in a solid",
                     bat_shown(word.bytes, word.length, shown));
}

static batten_status read_solids(reading *r)
{
    bat_span word;
    size_t steps = 0;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && bat_next_word(&r->words, &word)) {
        if (bat_word_is_like(word, "facet") && r->inside) {
            r->passing = false;
            status = add_facet(r);
        } else if (bat_word_is_like(word, "solid")) {
            status = r->inside ? end_solid(r) : BATTEN_OK;
            if (status == BATTEN_OK)
                status = begin_solid(r);
        } else if (bat_word_is_like(word, "endsolid") && r->inside) {
            pass_name(&r->words);
            status = end_solid(r);
        } else
            note_stray(r, word);
        if (status == BATTEN_OK && ++steps % 10000 == 0)
            status = bat_input_step(r->input, (size_t)(word.bytes - r->input->data));
    }
    if (status == BATTEN_OK && r->inside) {
        r->input->is_cut = true;
        status = end_solid(r);
    }
    return status;
}

batten_status bat_stl_read_text(bat_input *input, batten_model *model)
{
    reading r = {.input = input,
                 .model = model,
                 .words = bat_scan_begin(input->data, input->size),
                 .solid = {input, {.size = 9 * sizeof(double)}, 0}};
    const batten_status status = read_solids(&r);
    bat_release(r.solid.points.items);
    bat_release(r.name);
    return status;
}
