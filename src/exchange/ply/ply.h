/* PLY: elements with properties that the header names, as text or as bytes. It has no units.
 * Source: [Turk94]. */
#ifndef BAT_PLY_H
#define BAT_PLY_H
#include "exchange/reading/input.h"
#include "exchange/reading/scan.h"
#include <batten/exchange.h>
#include <batten/text.h>

batten_status bat_ply_recognise(const bat_input *input, bool *is_such);
batten_status bat_read_ply(bat_input *input, batten_model **out);
batten_status bat_write_ply(const batten_model *model, const batten_write_options *options,
                            batten_notes *notes, batten_text *text);

/* ---- the header (src/exchange/ply/header.c) ---- */

typedef struct {
    int bytes;
    bool is_real, is_signed;
} bat_ply_type;

typedef struct {
    bat_span name;
    bat_ply_type type;
    bool is_list;
    bat_ply_type count_type; /* of a list */
} bat_ply_property;

typedef struct {
    bat_span name;
    size_t count;
    size_t first, properties; /* of the list of all */
} bat_ply_element;

typedef enum { BAT_PLY_TEXT, BAT_PLY_LITTLE, BAT_PLY_BIG } bat_ply_form;

typedef struct {
    bat_ply_form form;
    bat_list elements, properties;
    size_t body; /* where the elements begin */
    int line;    /* the line of it */
} bat_ply_header;

/* Zeroed before; release by bat_ply_header_end, also after a failure. */
batten_status bat_ply_header_read(bat_input *input, bat_ply_header *header);
void bat_ply_header_end(bat_ply_header *header);

/* ---- the items of elements (src/exchange/ply/items.c) ---- */

typedef struct {
    bat_input *input;
    bat_ply_form form;
    size_t at;
    int line;       /* of text */
    bat_scan words; /* what is left of the line */
} bat_ply_items;

typedef enum {
    BAT_PLY_READ,
    BAT_PLY_ODD, /* this item is no good; the next can be read */
    BAT_PLY_LOST /* the file ends, or where the next one begins cannot be known */
} bat_ply_result;

/* Read one item: [properties] numbers, NaN for what is none; the length for a list. The list
 * that is property `wanted` comes as int64_t into `list`, -1 for what is no index. */
batten_status bat_ply_item(bat_ply_items *items, const bat_ply_property *properties,
                           size_t count, size_t wanted, double *values, bat_list *list,
                           bat_ply_result *result);
/* The least bytes that an item takes. */
size_t bat_ply_least(bat_ply_form form, const bat_ply_property *properties, size_t count);

#endif
