/* What a feature is made of: its public description, and the function that carries it out. */
#ifndef BAT_DESIGN_FEATURE_H
#define BAT_DESIGN_FEATURE_H
#include "base/base.h"
#include <batten/design.h>
#include <batten/picture.h>

/* One value of an argument, in design units and radians. */
typedef struct {
    double
        number[6]; /* LENGTH, ANGLE, NUMBER: [0]; POINT: [3]; RANGE: [0] and [1]; MOVE: all */
    int count;     /* COUNT; WORD: its place in `words`; YES_NO; MODEL: which feature,
                         as POINTS that have a text */
    const char *text; /* WORD, TEXT, FILE; MODEL, POINTS: its name */
} bat_item;

typedef struct {
    int count;  /* 0: neither given nor standard */
    bool given; /* stands in the design */
    bat_item *items;
} bat_argument;

/* What became of one feature, and how. */
typedef struct {
    bool done;
    batten_feature_result shown;
    batten_model *value;
    batten_fair_report fairing;
    double fairing_bound; /* of the points that were moved; 0: of control points */
    batten_surface_skin_report skin;
    batten_loft_report loft;
    bool has_fit; /* the curves were interpolated with these options */
    batten_curve_interpolate_options fit;
} bat_result;

typedef struct bat_run bat_run;

typedef struct {
    batten_feature shown;
    batten_status (*run)(bat_run *run);
    int family; /* of features that share `run`: which of them this is, in its enumeration */
    /* The parameter that, when given, puts the result away from the points of its inputs: then
     * distances from them mean nothing. "!keep": when it is 'no'. NULL for none. */
    const char *displacing;
    /* Parameters of whose features the points stay beside the result: "path guide". */
    const char *beside;
    /* Keeps a part of the curves and surfaces of its first parameter: points on the others go. */
    bool cuts;
    /* Of an output: does "hull.step: hull", without an operation, mean this one? Of several the
     * last of the list is taken. NULL: never. */
    bool (*takes_file)(const char *name);
} bat_feature;

#define BAT_PARAMETERS(table) (int)(sizeof(table) / sizeof((table)[0])), table

/* One evaluation of one feature. A feature reads its arguments by name and puts objects into
 * its model; an output puts bytes into `data`. */
struct bat_run {
    const char *name; /* of the feature, or the file of the output */
    const batten_feature *feature;
    int family;                    /* of the feature, for those that share their body */
    const bat_argument *arguments; /* [feature->parameter_count] */
    const struct bat_document *document;
    const bat_result *results; /* of all features of the document */
    const batten_job *job;
    batten_notes *notes;
    int line;
    long long objects;   /* that the features before this one made */
    bat_result *result;  /* of a feature */
    batten_model *model; /* of a feature: empty at first */
    char *data;          /* of an output */
    size_t size;
    bool unmet;  /* of an output: a bound that it checks is not met */
    bool partly; /* of an output: it says less than there is */
};

/* ---- arguments; the parameter must exist ---- */

const bat_argument *bat_argument_of(const bat_run *run, const char *parameter);
bool bat_has(const bat_run *run, const char *parameter); /* given, or with a standard value */
double bat_number(const bat_run *run, const char *parameter);
int bat_count(const bat_run *run, const char *parameter);
int bat_word(const bat_run *run,
             const char *parameter); /* its place in the words; -1 for none */
bool bat_yes(const bat_run *run, const char *parameter);
const char *bat_text(const bat_run *run, const char *parameter); /* NULL for none */
batten_vec3 bat_point(const bat_run *run, const char *parameter);
/* The model of an argument that is not a list. */
const batten_model *bat_model(const bat_run *run, const char *parameter);

double bat_unit_metres(const bat_run *run);
/* "mm"; "" where numbers are in a unit that nobody states: that of a model without one, given
 * to a design that names none. */
const char *bat_unit_name(const bat_run *run);
double bat_tolerance(const bat_run *run); /* that of the design, in its units */
const char *bat_file_name(const bat_run *run);
/* Say something odd about this feature, with its line: bat_note(run, "%d points ...", count).
 */
#define bat_note(run, ...) \
    batten_notes_add((run)->notes, bat_file_name(run), (run)->line, (run)->name, __VA_ARGS__)
/* The same of what is not odd: what was found, how many there are. */
#define bat_remark(run, ...) \
    batten_notes_remark((run)->notes, bat_file_name(run), (run)->line, (run)->name, __VA_ARGS__)

/* ---- objects ---- */

/* All objects of all models of an argument. */
typedef struct {
    int count;
    const batten_object **at;
} bat_objects;

/* No object is dropped in silence: an input without an object of the kinds is an error that names
 * it; where only some of its objects are of other kinds, a note says so.
 * @param kinds  bits 1 << BATTEN_OBJECT_... */
batten_status bat_gather(const bat_run *run, const char *parameter, unsigned kinds,
                         bat_objects *out);
/* The same without a word about objects of other kinds: for those that pass them on. */
batten_status bat_gather_some(const bat_run *run, const char *parameter, unsigned kinds,
                              bat_objects *out);
void bat_objects_release(bat_objects *objects);
/* Take a step for each object that bat_gather finds, up to the first that fails. */
typedef batten_status bat_object_step(bat_run *run, const batten_object *object);
batten_status bat_for_objects(bat_run *run, const char *parameter, unsigned kinds,
                              bat_object_step *step);
/* The only curve of an argument, borrowed from its feature's result. */
batten_status bat_one_curve(const bat_run *run, const char *parameter,
                            const batten_curve **out);

/* The same in one model of the design's unit. */
batten_status bat_merge(const bat_run *run, const char *parameter, unsigned kinds,
                        batten_model **out);

#define BAT_POINTS (1u << BATTEN_OBJECT_POINTS)
#define BAT_CURVES (1u << BATTEN_OBJECT_CURVE)
#define BAT_SURFACES (1u << BATTEN_OBJECT_SURFACE)
#define BAT_OFFSETS (1u << BATTEN_OBJECT_OFFSET_TABLE)
#define BAT_TRIANGLES (1u << BATTEN_OBJECT_TRIANGLES)
#define BAT_BODIES (1u << BATTEN_OBJECT_BODY)
#define BAT_MESHES (1u << BATTEN_OBJECT_MESH)
#define BAT_ALL                                                                          \
    (BAT_POINTS | BAT_CURVES | BAT_SURFACES | BAT_OFFSETS | BAT_TRIANGLES | BAT_BODIES | \
     BAT_MESHES)

/* Features double objects, and chains of them fill any memory: `count` objects that this one is about to make are
 * refused, with the number, when the design would then have made more than it may. */
batten_status bat_expect(const bat_run *run, long long count);
/* Put an object into the model of the feature, unless it is one too many. */
batten_status bat_add(bat_run *run, const batten_object *object);
/* Put a curve or surface into the model under the feature's name and give its reference back,
 * when the status so far is good; else hand the status on. A surface of another kind becomes
 * NURBS, within the design's tolerance, and the error is reported. */
batten_status bat_put_curve(bat_run *run, batten_status status, batten_curve *curve);
batten_status bat_put_surface(bat_run *run, batten_status status, batten_surface *surface);
/* The same as another object, with another shape; the data of a curve go when `keep_data` is
 * false. */
batten_status bat_put_curve_like(bat_run *run, batten_status status, batten_curve *curve,
                                 const batten_object *like, bool keep_data);
/* Several are numbered from 1 after the object's name. */
batten_status bat_put_curves_like(bat_run *run, const batten_object *object,
                                  const batten_curves *curves);
/* The same of a curve that is a chain, or NULL, in truth; both references are given back. */
batten_status bat_put_chain_like(bat_run *run, batten_status status, batten_curve *curve,
                                 batten_chain *chain, const batten_object *like);
/* A curve in the plane of a flat sheet, put into space with a name, a layer ("cut" ...) and a
 * colour [3], for cutting and bending. */
batten_status bat_put_flat(bat_run *run, batten_status status, batten_curve *curve,
                           const char *name, const char *layer, const double *colour);
batten_status bat_put_surface_like(bat_run *run, batten_status status, batten_surface *surface,
                                   const batten_object *like);

/* The same of Bezier triangles in space. */
batten_status bat_put_triangles(bat_run *run, batten_status status,
                                batten_triangles *triangles);

/* Change every curve and surface of the principal input; what is NULL is not changed. Objects
 * of other kinds pass through; at least one must be changed. */
typedef struct {
    batten_status (*curve)(const bat_run *run, const batten_curve *curve, batten_curve **out);
    batten_status (*surface)(const bat_run *run, const batten_surface *surface,
                             batten_surface **out);
    batten_status (*triangles)(const bat_run *run, const batten_triangles *triangles,
                               batten_triangles **out);
    /* Beside `curve`, of a chain; NULL: the curve is no longer a chain. */
    batten_status (*chain)(const bat_run *run, const batten_chain *chain, batten_chain **out);
    bool keeps_data; /* the points that a curve was made from still belong to it */
    /* Instead of these: nearly the same shape, and how far it is from the given one. */
    batten_status (*near_curve)(const bat_run *run, const batten_curve *curve, double *error,
                                batten_curve **out);
    batten_status (*near_surface)(const bat_run *run, const batten_surface *surface,
                                  double *error, batten_surface **out);
} bat_change;
batten_status bat_change_all(bat_run *run, const bat_change *change);

/* Map one object into the model, or every object of the principal input. */
batten_status bat_transform_object(bat_run *run, const batten_affine *map,
                                   const batten_object *object);
batten_status bat_transform_all(bat_run *run, const batten_affine *map);

/* An error of an approximation; the largest of several is shown. */
void bat_report_error(bat_run *run, double max, double rms);

/* ---- the list ---- */

/* A table of operations. */
typedef struct {
    int count;
    const bat_feature *const *at;
} bat_features;

/* The feature of this name, or NULL (text/names.c). */
const bat_feature *bat_features_find(const bat_features *features, const char *name);
/* All of them, in the order of the manual (features.c). */
extern const bat_features bat_all_features;

#endif
