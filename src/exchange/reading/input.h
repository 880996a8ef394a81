/* What every reader is given, and how it speaks of it. */
#ifndef BAT_INPUT_H
#define BAT_INPUT_H
#include "base/base.h"
#include "base/work.h"
#include <batten/exchange.h>
#include <stdint.h>

/* Programs write numbers with nine or ten digits: where things differ by less than this part of
 * their size, a file means them to be the same. */
#define BAT_WRITTEN 1e-9

typedef struct {
    const char *data; /* without a byte order mark and without a final control-Z */
    size_t size;
    const char *file; /* for messages; may be "" */
    batten_limits limits;
    bat_work work;
    batten_notes *notes;
    size_t memory;  /* bytes asked for so far */
    uint64_t again; /* bytes that a reader came back to */
    /* Either makes the result BATTEN_PARTLY_READ: */
    int left_out; /* entities that could not be read */
    bool is_cut;  /* the end of the file is missing */
} bat_input;

/* Fill in the defaults and check the size of the file. */
batten_status bat_input_begin(const char *data, size_t size, const batten_read_options *options,
                              const batten_job *job, batten_notes *notes, bat_input *input);
/* Skip a byte order mark, refuse UTF-16: of what begins as text, whatever follows. */
batten_status bat_input_past_mark(bat_input *input);
/* Skip a byte order mark, drop a final control-Z, refuse UTF-16 and zero bytes. */
batten_status bat_input_as_text(bat_input *input);

/* "hull.csv:12: " and the sentence; line 0 is left out. */
batten_status bat_input_fail(const bat_input *input, batten_status status, int line,
                             const char *format, ...) BATTEN_PRINTF(4, 5);
/* The sentence of the last failure without the place that bat_input_fail put before it, for a
 * note; *line is that of the place, 0 for none. */
const char *bat_input_reason(const bat_input *input, int *line);
/* A note when something stands from `at` on, behind the end of what was read: not white space,
 * not zero bytes, with which some fill up. */
void bat_input_behind(const bat_input *input, size_t at);
/* Ask whether to go on: at[size] of the file has been reached. */
batten_status bat_input_step(bat_input *input, size_t at);
/* BATTEN_TOO_LARGE when `count` is above the limit on what `what` names. */
batten_status bat_input_limit(const bat_input *input, int line, size_t count, size_t limit,
                              const char *what);
/* How many points, or pieces, what comes near an offset or such of a shape that has so many may
 * need: a hundred times as many, and some. What needs more does not come near its truth. */
int bat_input_most_near(const bat_input *input, double points);
/* Zeroed memory that counts towards the limit; on failure *memory is untouched. */
batten_status bat_input_array(bat_input *input, size_t count, size_t size, void *memory);

/* Give such memory back, so that it counts no more; NULL is welcome. */
void bat_input_release(bat_input *input, size_t count, size_t size, void *memory);

/* A list that grows; begin with {.size = sizeof(item)} and release `items`. */
typedef struct {
    size_t size, count, capacity;
    void *items;
} bat_list;
/* Room for `count` more. */
batten_status bat_list_reserve(bat_input *input, bat_list *list, size_t count);
batten_status bat_list_add(bat_input *input, bat_list *list, const void *item);
batten_status bat_list_append(bat_input *input, bat_list *list, const void *items,
                              size_t count);

/* A stretch of text that is not followed by a zero byte. */
typedef struct {
    const char *bytes;
    size_t length;
} bat_span;

/* Is a number that was read as 0 none, but nearer to it than any double? */
bool bat_has_vanished(bat_span number, double value);
/* A note that says so when it is. */
void bat_input_vanished(const bat_input *input, int line, const char *entity, bat_span number,
                        double value);

/* The next line from *at on, without its end (LF, CRLF or CR); false at the end of the data. */
bool bat_next_line(const bat_input *input, size_t *at, bat_span *line);
bool bat_is_blank(char c);
/* Blanks and ends of lines. */
bool bat_is_white(char c);
/* 0..15, or -1. */
int bat_hex_digit(char c);
/* A character of Unicode as UTF-8; returns how many bytes it has, 0 for none and surrogates. */
size_t bat_utf8_write(uint32_t code, char bytes[4]);

/* The end of a reader: the model goes to *out, or, where reading failed, to nobody. */
batten_status bat_input_hand_over(batten_status status, batten_model *model,
                                  batten_model **out);
/* Does a failure end the reading of the whole file? Others leave out one entity. */
bool bat_input_ends(batten_status status);

/* The accuracy to work with, where a file states one for what has this size: as stated when that makes sense, raised
 * to 1e-12 of the size, replaced by a millionth of it when there is none or it is coarser than the part `coarsest` of it.
 * @param sizeless  what is usual where the size is 0 */
double bat_judged_accuracy(double stated, double size, double coarsest, double sizeless);

#endif
