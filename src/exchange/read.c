/* Reads a model from memory or from a file: finds the format, then calls its reader. */
#include "base/plural.h"
#include "exchange/formats.h"
#include "exchange/reading/scan.h"
#include "exchange/recognise.h"
#include <stdio.h>

static batten_status read_as(bat_input *input, batten_format format, batten_model **out)
{
    batten_model *model = NULL;
    const bat_format_row *row = bat_format_of(format);
    if (!row || !row->read)
        return bat_input_fail(input, BATTEN_UNSUPPORTED, 0, "%s files cannot be read",
                              row ? row->title : "such");
    batten_status status = row->is_binary ? BATTEN_OK : bat_input_as_text(input);
    if (status == BATTEN_OK && bat_past_white(input) == input->size)
        status = bat_input_fail(input, BATTEN_BAD_FORMAT, 0, "the file is empty");
    if (status == BATTEN_OK)
        status = row->read(input, &model);
    if (status != BATTEN_OK)
        return status;
    if (batten_model_count(model) == 0 && (input->is_cut || input->left_out > 0)) {
        batten_model_unref(model);
        return bat_input_fail(input, BATTEN_BAD_FORMAT, 0, "nothing of it could be read%s",
                              input->is_cut ? "; the end of the file is missing" : "");
    }
    *out = model;
    if (input->is_cut)
        return bat_input_fail(input, BATTEN_PARTLY_READ, 0,
                              "the end of the file is missing; %d %s %s read, %d left out",
                              batten_model_count(model),
                              bat_one_or_many(batten_model_count(model), "entity", "entities"),
                              bat_one_or_many(batten_model_count(model), "is", "are"),
                              input->left_out);
    if (input->left_out == 0)
        return BATTEN_OK;
    return bat_input_fail(input, BATTEN_PARTLY_READ, 0, "%d of %d entities are left out",
                          input->left_out, input->left_out + batten_model_count(model));
}

/* After a failure as a format that was asked for: say which one the bytes are of, when that is
 * known by more than rows of numbers. */
static batten_status name_content(const bat_input *asked, batten_format format,
                                  batten_status status)
{
    enum { SIZE = 1024 };
    char message[SIZE];
    bat_input input = *asked;
    bool is_such = false;
    snprintf(message, sizeof message, "%s", batten_message());
    input.notes = NULL;
    for (size_t k = 0; bat_format_at(k); k++) {
        const bat_format_row *row = bat_format_at(k);
        if (row->recognise && row->format != format &&
            row->recognise(&input, &is_such) == BATTEN_OK && is_such)
            return bat_fail(status, "%.900s; the content is that of %s", message, row->title);
    }
    return bat_fail(status, "%s", message);
}

batten_status batten_read_memory(const char *data, size_t size,
                                 const batten_read_options *options, const batten_job *job,
                                 batten_notes *notes, batten_model **out)
{
    batten_read_options chosen = batten_read_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_read_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    bat_input input;
    batten_format format = chosen.format;
    status = bat_input_begin(data, size, &chosen, job, notes, &input);
    if (status == BATTEN_OK && format == BATTEN_FORMAT_AUTO)
        status = bat_recognise(&input, &format);
    if (status == BATTEN_OK)
        status = read_as(&input, format, out);
    if (status == BATTEN_BAD_FORMAT && chosen.format != BATTEN_FORMAT_AUTO)
        status = name_content(&input, format, status);
    return status;
}

batten_status batten_read_file(const char *path, const batten_read_options *options,
                               const batten_job *job, batten_notes *notes, batten_model **out)
{
    batten_read_options named = batten_read_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_read_options, options, &named);
    batten_limits limits = batten_limits_defaults();
    if (status == BATTEN_OK)
        status = BAT_TAKE_OPTIONS(batten_limits, named.limits, &limits);
    if (status != BATTEN_OK)
        return status;
    char *data = NULL;
    size_t size = 0;
    if (!named.file_name || !named.file_name[0])
        named.file_name = path;
    status = batten_load_file(path, limits.file_bytes, &data, &size);
    if (status == BATTEN_OK)
        status = batten_read_memory(data, size, &named, job, notes, out);
    batten_release(data);
    return status;
}
