/* The one table of formats: their names, who reads and who writes them. */
#ifndef BAT_FORMATS_H
#define BAT_FORMATS_H
#include "exchange/reading/input.h"
#include <batten/exchange.h>
#include <batten/text.h>

typedef struct {
    batten_format format;
    const char *name;       /* as designs write it: "step" */
    const char *title;      /* "STEP" */
    const char *endings[4]; /* of file names */
    /* Is this the format of the bytes? A form of it that is not read is refused. NULL: what is
     * in rows of numbers decides. */
    batten_status (*recognise)(const bat_input *input, bool *is_such);
    bool is_binary; /* zero bytes are allowed */
    batten_status (*read)(bat_input *input, batten_model **out);
    /* The model has only objects of the kinds that the format holds, when it names any. */
    unsigned holds; /* bits 1 << BATTEN_OBJECT_... */
    /* Can it say such a place of an instance? NULL: any. */
    bool (*can_place)(const batten_affine *place);
    unsigned keeps;         /* of a mesh: bits BAT_KEEPS_... */
    bool paints;            /* an instance can have a colour of its own */
    unsigned says;          /* of an object that it holds: bits BAT_SAYS_... */
    unsigned lesser, lacks; /* kinds, as in holds, of which it does not say all: which bits */
    bool names_layers;      /* an object without a layer lies on one of its name */
    batten_status (*write)(const batten_model *model, const batten_write_options *options,
                           batten_notes *notes, batten_text *text);
} bat_format_row;

/* NULL when there is no such format. */
const bat_format_row *bat_format_of(batten_format format);
/* From 0 on; NULL at the end. */
const bat_format_row *bat_format_at(size_t index);

enum {
    BAT_KEEPS_COLOURS = 1, /* of vertices */
    BAT_KEEPS_TRIANGLE_COLOURS = 2,
    BAT_KEEPS_VALUES = 4 /* further ones of each vertex */
};

enum {
    BAT_SAYS_NAMES = 1,
    BAT_SAYS_LAYERS = 2,
    BAT_SAYS_COLOURS = 4,
    BAT_SAYS_GROUPS = 8,
    BAT_SAYS_HIDDEN = 16, /* that it is not to be shown */
    BAT_SAYS_ALL = 31
};

#define BAT_HOLDS(kind) (1u << BATTEN_OBJECT_##kind)

#endif
