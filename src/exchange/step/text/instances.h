/*
 * The text of a STEP file, ISO 10303-21, as a table of instances. What they mean is for the
 * files beside it.
 *
 * The file is gone through once: every instance in the table is whole and well formed. Its
 * values are not kept but read from the text each time somebody asks; a place in the text, a
 * size_t, stands for a value. That is small (48 bytes an instance) and fast, since most are
 * asked for once.
 *
 * Cost: one pass over the text; what is asked for is walked over from the beginning of its
 * record. Source: [Part21].
 */
#ifndef BAT_STEP_INSTANCES_H
#define BAT_STEP_INSTANCES_H
#include "exchange/reading/census.h"
#include "exchange/reading/input.h"

typedef enum {
    BAT_STEP_NOTHING, /* $ */
    BAT_STEP_DERIVED, /* * */
    BAT_STEP_INTEGER,
    BAT_STEP_REAL,
    BAT_STEP_STRING,
    BAT_STEP_REFERENCE, /* #n */
    BAT_STEP_ENUM,      /* .WORD. */
    BAT_STEP_BINARY,
    BAT_STEP_LIST,
    BAT_STEP_TYPED, /* KEYWORD(value): the token is the keyword */
    BAT_STEP_END    /* behind the last item of a list */
} bat_step_kind;

/* One value. */
typedef struct {
    bat_step_kind kind;
    size_t at,
        length;   /* its token in the data, without quotes, dots and '#'; a list: its '(' */
    size_t first; /* LIST, TYPED: where its first item stands */
} bat_step_value;

/* KEYWORD(arguments): a simple instance has one, a complex instance several. */
typedef struct {
    uint64_t id;         /* of its instance */
    const char *keyword; /* in the data, in either case */
    uint32_t keyword_length;
    uint32_t arguments; /* bytes from the keyword to the '(' */
} bat_step_record;

typedef struct {
    uint64_t id;
    size_t at; /* where it begins in the data, for bat_step_line */
    uint32_t first_record, record_count;
} bat_step_instance;

typedef struct {
    bat_input *input;
    bat_list records, instances; /* of the above; instances with rising ids */
    uint32_t *index;             /* of the instance with id first_id + k, plus one; or NULL */
    uint64_t first_id, index_count;
    bat_list lines; /* how many lines end before each block of the data */
    /* From the header: */
    char schema[128], system[128], name[128];
    bool has_end;
    uint64_t scanned; /* bytes gone over, some twice where something is wrong */
} bat_step_file;

/* Take the file apart. Broken instances are left out, each with a note; a missing end makes the
 * input cut. BAD_FORMAT when there is no data section. */
batten_status bat_step_begin(bat_input *input, bat_step_file *file);
void bat_step_end(bat_step_file *file);
/* The line of a place in the data. */
int bat_step_line(const bat_step_file *file, size_t at);

/* NULL when there is none. O(log n), O(1) for ids without large gaps. */
const bat_step_instance *bat_step_find(const bat_step_file *file, uint64_t id);
/* Its record of that keyword; NULL when it has none. */
const bat_step_record *bat_step_as(const bat_step_file *file, const bat_step_instance *instance,
                                   const char *keyword);
/* The first of its records: that of a simple instance. */
const bat_step_record *bat_step_first(const bat_step_file *file,
                                      const bat_step_instance *instance);
/* Is the keyword of the record this one; does it end so? The word is in upper case, the file's in either. */
bool bat_step_is_keyword(const bat_step_record *record, const char *word);
bool bat_step_keyword_ends(const bat_step_record *record, const char *word);
/* Are so many bytes, in either case, those of the word, which is in upper case? */
bool bat_step_same_word(const char *bytes, const char *word, size_t length);
/* Its keyword in upper case, cut to the buffer; of a complex instance the last in the alphabet
 * with B_SPLINE in it, else the first record. Handed back for convenience. */
#define BAT_STEP_KEYWORD_SIZE 80
const char *bat_step_keyword(const bat_step_file *file, const bat_step_instance *instance,
                             char buffer[BAT_STEP_KEYWORD_SIZE]);
/* The keyword of the record in upper case, cut to the buffer, which is handed back. */
const char *bat_step_upper_keyword(const bat_step_record *record,
                                   char buffer[BAT_STEP_KEYWORD_SIZE]);

/* ---- failing ---- */

/* "#317 CIRCLE: " and the sentence. All messages about instances begin so. */
batten_status bat_step_fail(const bat_step_file *file, const bat_step_instance *instance,
                            batten_status status, const char *format, ...) BATTEN_PRINTF(4, 5);
/* "#317 CIRCLE: argument 3 is a string, not a number": what stands at `at` is not `wanted`. */
batten_status bat_step_fail_kind(const bat_step_file *file, const bat_step_record *record,
                                 size_t at, const char *wanted);
/* Leave an entity out for the reason that is the message now: a note with its line, a count in
 * the census and in the input. Failures that no entity is to blame for (memory, cancelled, the
 * whole file read too many times over) are handed back, else OK. The census may be NULL. */
batten_status bat_step_leave_out(const bat_step_file *file, bat_census *census,
                                 const bat_step_instance *instance, batten_status reason);

/* ---- arguments, numbered from 0 in the code and from 1 in messages: BAD_FORMAT with
 * "#317 CIRCLE: argument 3 is a string, not a number" ---- */

/* Where argument k stands; behind the last when there are fewer. */
size_t bat_step_argument(const bat_step_file *file, const bat_step_record *record, int k);
int bat_step_argument_count(const bat_step_file *file, const bat_step_record *record);
bat_step_value bat_step_value_at(const bat_step_file *file, size_t at);
/* Where the item after the one at `at` stands. */
size_t bat_step_next(const bat_step_file *file, size_t at);

batten_status bat_step_get_real(const bat_step_file *file, const bat_step_record *record, int k,
                                double *value);
batten_status bat_step_get_integer(const bat_step_file *file, const bat_step_record *record,
                                   int k, int *value);
/* .T. and .F.; .U. counts as false */
batten_status bat_step_get_logical(const bat_step_file *file, const bat_step_record *record,
                                   int k, bool *value);
/* The instance that argument k refers to. */
batten_status bat_step_get_reference(const bat_step_file *file, const bat_step_record *record,
                                     int k, const bat_step_instance **instance);
/* A list of `count` items, of which the first stands at *first; walk with the items below. */
batten_status bat_step_get_list(const bat_step_file *file, const bat_step_record *record, int k,
                                int *count, size_t *first);
/* A string as UTF-8, decoded (\X2\ and so on), cut to the buffer; "" for $. */
batten_status bat_step_get_string(const bat_step_file *file, const bat_step_record *record,
                                  int k, size_t size, char *buffer);
bool bat_step_is(const bat_step_file *file, const bat_step_record *record, int k,
                 const char *word); /* an ENUM of that word */
/* Is argument k missing, $ or *? */
bool bat_step_is_nothing(const bat_step_file *file, const bat_step_record *record, int k);

/* ---- items of lists: read the one at *at and move *at to the next; the record is for the
 * message. A number in a KEYWORD(...) is that number. ---- */

batten_status bat_step_item_real(const bat_step_file *file, const bat_step_record *record,
                                 size_t *at, double *value);
batten_status bat_step_item_integer(const bat_step_file *file, const bat_step_record *record,
                                    size_t *at, int *value);
/* Also where it fails, so that one bad reference of a list is not all that follow. */
batten_status bat_step_item_reference(const bat_step_file *file, const bat_step_record *record,
                                      size_t *at, const bat_step_instance **instance);
batten_status bat_step_item_list(const bat_step_file *file, const bat_step_record *record,
                                 size_t *at, int *count, size_t *first);

#endif
