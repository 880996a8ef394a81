#include "exchange/formats.h"
#include "exchange/recognise.h"

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
        return bat_input_fail(
            input, BATTEN_PARTLY_READ, 0,
            "the end of the file is missing; %d entities are read, %d left out",
            batten_model_count(model), input->left_out);
    if (input->left_out == 0)
        return BATTEN_OK;
    return bat_input_fail(input, BATTEN_PARTLY_READ, 0, "%d of %d entities are left out",
                          input->left_out, input->left_out + batten_model_count(model));
}

batten_status batten_read_memory(const char *data, size_t size,
                                 const batten_read_options *options, const batten_job *job,
                                 batten_notes *notes, batten_model **out)
{
    bat_input input;
    batten_format format = options ? options->format : BATTEN_FORMAT_AUTO;
    batten_status status = bat_input_begin(data, size, options, job, notes, &input);
    if (status == BATTEN_OK && format == BATTEN_FORMAT_AUTO)
        status = bat_recognise(&input, &format);
    return status == BATTEN_OK ? read_as(&input, format, out) : status;
}

batten_status batten_read_file(const char *path, const batten_read_options *options,
                               const batten_job *job, batten_notes *notes, batten_model **out)
{
    batten_read_options named = options ? *options : batten_read_defaults();
    const batten_limits limits = named.limits ? *named.limits : batten_limits_defaults();
    char *data = NULL;
    size_t size = 0;
    if (!named.file_name || !named.file_name[0])
        named.file_name = path;
    batten_status status = batten_load_file(path, limits.file_bytes, &data, &size);
    if (status == BATTEN_OK)
        status = batten_read_memory(data, size, &named, job, notes, out);
    batten_release(data);
    return status;
}
