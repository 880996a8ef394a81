/* What stands around the entities of a DXF file: unit, layers, and where blocks are. */
#ifndef BAT_DXF_SURVEY_H
#define BAT_DXF_SURVEY_H
#include "exchange/dxf/dxf.h"
#include "exchange/dxf/pairs.h"

/* What is asked for by name; of those with the same name, the first that stands in the text. */
typedef struct {
    char name[BAT_DXF_NAME];
    size_t at; /* where the text goes on after it */
} bat_dxf_named;

typedef struct {
    bat_dxf_named is;
    bool is_hidden, has_colour;
    double colour[3];
} bat_dxf_layer_entry;

/* A block stands in the text until an INSERT asks for it. */
typedef struct {
    bat_dxf_named is;
    batten_vec3 base;
    int line;
    bool is_at_work; /* to find blocks that hold themselves */
    bool has_lost;   /* something that it holds is left out */
    batten_model *model;
    /* Colours that depend on the INSERT: src/exchange/dxf/blocks.h. */
    bat_list parts, variants;
    bool has_floating, is_bound;
} bat_dxf_block;

typedef struct {
    bat_input *input;
    bat_census census;
    bat_list layers, blocks; /* by name, once they are all there */
    double unit_metres;
    size_t entities_at; /* 0: there is no such section */
    int entities_line;
    int thick;          /* entities with a thickness */
    int number, copied; /* copied: objects, for the colours of INSERTs */
    int instances, in_arrays;
} bat_dxf_reading;

/* Go through the file once. */
batten_status bat_dxf_survey(bat_dxf_reading *reading);
/* By name, NULL when there is none: the one with just these letters, else one that differs in
 * capitals, which say nothing in names (only those of ASCII are known as such). */
const bat_dxf_layer_entry *bat_dxf_find_layer(const bat_dxf_reading *reading, const char *name);
bat_dxf_block *bat_dxf_find_block(const bat_dxf_reading *reading, const char *name);

#endif
