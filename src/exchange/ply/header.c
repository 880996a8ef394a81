/* Reads the header of a PLY file: its form, elements and properties. */
#include "exchange/ply/ply.h"
#include "exchange/reading/scan.h"

batten_status bat_ply_recognise(const bat_input *input, bool *is_such)
{
    *is_such = bat_begins(input, 0, "ply\n") || bat_begins(input, 0, "ply\r") ||
               bat_begins(input, 0, "ply \n");
    return BATTEN_OK;
}

static bool type_of(bat_span word, bat_ply_type *type)
{
    static const struct {
        const char *names[2];
        bat_ply_type type;
    } rows[] = {
        {{"char", "int8"}, {1, false, true}},    {{"uchar", "uint8"}, {1, false, false}},
        {{"short", "int16"}, {2, false, true}},  {{"ushort", "uint16"}, {2, false, false}},
        {{"int", "int32"}, {4, false, true}},    {{"uint", "uint32"}, {4, false, false}},
        {{"float", "float32"}, {4, true, true}}, {{"double", "float64"}, {8, true, true}}};
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++)
        if (bat_word_is(word, rows[k].names[0]) || bat_word_is(word, rows[k].names[1])) {
            *type = rows[k].type;
            return true;
        }
    return false;
}

static batten_status bad_line(const bat_input *input, int line, const char *what)
{
    return bat_input_fail(input, BATTEN_BAD_FORMAT, line, "bad header: %s", what);
}

static batten_status read_format(bat_input *input, bat_scan *words, int line,
                                 bat_ply_header *header)
{
    static const char *const names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    bat_span form, version;
    int k = 0;
    if (!bat_next_in_line(words, &form) || !bat_next_in_line(words, &version))
        return bad_line(input, line, "expected a format and its version");
    while (k < 3 && !bat_word_is(form, names[k]))
        k++;
    if (k == 3 || !bat_word_is(version, "1.0"))
        return bat_input_fail(input, BATTEN_UNSUPPORTED, line, "unknown PLY form '%.*s' %.*s",
                              (int)bat_min_int(40, (int)form.length), form.bytes,
                              (int)bat_min_int(40, (int)version.length), version.bytes);
    header->form = (bat_ply_form)k;
    return BATTEN_OK;
}

static batten_status read_element(bat_input *input, bat_scan *words, int line,
                                  bat_ply_header *header)
{
    bat_ply_element element = {.first = header->properties.count};
    bat_span count;
    int64_t number = 0;
    if (!bat_next_in_line(words, &element.name) || !bat_next_in_line(words, &count) ||
        !bat_word_integer(count, 0, (int64_t)1 << 40, &number))
        return bad_line(input, line, "an element needs a name and a count");
    element.count = (size_t)number;
    return bat_list_add(input, &header->elements, &element);
}

static batten_status read_property(bat_input *input, bat_scan *words, int line,
                                   bat_ply_header *header)
{
    bat_ply_property property = {.is_list = false};
    bat_span word;
    bool good = header->elements.count > 0 && bat_next_in_line(words, &word);
    if (good && bat_word_is(word, "list")) {
        property.is_list = true;
        good = bat_next_in_line(words, &word) && type_of(word, &property.count_type) &&
               !property.count_type.is_real && bat_next_in_line(words, &word);
    }
    good = good && type_of(word, &property.type) && bat_next_in_line(words, &property.name);
    if (!good)
        return bad_line(input, line, "a property needs a known type and a name");
    bat_ply_element *elements = header->elements.items;
    elements[header->elements.count - 1].properties++;
    return bat_list_add(input, &header->properties, &property);
}

static batten_status read_line(bat_input *input, bat_span text, int line,
                               bat_ply_header *header, bool *has_form, bool *is_end)
{
    bat_scan words = bat_scan_begin(text.bytes, text.length);
    bat_span word;
    if (!bat_next_in_line(&words, &word) || bat_word_is(word, "comment") ||
        bat_word_is(word, "obj_info"))
        return BATTEN_OK;
    if (bat_word_is(word, "format")) {
        *has_form = true;
        return read_format(input, &words, line, header);
    }
    if (bat_word_is(word, "element"))
        return read_element(input, &words, line, header);
    if (bat_word_is(word, "property"))
        return read_property(input, &words, line, header);
    if (!bat_word_is(word, "end_header"))
        return bad_line(input, line, "unknown header line");
    *is_end = true;
    return *has_form ? BATTEN_OK : bad_line(input, line, "the format line is missing");
}

batten_status bat_ply_header_read(bat_input *input, bat_ply_header *header)
{
    bool is_such = false, has_form = false, is_end = false;
    bat_span text;
    *header = (bat_ply_header){.elements = {.size = sizeof(bat_ply_element)},
                               .properties = {.size = sizeof(bat_ply_property)},
                               .line = 1};
    batten_status status = bat_ply_recognise(input, &is_such);
    if (!is_such)
        return bat_input_fail(input, BATTEN_BAD_FORMAT, 1, "the first line is not 'ply'");
    bat_next_line(input, &header->body, &text);
    while (status == BATTEN_OK && !is_end) {
        header->line++;
        if (!bat_next_line(input, &header->body, &text))
            return bat_input_fail(input, BATTEN_BAD_FORMAT, header->line,
                                  "the file ends within the header");
        status = bat_input_limit(input, header->line, text.length, input->limits.line_bytes,
                                 "bytes in the line");
        if (status == BATTEN_OK)
            status = read_line(input, text, header->line, header, &has_form, &is_end);
    }
    header->line++;
    return status;
}

void bat_ply_header_end(bat_ply_header *header)
{
    bat_release(header->elements.items);
    bat_release(header->properties.items);
}
