/*
 * The text of a DXF file as groups: a line with a code, a line with a value. An entity is a
 * group with code 0 and all that follow it up to the next such group.
 */
#ifndef BAT_DXF_PAIRS_H
#define BAT_DXF_PAIRS_H
#include "exchange/reading/census.h"
#include "exchange/reading/input.h"
#include <batten/geometry.h>

typedef struct {
    int code, line; /* the line of the value */
    bat_span value; /* without blanks around it */
} bat_dxf_group;

typedef struct {
    bat_input *input;
    size_t at;
    int line;
    bat_list groups; /* of bat_dxf_group: the entity at work, the first with code 0 */
    bool has_next;   /* `next` is the group with code 0 that comes then */
    bat_dxf_group next;
    size_t next_at; /* where it begins in the text, */
    int next_line;  /* and how many lines stand before it */
} bat_dxf_pairs;

void bat_dxf_pairs_begin(bat_dxf_pairs *pairs, bat_input *input, size_t at, int line);
void bat_dxf_pairs_end(bat_dxf_pairs *pairs);
/* Go to the next entity; *more is false at the end of the text. A line that is no code is
 * BAD_FORMAT. */
batten_status bat_dxf_next(bat_dxf_pairs *pairs, bool *more);

/* ---- the entity at work ---- */

/* "LINE"; copied, at most 31 bytes of it. */
const char *bat_dxf_kind(const bat_dxf_pairs *pairs, char name[32]);
bool bat_dxf_is(const bat_dxf_pairs *pairs, const char *kind);
/* The first group of a code, NULL when there is none. */
const bat_dxf_group *bat_dxf_find(const bat_dxf_pairs *pairs, int code);
/* How many groups of a code there are. */
size_t bat_dxf_count(const bat_dxf_pairs *pairs, int code);
/* A number; `standard` when there is none. BAD_FORMAT with a message for a note. */
batten_status bat_dxf_get_real(const bat_dxf_pairs *pairs, int code, double standard,
                               double *value);
batten_status bat_dxf_get_integer(const bat_dxf_pairs *pairs, int code, int standard,
                                  int *value);
/* Codes c, c + 10, c + 20; what is missing is that of `standard`. */
batten_status bat_dxf_get_point(const bat_dxf_pairs *pairs, int code, batten_vec3 standard,
                                batten_vec3 *value);
/* All numbers of a code, in new memory of that many. */
batten_status bat_dxf_get_reals(const bat_dxf_pairs *pairs, int code, size_t count,
                                double **values);
/* A text, copied and cut to the buffer, \U+XXXX decoded; "" when there is none. */
void bat_dxf_get_text(const bat_dxf_pairs *pairs, int code, size_t size, char *buffer);
batten_status bat_dxf_number(const bat_dxf_pairs *pairs, const bat_dxf_group *group,
                             double *value);

#endif
