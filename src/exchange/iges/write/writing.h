/* An IGES file being written: its sections as they grow. */
#ifndef BAT_IGES_WRITING_H
#define BAT_IGES_WRITING_H
#include "exchange/iges/iges.h"
#include "model/definitions.h"
#include "model/groups.h"

/* ---- records of 80 columns (write_records.c) ---- */

/* A section of free text: G and P. */
typedef struct {
    batten_text *text;
    size_t columns; /* that are free: 64 of P, 72 of G */
    int count;      /* of records so far */
    char line[160]; /* the record that is being filled: longer than it is for a last token */
    size_t used;
    char tail[17]; /* what stands behind the columns */
} bat_iges_section;

void bat_iges_section_begin(bat_iges_section *section, char letter, batten_text *text);
/* End the record that is being filled, if any. */
void bat_iges_section_flush(bat_iges_section *section);
/* Tokens stand in one record each, followed by `after`. */
void bat_iges_put_integer(bat_iges_section *section, int64_t value, char after);
void bat_iges_put_real(bat_iges_section *section, double value, char after);
/* nH and the characters; line ends, which no record can hold, become blanks. */
void bat_iges_put_string(bat_iges_section *section, const char *text, char after);

/* ---- entities (write_records.c) ---- */

enum { BAT_IGES_COLOURS = 48 }; /* that are remembered */

typedef struct {
    batten_notes *notes;
    double unit_metres;
    double tolerance;
    bool has_solids; /* bodies are written whole, not face by face */
    bat_iges_section data;
    batten_text directory;
    int directory_count;
    int first; /* record of the entity that is being written */
    double colours[BAT_IGES_COLOURS]
                  [3]; /* those written last, in percent, and the ids of their entities */
    int colour_ids[BAT_IGES_COLOURS];
    int colour_count;
    double largest; /* coordinate written so far */
    bat_members groups;
    bat_members layers; /* names that are no numbers, each once; the item is the level */
    char **paths;       /* of the groups that bodies become */
    int path_count;
    bat_definitions definitions;
    int *subfigures;   /* [definitions] their ids; 0: nothing is in it */
    bat_members items; /* the ids of what was written of the definition at work */
    bool is_inside;    /* the definition at work is not the model itself */
} bat_iges_writing;

/* What the directory says of an entity; use: 0 geometry, 2 definition, 3 other, 5 parameters.
 */
typedef struct {
    int type, form, level, colour;
    int matrix; /* the id of a 124; 0: none */
    bool is_hidden, is_part;
    int use;
} bat_iges_look;

/* Begin the parameters of an entity with its type: the id is handed back. */
int bat_iges_begin_entity(bat_iges_writing *w, int type);
/* End them: its entry in the directory. */
void bat_iges_end_entity(bat_iges_writing *w, const bat_iges_look *look);
/* The last parameters of an entity: no associativity, and its name, if any. */
void bat_iges_put_properties(bat_iges_writing *w, int name);

/* ---- what entities have beside geometry (attributes.c) ---- */

/* The colour field: minus the id of an entity 314, which is written unless it just was. */
int bat_iges_put_colour(bat_iges_writing *w, const double colour[3]);
/* The id of a property with the name; 0 for an empty one. */
int bat_iges_put_name(bat_iges_writing *w, const char *name);
/* Number the layers that have other names, beyond those that are numbers, and write which is
 * which: 406 form 3, whose level it is. */
batten_status bat_iges_put_layers(bat_iges_writing *w);
/* Level, colour and visibility of an object. */
bat_iges_look bat_iges_look_of(bat_iges_writing *w, const batten_object *object);
/* Sequence numbers have 7 columns; this keeps every record below them. */
batten_status bat_iges_check_room(const bat_iges_writing *w);

/* ---- the file (write_global.c) ---- */

/* The parameters are in the text already: what comes before them is put there, and the end. */
batten_status bat_iges_join(bat_iges_writing *w, const batten_write_options *options,
                            double unit, batten_text *text);

/* ---- shapes (write_shapes.c): clamped; the id of the entity ---- */

int bat_iges_put_curve(bat_iges_writing *w, const batten_curve *curve, int name,
                       bat_iges_look look);
int bat_iges_put_surface(bat_iges_writing *w, const batten_surface *surface, int name,
                         bat_iges_look look);
/* One point as 116, several as 106. */
int bat_iges_put_points(bat_iges_writing *w, const double *points, int count, int name,
                        bat_iges_look look);

/* ---- what is placed (write_instances.c) ---- */

/* The model without what would not be written, and, unless bodies are written whole, with those
 * of several faces, where they lie among others in what is placed, as subfigures of their own.
 */
batten_status bat_iges_make_parts(const batten_model *model, bool has_solids,
                                  batten_notes *notes, batten_model **out);
/* The id of a subfigure of the items, which lie `depth` deep: 0 when none of them is placed. */
int bat_iges_put_subfigure(bat_iges_writing *w, const char *name, int depth,
                           const bat_members *items);
/* The id of an instance, whose place IGES can say. */
int bat_iges_put_instance(bat_iges_writing *w, int subfigure, const batten_affine *place,
                          int name, bat_iges_look look);

/* ---- faces (write_face.c) ---- */

/* A face as a trimmed surface, or, when nothing bounds it, as a surface. */
batten_status bat_iges_put_face(bat_iges_writing *w, const batten_body_parts *parts, int face,
                                int name, const bat_iges_look *look, int *id);
/* The curve of an edge, clamped, with ends that miss their vertices moved to them, so that
 * loops, which have no vertices in 142, close. */
batten_status bat_iges_meet_vertices(const bat_iges_writing *w, const batten_body_parts *parts,
                                     const batten_body_edge *edge, batten_curve **out);
/* Say how many ends of edges were moved to their vertices, and how far. */
void bat_iges_note_ends(const bat_iges_writing *w, const batten_body_parts *parts,
                        const char *name);

/* ---- bodies whole (write_solid.c) ---- */

/* What is to be done with the id of a solid or shell. */
typedef batten_status bat_iges_keep(void *context, int id);
/* A solid, or each shell of a body that is none, with their edges shared. */
batten_status bat_iges_put_body(bat_iges_writing *w, const batten_body_parts *parts,
                                const char *name, const bat_iges_look *look,
                                bat_iges_keep *keep, void *context);

#endif
