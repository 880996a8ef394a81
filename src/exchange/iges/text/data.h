/* The parameter section while records are read, and what a record is. */
#ifndef BAT_IGES_DATA_H
#define BAT_IGES_DATA_H
#include "exchange/iges/text/records.h"

#include <string.h>

#define DATA_COLUMNS 64
#define GLOBAL_COLUMNS 72
#define RECORD 80
#define LETTER 72 /* where the letter of the section stands */

/* The number at the end of a record, in blanks or after zeros; -1 when there is none. */
int bat_iges_sequence_number(bat_span record);
/* Append the first `columns` characters of a record, blanks where it ends before. */
batten_status bat_iges_append(bat_input *input, bat_list *list, bat_span record,
                              size_t columns);

batten_status bat_iges_add_data(bat_iges_file *file, bat_span record, int line,
                                bool is_damaged);
/* How many plain records from `at` on go on with the last run of at least two; at most `most`,
 * which are added to it. `line` is that of its last one. */
size_t bat_iges_add_to_run(bat_iges_file *file, size_t at, int line, size_t most);
/* Where the sequence numbers do not rise, the places of the records count. */
void bat_iges_number_data(bat_iges_file *file);

/* ---- many characters at once ---- */

/* Compilers make one instruction of a comparison of all. */
typedef unsigned char characters __attribute__((vector_size(16)));

static inline bool any_of(characters marks)
{
    uint64_t halves[2];
    memcpy(halves, &marks, sizeof halves);
    return (halves[0] | halves[1]) != 0;
}

/* Does a record of 80 columns with its end stand there, without control characters? Nearly all
 * do, and this is the fastest way to see it: its length with the end, or 0. */
static inline size_t bat_iges_plain_record(const bat_input *input, size_t at)
{
    characters below = {0};
    const char *record = input->data + at;
    if (input->size - at < RECORD + 2)
        return 0;
    for (size_t i = 0; i < RECORD; i += sizeof below) {
        characters some;
        memcpy(&some, record + i, sizeof some);
        below |= (characters)(some < ' ');
    }
    if (any_of(below))
        return 0;
    if (record[RECORD] == '\n')
        return RECORD + 1;
    return record[RECORD] == '\r' && record[RECORD + 1] == '\n' ? RECORD + 2 : 0;
}

#endif
