/* What holds of every reader and writer over the seeds of its corpus. */
#define _XOPEN_SOURCE 700
#include <dirent.h>
#include <limits.h>
#include <stdlib.h>

#include "exchange/corpus.h"
#include "exchange/replace.h"

enum { MOST_FILES = 400, LONGEST_PATH = 200 };

static int compare_paths(const void *a, const void *b)
{
    return strcmp(a, b);
}

corpus corpus_of(batten_format format, const char *folder, const char *like)
{
    char at[2 * LONGEST_PATH];
    corpus c = {format, test_array(MOST_FILES, LONGEST_PATH), 0};
    snprintf(at, sizeof at, "%sfuzz/corpus/%s", test_source(""), folder);
    DIR *open = opendir(at);
    CHECK(open != NULL);
    for (const struct dirent *entry; (entry = readdir(open)) && c.count < MOST_FILES;)
        if (entry->d_name[0] != '.' && strncmp(entry->d_name, "found-", 6) != 0 &&
            strstr(entry->d_name, like))
            snprintf(c.files[c.count++], LONGEST_PATH, "%.60s/%.120s", folder, entry->d_name);
    closedir(open);
    CHECK(c.count > 0);
    qsort(c.files, (size_t)c.count, LONGEST_PATH, compare_paths);
    return c;
}

corpus corpus_named(batten_format format, const char *const *files, int count)
{
    corpus c = {format, test_array((size_t)count, LONGEST_PATH), count};
    for (int i = 0; i < count; i++)
        snprintf(c.files[i], LONGEST_PATH, "%s", files[i]);
    return c;
}

/* The whole of one, of which the caller releases nothing; cleared by batten_release. */
static char *load_seed(const char *file, size_t *size)
{
    char path[2 * LONGEST_PATH];
    char *data = NULL;
    snprintf(path, sizeof path, "%sfuzz/corpus/%s", test_source(""), file);
    CHECK_OK(batten_load_file(path, (size_t)1 << 30, &data, size));
    return data;
}

/* Memory failing in turn is the affair of tests that state what becomes of it. */
static void only_once(void)
{
    if (test_cases(1000) < 1000)
        SKIP("the allocations are those of other tests");
}

/* Is the last bracket before a place that of "rgb("? */
static bool is_in_colour(const char *line, const char *place)
{
    while (place > line && place[-1] != '(' && place[-1] != ')')
        place--;
    return place >= line + 4 && memcmp(place - 4, "rgb(", 4) == 0;
}

/* Where a name, a layer, a colour or the like stands, or a place in the directory of IGES, of
 * which records.c has tests. */
static bool is_no_value(batten_format format, const char *text, size_t at)
{
    const char *line = text + at;
    while (line > text && line[-1] != '\n')
        line--;
    switch (format) {
    case BATTEN_FORMAT_IGES:
        return line[72] != 'P';
    case BATTEN_FORMAT_STEP:
        return at > 0 && strchr("#_'", text[at - 1]) != NULL;
    case BATTEN_FORMAT_DXF: /* codes, and what stands after 2, 8, 62, 420 */
        if (line - text < 4)
            return true;
        return line[-2] == '8' ||
               (line[-2] == '2' && (line[-3] == '\n' || line[-3] == ' ' || line[-3] == '6')) ||
               memcmp(line - 4, "420", 3) == 0;
    case BATTEN_FORMAT_OFFSET_TABLE:
    case BATTEN_FORMAT_AEROFOIL:
        return line == text;
    case BATTEN_FORMAT_SVG:
        return is_in_colour(line, text + at);
    default:
        return false;
    }
}

enum { ROOM = 20000 };

/* What was said, one after another. */
static void gather(const batten_notes *notes, char *all)
{
    all[0] = '\0';
    for (int i = 0; i < batten_notes_count(notes); i++)
        if (!batten_notes_at(notes, i)->is_remark)
            strncat(all, batten_notes_at(notes, i)->text, ROOM - 1 - strlen(all));
}

typedef struct {
    batten_status status;
    char *said; /* [ROOM] */
    char *bytes;
    size_t size;
} outcome;

static outcome read_and_write(const char *text, batten_format format, char *room)
{
    outcome o = {.said = room};
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    o.status = read_text(text, format, notes, &model);
    CHECK((o.status == BATTEN_OK || o.status == BATTEN_PARTLY_READ) == (model != NULL));
    gather(notes, o.said);
    if (o.status == BATTEN_OK) /* of what is left there may be nothing that can be written */
        o.bytes = as_bytes(model, format, &o.size);
    else if (model)
        (void)to_bytes(model, format, &o.bytes, &o.size);
    batten_notes_free(notes);
    batten_model_unref(model);
    return o;
}

/* Is something else read, and the same said of it? */
static bool is_quiet(const outcome *plain, const outcome *bent)
{
    return bent->status == plain->status && strcmp(bent->said, plain->said) == 0 &&
           bent->bytes &&
           (bent->size != plain->size || memcmp(bent->bytes, plain->bytes, bent->size) != 0);
}

/* ---- numbers ---- */

/* Where a number is replaced, the reader says so, or reads the same as before. @return how often not */
static int count_quiet(batten_format format, const char *file, const char *const *numbers,
                       int count)
{
    size_t size = 0, length = 0;
    int lost = 0;
    char *said = test_array(ROOM, 1), *said_plain = test_array(ROOM, 1);
    char *text = load_seed(file, &size), *room = test_array(size + 100, 1);
    const outcome plain = read_and_write(text, format, said_plain);
    CHECK(plain.bytes != NULL);
    for (size_t at = 0; next_number(text, &at, &length); at += length)
        for (int i = 0; !is_no_value(format, text, at) && i < count; i++) {
            with_number(room, text, at, length, numbers[i]);
            if (format == BATTEN_FORMAT_IGES &&
                (strlen(room) != size || at % 81 + strlen(numbers[i]) > 64))
                continue; /* there is no room for it in the record */
            const outcome bent = read_and_write(room, format, said);
            const bool is_lost = is_quiet(&plain, &bent);
            if (is_lost)
                printf("%s: %s for %.*s at byte %zu\n", file, numbers[i], (int)length,
                       text + at, at);
            lost += is_lost;
            batten_release(bent.bytes);
        }
    batten_release(plain.bytes);
    batten_release(text);
    return lost;
}

void check_no_number_is_lost(const corpus *c)
{
    static const char *const numbers[] = {"nan", "-inf", "1e400", "1e-400"};
    int lost = 0;
    only_once();
    for (int k = 0; k < c->count; k++)
        lost += count_quiet(c->format, c->files[k], numbers, COUNT(numbers));
    CHECK_INT(lost, 0);
}

/* ---- memory ---- */

/* The job with one allocation that fails, each in turn, or `most` of them evenly. */
static void without_memory(int most, void (*job)(void *, bool), void *context)
{
    test_fail_allocation(LONG_MAX);
    job(context, false);
    const long count = test_allocations();
    test_fail_allocation(0);
    const long step = count > most ? count / most : 1;
    for (long at = 1; at <= count; at += step) {
        test_fail_allocation(at);
        job(context, true);
        test_fail_allocation(0);
    }
}

typedef struct {
    batten_format format;
    const char *file, *data;
    size_t size;
    batten_status plain_status;
    char *plain;
    size_t plain_size;
} read_job;

static void read_without(void *context, bool fails)
{
    read_job *j = context;
    batten_model *model = NULL;
    const batten_status status = read_bytes(j->data, j->size, j->format, NULL, &model);
    char *bytes = NULL;
    size_t size = 0;
    if (!fails) {
        j->plain_status = status;
        batten_model_unref(model);
        return;
    }
    test_fail_allocation(0);
    if (status == BATTEN_OUT_OF_MEMORY)
        CHECK(model == NULL);
    else {
        if (model)
            (void)to_bytes(model, j->format, &bytes, &size);
        if (status != j->plain_status || size != j->plain_size ||
            memcmp(bytes, j->plain, size) != 0)
            printf("%s: status %d not %d, or something else is read without a word\n", j->file,
                   status, j->plain_status);
        CHECK_INT(status, j->plain_status);
        CHECK(size == j->plain_size && (size == 0 || memcmp(bytes, j->plain, size) == 0));
    }
    batten_release(bytes);
    batten_model_unref(model);
}

void check_reading_without_memory(const corpus *c, int most)
{
    only_once();
    for (int k = 0; k < c->count; k++) {
        read_job job = {.format = c->format, .file = c->files[k]};
        batten_model *model = NULL;
        char *data = load_seed(c->files[k], &job.size);
        job.data = data;
        read_bytes(job.data, job.size, job.format, NULL, &model);
        if (model)
            (void)to_bytes(model, job.format, &job.plain, &job.plain_size);
        batten_model_unref(model);
        without_memory(most, read_without, &job);
        batten_release(job.plain);
        batten_release(data);
    }
}

typedef struct {
    const batten_model *model;
    const char *file;
    batten_format format;
    batten_status plain_status;
    char *plain;
    size_t plain_size;
} write_job;

static void write_without(void *context, bool fails)
{
    write_job *j = context;
    char *bytes = NULL;
    size_t size = 0;
    const batten_status status = write_bytes(j->model, j->format, &bytes, &size);
    if (!fails) {
        j->plain_status = status, j->plain = bytes, j->plain_size = size;
        return;
    }
    if (status != BATTEN_OUT_OF_MEMORY) {
        if (status != j->plain_status || size != j->plain_size ||
            memcmp(bytes, j->plain, size) != 0)
            printf("%s: status %d not %d, or something else is written without a word\n",
                   j->file, status, j->plain_status);
        CHECK_INT(status, j->plain_status);
        CHECK(size == j->plain_size && (size == 0 || memcmp(bytes, j->plain, size) == 0));
    } else
        CHECK(bytes == NULL);
    batten_release(bytes);
}

void check_writing_without_memory(const corpus *c, batten_format to, int most)
{
    only_once();
    for (int k = 0; k < c->count; k++) {
        write_job job = {.file = c->files[k], .format = to};
        batten_model *model = NULL;
        size_t size = 0;
        char *data = load_seed(c->files[k], &size);
        read_bytes(data, size, c->format, NULL, &model);
        job.model = model;
        if (model)
            without_memory(most, write_without, &job);
        batten_release(job.plain);
        batten_release(data);
        batten_model_unref(model);
    }
}

/* ---- references of STEP ---- */

/* Where the next reference of STEP stands in the parameters of an instance, and its length. */
static bool next_reference(const char *text, size_t *at, size_t *length)
{
    for (size_t i = *at; text[i]; i++)
        if (text[i] == '#' && i > 0 && text[i - 1] != '\n') {
            *at = i;
            *length = 1 + strspn(text + i + 1, "0123456789");
            return true;
        }
    return false;
}

void check_no_reference_is_lost(const corpus *c)
{
    /* $ may stand for directions that follow from the others. */
    static const char *const instead[] = {"#99999", "''"};
    char *said = test_array(ROOM, 1), *said_plain = test_array(ROOM, 1);
    int lost = 0;
    only_once();
    for (int s = 0; s < c->count; s++) {
        size_t size = 0, length = 0;
        char *text = load_seed(c->files[s], &size);
        char *room = test_array(size + 100, 1);
        const outcome plain = read_and_write(text, BATTEN_FORMAT_STEP, said_plain);
        for (size_t at = 0; next_reference(text, &at, &length); at += length)
            for (int i = 0; i < COUNT(instead); i++) {
                sprintf(room, "%.*s%s%s", (int)at, text, instead[i], text + at + length);
                const outcome bent = read_and_write(room, BATTEN_FORMAT_STEP, said);
                if (is_quiet(&plain, &bent)) {
                    printf("%s: %s for %.*s at byte %zu: %.60s\n", c->files[s], instead[i],
                           (int)length, text + at, at, text + (at > 40 ? at - 40 : 0));
                    lost++;
                }
                batten_release(bent.bytes);
            }
        batten_release(plain.bytes);
        batten_release(text);
    }
    CHECK_INT(lost, 0);
}
