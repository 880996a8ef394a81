/* Input and output of the commands: files, standard streams, notes, and the exit status. */
#include "command.h"
#include "select.h"
#include "system.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Does the text end so? */
static bool ends(const char *text, const char *end)
{
    const size_t length = strlen(text), tail = strlen(end);
    return length >= tail && strcmp(text + length - tail, end) == 0;
}

/* All notes, but for those that `message` ends with. */
static void show_notes(const batten_notes *notes, const char *message)
{
    job_end();
    for (int i = 0; i < batten_notes_count(notes); i++) {
        const batten_note *note = batten_notes_at(notes, i);
        if ((message && ends(message, note->text)) || (note->is_remark && job_is_quiet()))
            continue;
        char place[32] = "";
        if (*note->file && note->line > 0)
            snprintf(place, sizeof place, "%d:", note->line);
        /* A column of a text that the user did not write. */
        const bool in_none = !*note->file && note->line > 0;
        const char *entity = in_none ? "" : note->entity;
        complain("%s%s%s%s%s%s%s", note->file, *note->file ? ":" : "", place,
                 *note->file ? " " : "", entity, *entity ? ": " : "", note->text);
    }
    if (batten_notes_dropped(notes) > 0)
        complain("and %d more message%s", batten_notes_dropped(notes),
                 batten_notes_dropped(notes) == 1 ? "" : "s");
}

void notes_show(const batten_notes *notes)
{
    show_notes(notes, NULL);
}

void failed_show(const batten_notes *notes)
{
    show_notes(notes, batten_message());
}

static void note_json(batten_text *text, const batten_note *note)
{
    batten_text_add(text, "    {\"file\": ");
    batten_text_json(text, note->file);
    batten_text_add(text, ", \"line\": %d, \"entity\": ", note->line);
    batten_text_json(text, note->entity);
    batten_text_add(text, ", \"text\": ");
    batten_text_json(text, note->text);
    batten_text_add(text, ", \"remark\": %s}", note->is_remark ? "true" : "false");
}

void notes_json(batten_text *text, const batten_notes *notes)
{
    batten_text_add(text, "[");
    for (int i = 0; i < batten_notes_count(notes); i++) {
        batten_text_add(text, "%s\n", i ? "," : "");
        note_json(text, batten_notes_at(notes, i));
    }
    batten_text_add(text, "%s]", batten_notes_count(notes) ? "\n  " : "");
}

/* ---- input ---- */

static bool is_there(const char *file)
{
    return strcmp(file, "-") == 0 || system_exists(file);
}

/* How much of the argument is the name of a file that is there, up to a hash; 0 for none. Names of
 * files and of objects may both hold hashes. */
static size_t find_file_end(char *made, size_t length)
{
    size_t end = length;
    while (end > 0 && !is_there(made)) {
        do
            end--;
        while (end > 0 && made[end] != '#');
        made[end] = '\0';
    }
    return end;
}

batten_status input_split(const char *argument, char **file, const char **name)
{
    const size_t length = strlen(argument);
    const char *last = strrchr(argument, '#');
    char *made = batten_array(length + 1, 1);
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(made, argument, length);
    size_t end = find_file_end(made, length);
    if (end == 0 && last) {
        end = (size_t)(last - argument);
        memcpy(made, argument, end);
        made[end] = '\0';
    } else if (end == 0) {
        end = length;
        memcpy(made, argument, length);
    }
    *file = made;
    *name = end < length ? argument + end + 1 : NULL;
    return BATTEN_OK;
}

/* All of standard input. */
static batten_status read_input(char **data, size_t *size)
{
    const size_t limit = batten_limits_defaults().file_bytes;
    batten_text text = BATTEN_TEXT;
    char piece[1 << 12];
    size_t got;
    while ((got = fread(piece, 1, sizeof piece, stdin)) > 0 && text.length <= limit)
        batten_text_bytes(&text, piece, got);
    if (ferror(stdin) || text.length > limit) {
        batten_text_free(&text);
        return batten_fail(BATTEN_FILE_ERROR, "cannot read standard input: %s",
                           errno ? strerror(errno) : "too long");
    }
    return batten_text_take(&text, data, size);
}

static batten_status read_model(const char *file, batten_format format, batten_notes *notes,
                                batten_model **model)
{
    batten_read_options options = batten_read_defaults();
    options.format = format;
    options.file_name = file;
    if (strcmp(file, "-") != 0)
        return batten_read_file(file, &options, job_get(), notes, model);

    char *data = NULL;
    size_t size = 0;
    options.file_name = "standard input";
    batten_status status = read_input(&data, &size);
    if (status == BATTEN_OK)
        status = batten_read_memory(data, size, &options, job_get(), notes, model);
    batten_release(data);
    return status;
}

int input_read(const char *argument, batten_format format, batten_notes *notes,
               batten_model **model)
{
    char *file = NULL;
    const char *name = NULL;
    batten_model *made = NULL;
    batten_status status = input_split(argument, &file, &name);
    if (status == BATTEN_OK)
        status = read_model(file, format, notes, &made);
    const bool partly = status == BATTEN_PARTLY_READ;
    if ((status == BATTEN_OK || partly) && name)
        status = select_object(name, &made);
    batten_release(file);
    if (status != BATTEN_OK && status != BATTEN_PARTLY_READ) {
        failed_show(notes);
        complain("batten: %s", batten_message());
        batten_model_unref(made);
        return EXIT_FAILED;
    }
    *model = made;
    return partly ? EXIT_PARTLY : EXIT_DONE;
}

void input_name_add(batten_text *text, const char *argument)
{
    batten_text name = BATTEN_TEXT;
    if (strcmp(argument, "-") == 0)
        batten_text_add(&name, "standard input");
    else
        batten_text_add(&name, "%s%s", strpbrk(argument, "./") ? "" : "./", argument);
    batten_text_json(text, name.bytes ? name.bytes : "");
    text->failed |= name.failed;
    batten_text_free(&name);
}

void input_add(batten_text *text, const char *argument)
{
    batten_text_add(text, "  ");
    input_name_add(text, argument);
    batten_text_add(text, ": {read: ");
    batten_text_json(text, argument);
    batten_text_add(text, "}\n");
}

/* ---- output ---- */

/* Is that the file that is read? */
static bool is_input(const char *input, const char *output)
{
    char *file = NULL;
    const char *name;
    if (strcmp(input, "-") == 0)
        return system_is_same_file(output, NULL);
    const bool same =
        input_split(input, &file, &name) == BATTEN_OK && system_is_same_file(output, file);
    batten_release(file);
    return same;
}

bool output_is_input(const char *of, const char *input, const char *output)
{
    /* Nothing is lost by writing to a terminal or another device. */
    if (strcmp(output, "-") == 0 || !is_input(input, output))
        return false;
    complain("batten %s: '%s' is the file that is read, and would be overwritten; give "
             "another name",
             of, output);
    return true;
}

batten_status output_stream(const char *data, size_t size)
{
    if (fwrite(data, 1, size, stdout) == size && fflush(stdout) == 0)
        return BATTEN_OK;
    return batten_fail(BATTEN_FILE_ERROR, "cannot write to standard output: %s",
                       strerror(errno));
}

static int print(const char *data, size_t size)
{
    if (output_stream(data, size) == BATTEN_OK)
        return EXIT_DONE;
    complain("batten: %s", batten_message());
    return EXIT_FAILED;
}

int output_print(batten_text *text)
{
    char *bytes = NULL;
    size_t length = 0;
    job_end();
    if (batten_text_take(text, &bytes, &length) != BATTEN_OK) {
        complain("batten: %s", batten_message());
        return EXIT_FAILED;
    }
    const int status = length ? print(bytes, length) : EXIT_DONE;
    batten_release(bytes);
    return status;
}

int output_save(const char *path, const char *data, size_t size)
{
    if (strcmp(path, "-") == 0)
        return print(data, size);
    if (batten_save_file(path, data, size) == BATTEN_OK)
        return EXIT_DONE;
    complain("batten: %s", batten_message());
    return EXIT_FAILED;
}

const char *message_shown(void)
{
    const char *message = batten_message(), *at = message;
    for (int i = 0; i < 2 && *at == ':'; i++)
        at += 1 + strspn(at + 1, "0123456789");
    return at > message && at[0] == ':' && at[1] == ' ' ? at + 2 : message;
}

int output_failed(const char *name, batten_status status)
{
    job_end();
    if (status == BATTEN_CANCELLED)
        complain("batten %s: cancelled; what was being written is as it was before", name);
    else
        complain("batten %s: %s", name, message_shown());
    return EXIT_FAILED;
}
