/*
 * The text of a STEP file, ISO 10303-21, as a table of instances with typed arguments. What
 * they mean is for the files beside it.
 *
 * The file is gone through once. Tokens stay where they are in the data: a value says where.
 */
#ifndef BAT_STEP_INSTANCES_H
#define BAT_STEP_INSTANCES_H
#include "exchange/census.h"
#include "exchange/input.h"

typedef enum {
    BAT_STEP_NOTHING, /* $ */
    BAT_STEP_DERIVED, /* * */
    BAT_STEP_INTEGER,
    BAT_STEP_REAL,
    BAT_STEP_STRING,
    BAT_STEP_REFERENCE, /* #n */
    BAT_STEP_ENUM,      /* .WORD. */
    BAT_STEP_BINARY,
    BAT_STEP_LIST, /* its items follow */
    BAT_STEP_TYPED /* KEYWORD(value): one value follows */
} bat_step_kind;

/* One value. The items of a list follow it; `next` is the value after the whole. */
typedef struct {
    uint32_t kind : 8, length : 24; /* bytes of the token, without quotes and dots; 2^24 - 1 for
                                       longer ones, which are scanned again */
    uint32_t next;                  /* index of the value that follows this one and its items */
    union {
        size_t at;     /* of the token in the data: STRING, ENUM, BINARY, TYPED */
        double real;   /* REAL */
        int64_t whole; /* INTEGER; REFERENCE: its id; LIST: how many items */
    };
} bat_step_value;

/* KEYWORD(arguments): a simple instance has one, a complex instance several. */
typedef struct {
    const char *keyword; /* in the data */
    uint32_t keyword_length;
    uint32_t values; /* index of the LIST of its arguments */
} bat_step_record;

typedef struct {
    uint64_t id;
    size_t at; /* where it begins in the data, for bat_step_line */
    uint32_t first_record, record_count;
} bat_step_instance;

typedef struct {
    bat_input *input;
    bat_list values, records, instances; /* of the above; instances with rising ids */
    /* From the header: */
    char schema[128], system[128], name[128];
    bool has_end;
} bat_step_file;

/* Take the file apart. Broken instances are left out, each with a note. */
batten_status bat_step_begin(bat_input *input, bat_step_file *file);
void bat_step_end(bat_step_file *file);
/* The line where an instance begins. */
int bat_step_line(const bat_step_file *file, size_t at);

/* NULL when there is none. O(log n), O(1) for ids without gaps. */
const bat_step_instance *bat_step_find(const bat_step_file *file, uint64_t id);
/* Its record of that keyword; NULL when it has none. */
const bat_step_record *bat_step_as(const bat_step_file *file, const bat_step_instance *instance,
                                   const char *keyword);

/* ---- arguments: BAD_FORMAT with a message "argument 3 is a string, not a number" ---- */

/* The index of argument k (from 0) of a record; the count when there are fewer. */
size_t bat_step_argument(const bat_step_file *file, const bat_step_record *record, int k);
int bat_step_argument_count(const bat_step_file *file, const bat_step_record *record);
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
/* A list of `count` items, whose values begin at index *first; walk with `next`. */
batten_status bat_step_get_list(const bat_step_file *file, const bat_step_record *record, int k,
                                int *count, size_t *first);
/* A string as UTF-8, decoded (\X2\ and so on), cut to the buffer; "" for $. */
batten_status bat_step_get_string(const bat_step_file *file, const bat_step_record *record,
                                  int k, size_t size, char *buffer);
bool bat_step_is(const bat_step_file *file, const bat_step_record *record, int k,
                 const char *word); /* an ENUM of that word */

#endif
