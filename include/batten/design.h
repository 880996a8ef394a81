#ifndef BATTEN_DESIGN_H
#define BATTEN_DESIGN_H
/**
 * @file
 * The design document: a graph of named features in a text file.
 *
 * A design is parsed, evaluated as far as one asks, edited value by value, and its outputs are
 * made:
 *
 *     batten_design_open("hull.yaml", false, notes, &design);
 *     batten_design_set(design, "parameters.beam", "3.4 m", notes);
 *     batten_design_evaluate(design, NULL, NULL, notes);
 *     batten_design_output(design, 0, NULL, notes, &data, &size);
 *
 * Notes carry the file, the line, as entity the column ("column 14") for errors of the text or
 * the feature for what happened in it, and a sentence. The message of a failure begins
 * "file:line:column: ". A design is strict: any error of its text refuses the whole. One design
 * belongs to one thread at a time; the models that it hands out may be shared.
 */
#include <batten/exchange.h>
#include <batten/fair.h>
#include <batten/skin.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- the table of features ---- */

/**
 * What a value may be. Lengths, angles, numbers and counts may also be expressions, "=beam/2 +
 * 0.1 m", over the parameters of the design, with + - * / ^ ( ) and sin cos tan sqrt abs min
 * max pi. A length without a unit is in the unit of the design; an angle needs deg or rad
 * unless it is 0.
 */
typedef enum batten_value_kind {
    BATTEN_VALUE_MODEL,  /**< the result of another feature, by name */
    BATTEN_VALUE_LENGTH, /**< a number with a unit of length */
    BATTEN_VALUE_ANGLE,  /**< a number with deg or rad */
    BATTEN_VALUE_NUMBER,
    BATTEN_VALUE_COUNT, /**< a whole number */
    BATTEN_VALUE_WORD,  /**< one of `words` */
    BATTEN_VALUE_TEXT,
    BATTEN_VALUE_FILE, /**< a path below the folder of the design */
    BATTEN_VALUE_YES_NO,
    BATTEN_VALUE_POINT, /**< [x, y, z] or [x, y], lengths; or origin x y z -x -y -z */
    BATTEN_VALUE_RANGE, /**< [a, b], lengths, a < b */
    BATTEN_VALUE_POINTS, /**< a point, or the name of a feature with points */
    BATTEN_VALUE_MOVE    /**< [i, j, k, dx, dy, dz]: a place in a lattice, from 1, and a vector */
} batten_value_kind;

typedef struct batten_parameter {
    const char *name;
    batten_value_kind kind;
    bool is_list; /**< one or many of the kind */
    bool required;
    const char *standard; /**< the default, as one would write it; NULL for none */
    const char *words;    /**< "natural clamped ..." for BATTEN_VALUE_WORD */
    const char *summary;  /**< one line */
} batten_parameter;

typedef struct batten_feature {
    const char *name;    /**< the operation: "skin" */
    const char *summary; /**< one line */
    const char *manual;  /**< paragraphs of plain text */
    const char *example; /**< sections of a design file, without the line "batten: 1"; it works.
                              Files that it reads: a table of offsets "offsets.csv" */
    const char
        *source; /**< keys of the bibliography with places: "[SL section VI.3], [LF73]" */
    const char *function; /**< the C function */
    int parameter_count;
    const batten_parameter *parameters; /**< the first is the principal input; it has the
                                             name of the operation: {skin: frames} */
    bool is_output;                     /**< stands under outputs: makes a file, not a value */
    const char
        *also; /**< its other names, of books, authors and programs, with commas; or NULL */
    const char *
        formula; /**< lines of plain Unicode that define it, letters as in the source; or NULL */
    const char
        *promise; /**< what it minimises or guarantees, a sentence; NULL where formula is */
} batten_feature;

/** Features first, then outputs, in the order of the manual. */
BATTEN_API int batten_feature_count(void);
/** The feature of this index, 0 .. batten_feature_count() - 1. */
BATTEN_API const batten_feature *batten_feature_at(int index);
/**
 * The title under which the manual shows it: "Curves through points".
 *
 * @param index  from 0
 */
BATTEN_API const char *batten_feature_group(int index);
/** NULL when there is none of that name. */
BATTEN_API const batten_feature *batten_feature_find(const char *name);
/** The known name nearest to a misspelt one, or NULL. */
BATTEN_API const char *batten_feature_nearest(const char *name);
/**
 * The JSON Schema of design files, made from the table; release with batten_release.
 *
 * @param[out] json  release with batten_release
 * @return BATTEN_OK or OUT_OF_MEMORY
 *
 * Cost: linear in the table of features.
 */
BATTEN_API batten_status batten_design_schema(char **json);

/* ---- the literature ---- */

/** A book or an article on which methods stand. */
typedef struct batten_source {
    const char *key;      /**< as in batten_feature.source, without brackets: "Akima70" */
    const char *citation; /**< author, title, place and year, spelt out */
} batten_source;
/** NULL when nothing has that key. */
BATTEN_API const batten_source *batten_source_find(const char *key);

/** A place in a source whose places are all listed: which features stand on it can be asked. */
typedef struct batten_source_place {
    const char *key;     /**< of the source */
    const char *place;   /**< "section VI.3", "paper 10", "formula 12.7.14" */
    const char *subject; /**< what stands there */
    const char *without; /**< why no feature stands on it, or what does instead; or NULL */
} batten_source_place;
/** All places, source after source, in the order of their pages. */
BATTEN_API int batten_source_place_count(void);
/** The place of this index, 0 .. batten_source_place_count() - 1. */
BATTEN_API const batten_source_place *batten_source_place_at(int index);
/** Does the feature name this place, or a range of formulas around it, among its sources? */
BATTEN_API bool batten_feature_has_place(const batten_feature *feature,
                                         const batten_source_place *place);

/* ---- the document ---- */

typedef struct batten_design batten_design;

typedef struct batten_design_options {
    size_t size;
    const char *file_name; /**< for messages, and the folder to which paths are relative */
    bool allow_outside;    /**< paths may leave that folder */
    const batten_limits *limits;
    const char *provided_file; /**< a feature that reads this path, as it is written there, */
    const batten_model *provided; /**< takes this model instead of the file; NULL for none */
} batten_design_options;
/** The defaults of design files: those beside the fields of batten_design_options. */
BATTEN_API batten_design_options batten_design_defaults(void);

/**
 * Parse a design; every error of the text goes to `notes` with line, column and nearest name.
 *
 * @param text     UTF-8, `length` bytes; it is copied
 * @param length  bytes of text
 * @param options  NULL for the defaults
 * @param notes  gets every error; may be NULL, here and below
 * @param[out] out  release with batten_design_free
 * @return BATTEN_OK; BAD_FORMAT when there was an error, TOO_LARGE over a limit: the message is
 * the first one; BAD_ARGUMENT (options); OUT_OF_MEMORY
 *
 * Cost: linear in the text; a wrong name is compared with all names that are possible there.
 */
BATTEN_API batten_status batten_design_parse(const char *text, size_t length,
                                             const batten_design_options *options,
                                             batten_notes *notes, batten_design **out);
/**
 * The same from a file, whose folder is that of the design.
 *
 * @param path  of the file, UTF-8
 * @param allow_outside  whether it may read files outside its folder
 * @param notes  gets every error; may be NULL
 * @param[out] out  release with batten_design_free
 * @return as batten_design_parse; FILE_ERROR when it cannot be read
 *
 * Cost: as batten_design_parse.
 */
BATTEN_API batten_status batten_design_open(const char *path, bool allow_outside,
                                            batten_notes *notes, batten_design **out);
/**
 * NULL is welcome.
 *
 * @param design  NULL is welcome
 */
BATTEN_API void batten_design_free(batten_design *design);
/**
 * The text as it stands: loaded and saved it is the same bytes. It ends with a zero byte;
 * `length` may be NULL. Valid until the next edit.
 *
 * @param design  any design
 */
BATTEN_API const char *batten_design_text(const batten_design *design, size_t *length);
/** The parameters of the design, in the order of its text. */
BATTEN_API int batten_design_parameter_count(const batten_design *design);
/**
 * The name of a parameter, borrowed from the design.
 *
 * @param index  from 0
 */
BATTEN_API const char *batten_design_parameter_name(const batten_design *design, int index);
/**
 * The files that its features read, in the order of its text; one as often as it is named.
 *
 * @param design  any design
 */
BATTEN_API int batten_design_file_count(const batten_design *design);
/**
 * The path of such a file as it is opened, beside the design; release with batten_release.
 *
 * @param design  any design
 * @param index  from 0, below batten_design_file_count
 * @param[out] path  release with batten_release
 * @return BATTEN_OK; BAD_ARGUMENT when it leaves the folder of the design, FILE_ERROR when it
 * is not there: then it is not read; OUT_OF_MEMORY
 *
 * Cost: linear in the entries of the design, and one look at the file system.
 */
BATTEN_API batten_status batten_design_file_path(const batten_design *design, int index,
                                                 char **path);
/** How many metres one unit of the design is: the unit of all its results. */
BATTEN_API double batten_design_unit_metres(const batten_design *design);
/**
 * Change one value; only the bytes of that value change (a new key is appended to its feature).
 * A value in several lines cannot be changed as a whole; a new key needs a map that is there.
 * Results that the edit does not reach are kept; pointers to other results, and to names, end.
 *
 * @param design  any design
 * @param path  "parameters.beam", "features.hull.degree", "features.hull.skin", "units"
 * @param value as one would write it: "3.4 m", "[1, 2, 3]"; quotes are added where YAML needs
 * them
 * @param notes  gets every error; may be NULL
 * @return BATTEN_OK; NOT_FOUND when there is no such place, UNSUPPORTED for a value in several
 * lines, else as batten_design_parse for the new text. On failure the design is as before
 *
 * Cost: that of batten_design_parse for the new text; results that the edit does not reach are
 * not computed again.
 */
BATTEN_API batten_status batten_design_set(batten_design *design, const char *path,
                                           const char *value, batten_notes *notes);

/* ---- its results ---- */

/** What became of one feature. Valid until the next edit or the next evaluation of this
 * feature. */
typedef struct batten_feature_result {
    const char *name;
    const char *operation;
    const batten_model *value; /**< NULL when it failed */
    batten_status status;
    double seconds;
    bool has_error;
    double error_max, error_rms; /**< of an approximation, in design units */
    bool has_moves;
    double move_max; /**< of fairing */
    int moved_count;
    const batten_fair_report *fairing;      /**< or NULL */
    const batten_surface_skin_report *skin; /**< or NULL */
    const batten_loft_report *loft;         /**< or NULL */
} batten_feature_result;

/**
 * Evaluate the named feature (NULL: all) and what it needs; results are kept and used again
 * until an edit reaches them. A feature that fails stops those that need it; the others are
 * evaluated all the same.
 *
 * @param design  any design
 * @param feature  its name; NULL: all
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param notes  gets what failed and what was left out; may be NULL
 * @return the first failure, its message beginning with file, line, column and feature;
 * BATTEN_PARTLY_READ when nothing failed but a file was read in part (its notes say what was
 * left out); BATTEN_NOT_FOUND when there is no such feature; BATTEN_CANCELLED,
 * BATTEN_OUT_OF_MEMORY at once
 *
 * Cost: that of the functions behind the features that are not known yet; comparing what
 * changed is linear in the design.
 */
BATTEN_API batten_status batten_design_evaluate(batten_design *design, const char *feature,
                                                const batten_job *job, batten_notes *notes);
/**
 * How many features were evaluated since the last edit that reached them, also those that
 * failed.
 *
 * @param design  any design
 */
BATTEN_API int batten_design_result_count(const batten_design *design);
/**
 * In the order of evaluation.
 *
 * @param design  any design
 * @param index  from 0
 */
BATTEN_API const batten_feature_result *batten_design_result_at(const batten_design *design,
                                                                int index);
/**
 * The result of one feature, or NULL when it was not evaluated.
 *
 * @param design  any design
 */
BATTEN_API const batten_feature_result *batten_design_result(const batten_design *design,
                                                             const char *feature);

/** How many outputs the design writes. */
BATTEN_API int batten_design_output_count(const batten_design *design);
/**
 * The file name of an output as written in the design.
 *
 * @param index  from 0
 */
BATTEN_API const char *batten_design_output_name(const batten_design *design, int index);
/**
 * The operation that makes it: "check", "picture", "lines-plan"; "write" for a bare file.
 *
 * @param design  any design
 * @param index  from 0
 */
BATTEN_API const char *batten_design_output_operation(const batten_design *design, int index);
/**
 * False when the output was made and its report says that a bound is not met.
 *
 * @param design  any design
 * @param index  from 0
 */
BATTEN_API bool batten_design_output_holds(const batten_design *design, int index);
/**
 * False when the output was made, and says less than there is: faces are not measured.
 *
 * @param design  any design
 * @param index  from 0
 */
BATTEN_API bool batten_design_output_is_whole(const batten_design *design, int index);
/**
 * Whether the file of an output stays in the folder it is made in when links are followed. Ask
 * just before saving; designs opened with allow_outside may go anywhere.
 *
 * @param design  any design
 * @param folder  that of the outputs; "" is the current one
 * @param path  where the output is to be saved: the folder and the output's name
 * @return BATTEN_OK, also where the folder is missing, which saving reports; BAD_ARGUMENT for a
 * path that leads out of the folder; FILE_ERROR for a link that leads nowhere; OUT_OF_MEMORY
 *
 * Cost: a few questions to the system.
 */
BATTEN_API batten_status batten_design_check_path(const batten_design *design,
                                                  const char *folder, const char *path);
/**
 * Make one output: the bytes of its file; what it needs is evaluated first, but for what
 * failed since the last edit: that is said, and batten_design_evaluate tries it again. Nothing
 * is written: save the bytes with batten_save_file, and release them with batten_release.
 *
 * @param design  any design
 * @param index  of the output, from 0
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param notes  receives what was odd or left out; may be NULL
 * @param[out] data  release with batten_release
 * @param[out] size  bytes
 * @return BATTEN_OK; PARTLY_READ with the bytes, as batten_design_evaluate; the first failure
 * otherwise, with file, line and column; CANCELLED, OUT_OF_MEMORY
 *
 * Cost: as batten_design_evaluate for what it needs, and linear in the bytes.
 */
BATTEN_API batten_status batten_design_output(batten_design *design, int index,
                                              const batten_job *job, batten_notes *notes,
                                              char **data, size_t *size);

#ifdef __cplusplus
}
#endif
#endif
