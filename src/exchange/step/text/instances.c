/* Cuts the text of a STEP file into instances with their records. */
#include "exchange/step/text/instances.h"

#include "exchange/step/text/scan.h"
#include "exchange/step/text/table.h"
#include <limits.h>
#include <stdio.h>
#include <string.h>

/* What is being read. */
typedef struct {
    bat_step_file *file;
    bat_step_scanner scan;
    enum { BEFORE, HEADER, DATA, BETWEEN } section;
    size_t statement; /* where the one that is being read begins */
    uint64_t id;      /* of the instance that is being read; 0 when it is none yet */
    size_t step;      /* where the job is asked next */
    bool has_data, is_over;
} reading;

static void note_damage(const reading *r, size_t at, const char *text)
{
    const bat_input *input = r->file->input;
    batten_notes_add(input->notes, input->file, bat_step_line(r->file, at), "", "%s", text);
}

/* ---- going on after what is wrong ---- */

static bool begins_with(const bat_step_scanner *scan, size_t at, const char *word)
{
    const size_t length = strlen(word);
    return scan->size - at >= length && bat_step_same_word(scan->data + at, word, length);
}

static size_t past_all(const bat_step_scanner *scan, size_t at, int classes)
{
    while (at < scan->size && bat_step_in(scan->data[at], classes))
        at++;
    return at;
}

/* Does "#n =" stand there, or the end of a section? */
static bool is_statement(const bat_step_scanner *scan, size_t at)
{
    if (scan->data[at] != '#')
        return begins_with(scan, at, "ENDSEC") || begins_with(scan, at, "END-ISO");
    const size_t end = past_all(scan, at + 1, BAT_STEP_DIGIT);
    if (end == at + 1)
        return false;
    at = past_all(scan, end, BAT_STEP_BLANK);
    return at < scan->size && scan->data[at] == '=';
}

/* The next statement that begins behind a ';' or at the beginning of a line. */
static size_t next_statement(const bat_step_scanner *scan, size_t at, size_t begin)
{
    size_t before = at;
    while (before > begin && bat_step_in(scan->data[before - 1], BAT_STEP_BLANK))
        before--;
    bool is_fresh = before > begin && scan->data[before - 1] == ';';
    for (size_t i = before; i < at; i++)
        is_fresh |= scan->data[i] == '\n' || scan->data[i] == '\r';
    for (; at < scan->size; at++) {
        const char c = scan->data[at];
        if (c == ';' || c == '\n' || c == '\r')
            is_fresh = true;
        else if (!bat_step_in(c, BAT_STEP_BLANK)) {
            if (is_fresh && at > begin && is_statement(scan, at))
                return at;
            is_fresh = false;
        }
    }
    return scan->size;
}

/* Say what is wrong and go on behind it. A quote that is missing makes strings of what stands
 * between strings: then the string that runs over the end of a line is where to look. */
static void go_on(reading *r, size_t *at)
{
    bat_step_scanner *scan = &r->scan;
    bat_input *input = r->file->input;
    const bool is_end = scan->at >= scan->size,
               is_comment = !strncmp(scan->problem, "a comm", 6);
    const size_t from = is_comment ? scan->size : scan->string ? scan->string : scan->at;
    const size_t next = next_statement(scan, from, r->statement);
    r->file->scanned += (scan->far - r->statement) + (next - from);
    char entity[32] = "";
    if (r->id > 0)
        snprintf(entity, sizeof entity, "#%llu", (unsigned long long)r->id);
    batten_notes_add(input->notes, input->file,
                     bat_step_line(r->file, is_end ? r->statement : scan->at), entity, "%s%s",
                     is_end ? "the file ends here: " : scan->problem,
                     is_end       ? scan->problem
                     : is_comment ? "; nothing after it is read"
                                  : "; left out");
    if (is_end || is_comment)
        input->is_cut = true;
    else
        input->left_out++;
    scan->problem = NULL;
    *at = next;
}

/* ---- records and instances ---- */

static batten_status scan_record(reading *r, size_t *at)
{
    const size_t begin = *at;
    if (!bat_step_scan_keyword(&r->scan, at))
        return BATTEN_OK;
    const size_t length = *at - begin;
    if (!bat_step_scan_blank(&r->scan, at))
        return BATTEN_OK;
    const size_t list = *at;
    if (!bat_step_scan_list(&r->scan, at))
        return BATTEN_OK;
    if (list - begin > UINT32_MAX) {
        r->scan.problem = "a keyword is too far from its arguments";
        return BATTEN_OK;
    }
    const bat_step_record record = {.id = r->id,
                                    .keyword = r->scan.data + begin,
                                    .keyword_length = (uint32_t)length,
                                    .arguments = (uint32_t)(list - begin)};
    return bat_list_add(r->file->input, &r->file->records, &record);
}

/* The records of a complex instance, behind its '('. */
static batten_status scan_records(reading *r, size_t *at)
{
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && !r->scan.problem) {
        if (!bat_step_scan_blank(&r->scan, at))
            break;
        if (*at < r->scan.size && r->scan.data[*at] == ')') {
            ++*at;
            break;
        }
        status = scan_record(r, at);
    }
    return status;
}

static batten_status add_instance(reading *r, size_t first)
{
    bat_step_file *file = r->file;
    const bat_step_instance instance = {.id = r->id,
                                        .at = r->statement,
                                        .first_record = (uint32_t)first,
                                        .record_count =
                                            (uint32_t)(file->records.count - first)};
    const size_t most = file->input->limits.entities;
    batten_status status =
        bat_input_limit(file->input, 0, file->records.count,
                        most < UINT32_MAX ? most : UINT32_MAX - 1, "records of instances");
    return status == BATTEN_OK ? bat_list_add(file->input, &file->instances, &instance)
                               : status;
}

static batten_status scan_instance(reading *r, size_t *at)
{
    bat_step_scanner *scan = &r->scan;
    batten_status status = BATTEN_OK;
    const size_t first = r->file->records.count;
    if (r->section != DATA && !r->has_data)
        note_damage(r, *at, "there are instances outside a DATA section");
    r->has_data = true;
    if (!bat_step_scan_id(scan, at, &r->id) ||
        !bat_step_scan_byte(scan, at, '=', "expected '=' after the number of an instance") ||
        !bat_step_scan_blank(scan, at))
        return BATTEN_OK;
    if (*at < scan->size && scan->data[*at] == '(') {
        ++*at;
        status = scan_records(r, at);
        if (!scan->problem && r->file->records.count == first) {
            scan->problem = "the instance is empty";
            scan->at = *at;
        }
    } else {
        status = scan_record(r, at);
    }
    if (status == BATTEN_OK && !scan->problem &&
        bat_step_scan_byte(scan, at, ';', "expected ';' after an instance"))
        return add_instance(r, first);
    r->file->records.count = first;
    return status;
}

/* ---- sections ---- */

/* A string of the header: argument k of a record, or the first item of that list. */
static void take_string(const reading *r, size_t keyword, size_t list, int k, size_t size,
                        char *buffer)
{
    bat_step_record record = {.keyword = r->scan.data + keyword,
                              .keyword_length = 1,
                              .arguments = (uint32_t)(list - keyword)};
    const bat_step_value value =
        bat_step_value_at(r->file, bat_step_argument(r->file, &record, k));
    if (value.kind == BAT_STEP_LIST) {
        record.arguments = (uint32_t)(value.at - keyword);
        k = 0;
    }
    if (bat_step_get_string(r->file, &record, k, size, buffer) != BATTEN_OK)
        buffer[0] = '\0';
}

static bool is_word(const bat_step_scanner *scan, size_t at, size_t end, const char *word)
{
    return end - at == strlen(word) && bat_step_same_word(scan->data + at, word, end - at);
}

/* A record of the header, or anything else that begins with a keyword. */
static void scan_header_record(reading *r, size_t keyword, size_t length, size_t at,
                               size_t *end)
{
    bat_step_file *file = r->file;
    *end = at;
    if (!bat_step_scan_list(&r->scan, end) ||
        !bat_step_scan_byte(&r->scan, end, ';', "expected ';' after a record of the header"))
        return;
    if (is_word(&r->scan, keyword, keyword + length, "FILE_SCHEMA"))
        take_string(r, keyword, at, 0, sizeof file->schema, file->schema);
    if (is_word(&r->scan, keyword, keyword + length, "FILE_NAME")) {
        take_string(r, keyword, at, 0, sizeof file->name, file->name);
        take_string(r, keyword, at, 5, sizeof file->system, file->system);
    }
}

/* Behind the next ENDSEC: sections of anchors, references and signatures are not read. */
static size_t behind_section(const bat_step_scanner *scan, size_t at)
{
    while (at < scan->size && !begins_with(scan, at, "ENDSEC"))
        at++;
    return at;
}

/* ISO-10303-21; HEADER; DATA; DATA(...); ENDSEC; and the like: true when it was one of them. */
static bool scan_section(reading *r, size_t begin, size_t end, size_t *at)
{
    bat_step_scanner *scan = &r->scan;
    static const char *const skipped[] = {"ANCHOR", "REFERENCE", "SIGNATURE"};
    for (size_t i = 0; i < 3; i++)
        if (is_word(scan, begin, end, skipped[i])) {
            *at = behind_section(scan, end);
            return true;
        }
    if (is_word(scan, begin, end, "DATA")) {
        r->section = DATA;
        r->has_data = true;
        if (!bat_step_scan_blank(scan, at))
            return true;
        if (*at < scan->size && scan->data[*at] == '(' && !bat_step_scan_list(scan, at))
            return true;
    } else if (is_word(scan, begin, end, "HEADER")) {
        r->section = HEADER;
    } else if (is_word(scan, begin, end, "ENDSEC")) {
        r->section = BETWEEN;
    } else if (is_word(scan, begin, end, "END-ISO-10303-21")) {
        r->is_over = true;
        if (r->section == DATA)
            note_damage(r, begin, "the DATA section has no ENDSEC");
    } else if (!is_word(scan, begin, end, "ISO-10303-21")) {
        return false;
    }
    if (bat_step_scan_byte(scan, at, ';', "expected ';' here"))
        r->file->has_end |= r->is_over;
    return true;
}

static batten_status scan_statement(reading *r, size_t *at)
{
    bat_step_scanner *scan = &r->scan;
    r->statement = *at;
    scan->string = 0;
    if (scan->data[*at] == '#')
        return scan_instance(r, at);
    if (!bat_step_scan_keyword(scan, at)) {
        scan->problem = "this is neither an instance nor the end of a section";
        return BATTEN_OK;
    }
    const size_t end = *at;
    if (scan_section(r, r->statement, end, at) || !bat_step_scan_blank(scan, at))
        return BATTEN_OK;
    if (r->section == DATA) {
        scan->problem = "this is neither an instance nor the end of a section";
        scan->at = r->statement;
        return BATTEN_OK;
    }
    scan_header_record(r, r->statement, end - r->statement, *at, at);
    return BATTEN_OK;
}

/* ---- the whole ---- */

/* Signatures may follow the end. */
static void note_behind(reading *r, size_t at)
{
    size_t unfinished = SIZE_MAX;
    at = bat_step_blank(r->scan.data, r->scan.size, at, &unfinished);
    if (at < r->scan.size && !begins_with(&r->scan, at, "SIGNATURE"))
        bat_input_behind(r->file->input, at);
}

static batten_status scan_all(reading *r)
{
    bat_step_scanner *scan = &r->scan;
    batten_status status = BATTEN_OK;
    for (size_t at = 0; status == BATTEN_OK && !r->is_over;) {
        r->statement = at;
        r->id = 0; /* a comment before it belongs to no instance */
        if (bat_step_scan_blank(scan, &at)) {
            if (at >= scan->size)
                break;
            status = scan_statement(r, &at);
        }
        if (status == BATTEN_OK && scan->problem) {
            r->is_over = false;
            go_on(r, &at);
        } else {
            r->file->scanned += at - r->statement;
        }
        if (status == BATTEN_OK && at >= r->step) {
            status = bat_input_step(r->file->input, at / 2);
            r->step = at + 65536;
        }
        if (status == BATTEN_OK && r->is_over)
            note_behind(r, at);
    }
    return status;
}

static void note_ending(reading *r)
{
    bat_input *input = r->file->input;
    const bat_step_scanner *scan = &r->scan;
    if (scan->lower_case != SIZE_MAX)
        note_damage(r, scan->lower_case, "keywords are in lower case; read as in upper case");
    if (scan->broken_string != SIZE_MAX)
        note_damage(r, scan->broken_string,
                    "a string continues over the end of a line; the break is dropped");
    if (scan->bare_point != SIZE_MAX)
        note_damage(r, scan->bare_point,
                    "a number has no digit before its point; read as with a 0");
    if (r->file->has_end || input->is_cut)
        return;
    if (r->section == DATA && !r->is_over) {
        note_damage(r, input->size ? input->size - 1 : 0,
                    "the file ends in a DATA section; what is whole is read");
        input->is_cut = true;
    } else {
        note_damage(r, input->size ? input->size - 1 : 0, "END-ISO-10303-21; is missing");
    }
}

batten_status bat_step_begin(bat_input *input, bat_step_file *file)
{
    *file = (bat_step_file){.input = input,
                            .records = {.size = sizeof(bat_step_record)},
                            .instances = {.size = sizeof(bat_step_instance)},
                            .lines = {.size = sizeof(uint32_t)}};
    reading r = {.file = file,
                 .scan = {.data = input->data,
                          .size = input->size,
                          .nesting = input->limits.nesting,
                          .string_bytes = input->limits.string_bytes,
                          .lower_case = SIZE_MAX,
                          .broken_string = SIZE_MAX,
                          .bare_point = SIZE_MAX}};
    batten_status status = bat_step_table_lines(file);
    if (status == BATTEN_OK)
        status = scan_all(&r);
    if (status == BATTEN_OK && !r.has_data)
        status = bat_input_fail(input, BATTEN_BAD_FORMAT, 0, "there is no DATA section");
    if (status == BATTEN_OK) {
        note_ending(&r);
        status = bat_step_table_finish(file);
    }
    if (status != BATTEN_OK)
        bat_step_end(file);
    return status;
}

void bat_step_end(bat_step_file *file)
{
    bat_release(file->records.items);
    bat_release(file->instances.items);
    bat_release(file->lines.items);
    bat_release(file->index);
    *file = (bat_step_file){.input = file->input};
}
