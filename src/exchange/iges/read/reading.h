/*
 * What is known of an IGES file while it is read.
 *
 * Entities are decoded when something asks for them. Curves and surfaces that others refer to
 * are kept with their entry, so that each is decoded once; while one is being decoded it is
 * marked, so that a ring of references ends. How deep entities may lie within entities is
 * bounded by limits.nesting; each depth has its own store of parameters.
 */
#ifndef BAT_IGES_READING_H
#define BAT_IGES_READING_H
#include "exchange/iges/text/records.h"
#include "exchange/reading/census.h"

typedef struct bat_iges_item bat_iges_item;

typedef enum {
    BAT_IGES_AUXILIARY, /* no geometry, and nothing is lost: matrices, colours, groups */
    BAT_IGES_PART,      /* has a meaning within another entity only */
    BAT_IGES_POINTS,
    BAT_IGES_CURVE,
    BAT_IGES_SURFACE,
    BAT_IGES_BODY,
    BAT_IGES_INSTANCE,
    BAT_IGES_UNKNOWN
} bat_iges_kind;

/* A type of entity. */
typedef struct {
    int type;
    const char *name; /* "126 B-spline curve" */
    bat_iges_kind kind;
    int low, high;                          /* the forms that are read */
    batten_status (*read)(bat_iges_item *); /* NULL for what is read within others */
    const char *references; /* where its parameters refer to geometry; see references.h */
} bat_iges_row;

/* All types, with rising numbers. Their table names the readers, which lie above what they
 * share; so it is handed in with the reading. */
typedef struct {
    const bat_iges_row *rows;
    size_t count;
} bat_iges_types;
bat_iges_types bat_iges_all_types(void);

typedef enum { BAT_IGES_NEW, BAT_IGES_BUSY, BAT_IGES_READ, BAT_IGES_BAD } bat_iges_state;

/* What became of an entry. */
typedef struct {
    bat_iges_state state;
    bool is_met;              /* its parts were gone through as members of another */
    bool is_part;             /* another geometric entity refers to it */
    bool has_vanished;        /* a number of it did, which was said */
    int group;                /* its place among the groups, from 1; 0: in none */
    int table;                /* of a list of vertices or edges, from 1; 0: not yet read */
    batten_curve *curve;      /* kept: of parts */
    batten_surface *surface;  /* kept: of parts */
    batten_model *definition; /* kept: of a 308 */
} bat_iges_shape;

/* What is odd about a field of the directory, in one entry or in many. */
typedef struct {
    int count;
    const bat_iges_entry *first;
    int value; /* there */
    char why[160];
} bat_iges_odd;

typedef struct {
    bat_iges_file file;
    bat_input *input;
    bat_iges_types types;
    double unit_metres;
    double resolution, extent; /* global parameters 19 and 20; 0 when they say nothing */
    bat_census census;
    bat_iges_shape *shapes; /* one for each entry */
    bat_list groups;        /* see attributes.h */
    bat_list levels;        /* see levels.h */
    bat_list tables;        /* see topology.c */
    bat_list frames;        /* of bat_iges_parameters *, one for each depth */
    int depth;
    int body;         /* the number of the body that is being made */
    double body_miss; /* how far its edges miss their surfaces */
    /* Oddities that are said once: */
    int orphans, turned_loops, swapped_loops, gaps, loose;
    double largest_gap, largest_miss;
    bat_iges_odd wrong_colours, wrong_levels, many_levels;
    int reasons[32]; /* for which an entity was left out: its type, or -1 - its use */
    int reason_count;
    batten_model *model;
} bat_iges_reading;

/* An entity that is being decoded: its parameters, and what they become. */
struct bat_iges_item {
    bat_iges_reading *reading;
    const bat_iges_entry *entry;
    const bat_iges_row *row;
    bat_iges_parameters *parameters;
    size_t own; /* parameters of its own; after them stand associativities and properties */
    batten_curve *curve;
    batten_surface *surface;
    batten_body *body;
    int point_count;
    double *points;
    batten_model *definition;
    batten_affine place;
};

/* The row of a type; one of the kind UNKNOWN when there is none. */
const bat_iges_row *bat_iges_row_of(const bat_iges_reading *reading, int type);
enum { BAT_IGES_TYPE_NAME = 48 };
/* "150 block"; a type without a row by its number. */
void bat_iges_name_of_type(const bat_iges_reading *reading, int type,
                           char name[BAT_IGES_TYPE_NAME]);
/* Count one entity of a type among those that were read, that were left out. */
batten_status bat_iges_count_read(bat_iges_reading *reading, int type);
batten_status bat_iges_count_left_out(bat_iges_reading *reading, int type);

/* Read the parameters of an entry; to be closed also after a failure. */
batten_status bat_iges_open(bat_iges_reading *reading, const bat_iges_entry *entry,
                            bat_iges_item *item);
/* Give back what it was made into. */
void bat_iges_close(bat_iges_item *item);

/* Open it and make what it says, moved by its own matrices. */
batten_status bat_iges_decode(bat_iges_reading *reading, const bat_iges_entry *entry,
                              bat_iges_item *item);

/* The curve, surface that an id refers to, kept with its entry. */
batten_status bat_iges_curve(bat_iges_reading *reading, int id, const batten_curve **out);
batten_status bat_iges_surface(bat_iges_reading *reading, int id, const batten_surface **out);

/* How far things that should meet may miss each other: the resolution of the file as bat_judged_accuracy
 * judges it, and at least 1e-9 of the size of the model; `size` is that of what is at hand. */
double bat_iges_tolerance(const bat_iges_reading *reading, double size);

/* A fault of data in another entity: its number before the message. */
batten_status bat_iges_fault_in(batten_status status, int id);
void bat_iges_count_odd(bat_iges_odd *odd, const bat_iges_entry *entry, int value);
/* Bad data in a field of the directory, `value`, count as none, and as odd, with the
 * message. */
batten_status bat_iges_forgive(batten_status status, bat_iges_odd *odd,
                               const bat_iges_entry *entry, int value);
/* A note, a remark on an entity; "#5 126 B-spline curve". */
void bat_iges_note(const bat_iges_reading *reading, const bat_iges_entry *entry,
                   const char *format, ...) BATTEN_PRINTF(3, 4);
void bat_iges_remark(const bat_iges_reading *reading, const bat_iges_entry *entry,
                     const char *format, ...) BATTEN_PRINTF(3, 4);

/* Is it the data's fault, so that the rest of the file may still be read? */
bool bat_iges_is_fault_of_data(batten_status status);

/* The parameter `index` of an item as memory for `count` reals, checked against how many there
 * are. */
batten_status bat_iges_real_array(bat_iges_item *item, size_t first, size_t count,
                                  double **out);
batten_status bat_iges_need(const bat_iges_item *item, size_t count);
/* So many reals that no count announces; those that are left out at the end are 0, as the
 * format has it, with a remark; one at least must be there. */
batten_status bat_iges_reals_or_0(const bat_iges_item *item, size_t first, size_t count,
                                  double *values);
/* A count of things of `width` parameters each, that must be there from `first` on. */
batten_status bat_iges_read_count(const bat_iges_item *item, size_t index, size_t first,
                                  size_t width, int *count);

#endif
