#ifndef BATTEN_EXCHANGE_H
#define BATTEN_EXCHANGE_H
/**
 * @file
 * Files: reading them into a model, writing a model.
 */
#include <batten/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum batten_format {
    BATTEN_FORMAT_AUTO, /**< by content when reading, by the name's ending when writing */
    BATTEN_FORMAT_OFFSET_TABLE, /**< a table of offsets: .csv, .tsv, .txt */
    BATTEN_FORMAT_POINTS,       /**< x y z in lines: .xyz; .csv, .tsv, .txt without offsets */
    BATTEN_FORMAT_AEROFOIL,     /**< .dat, Selig or Lednicer order */
    BATTEN_FORMAT_IGES,         /**< .igs, .iges */
    BATTEN_FORMAT_STEP,         /**< .stp, .step; AP203, AP214, AP242 */
    BATTEN_FORMAT_DXF,   /**< .dxf; written as release 2000: points, curves, arcs as bulges */
    BATTEN_FORMAT_SVG,   /**< .svg at true scale, for cutting; written: curves seen along z */
    BATTEN_FORMAT_GCODE, /**< .nc, .ngc, .gcode, .tap; written: see gcode.h */
    BATTEN_FORMAT_G2,    /**< .g2, GoTools */
    BATTEN_FORMAT_OBJ,   /**< .obj, meshes and free-form curves and surfaces */
    BATTEN_FORMAT_STL,   /**< .stl, both forms */
    BATTEN_FORMAT_PLY,   /**< .ply, all three forms; meshes and point clouds */
    BATTEN_FORMAT_GLTF,  /**< .glb, glTF 2.0; written */
    BATTEN_FORMAT_3MF,   /**< .3mf; written */
    BATTEN_FORMAT_PCD,   /**< .pcd, point clouds; read */
    BATTEN_FORMAT_FTM,   /**< .ftm, the control net of FREE!ship; read */
    BATTEN_FORMAT_OFF    /**< .off, meshes; read */
} batten_format;

/**
 * The short name of a format, as designs write it: "iges", "step" ...
 *
 * @param format  any but BATTEN_FORMAT_AUTO
 */
BATTEN_API const char *batten_format_name(batten_format format);
typedef struct batten_format_facts {
    batten_format format;
    const char *name;       /**< as designs write it: "step" */
    const char *title;      /**< "STEP" */
    const char *endings[4]; /**< of file names; NULL beyond the last */
    bool is_read, is_written;
} batten_format_facts;
/**
 * What is known about a format; false when there is no such format.
 *
 * @param format  which one
 * @param[out] out  names, endings, and whether it is read and written
 */
BATTEN_API bool batten_format_about(batten_format format, batten_format_facts *out);
/**
 * The format of a file by the ending of its name; BATTEN_FORMAT_AUTO when it says nothing.
 *
 * @param path  of the file, UTF-8
 */
BATTEN_API batten_format batten_format_from_name(const char *path);

/** What a reader may use; over a limit: BATTEN_TOO_LARGE, naming it. */
typedef struct batten_limits {
    size_t size;
    size_t file_bytes;   /**< 1 GiB */
    size_t memory_bytes; /**< 0: 16 MiB + 40 times the file */
    size_t entities;     /**< 10 M */
    int nesting;         /**< 64 */
    size_t string_bytes; /**< 1 MiB */
    size_t line_bytes;   /**< 64 KiB */
    size_t points;       /**< points per object, 10 M */
    int notes;           /**< 1,000 */
} batten_limits;
/** The limits that readers keep: those beside the fields of batten_limits. */
BATTEN_API batten_limits batten_limits_defaults(void);

typedef struct batten_read_options {
    size_t size;
    batten_format format;        /**< BATTEN_FORMAT_AUTO */
    const batten_limits *limits; /**< NULL for the defaults */
    const char *file_name;       /**< for messages; "" */
} batten_read_options;
/** The defaults of readers: those beside the fields of batten_read_options. */
BATTEN_API batten_read_options batten_read_defaults(void);

/**
 * Read bytes into a model.
 *
 * @param[out] data  the bytes, `size` of them
 * @param[out] size  bytes
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param notes  receives what was odd; may be NULL
 * @return BATTEN_OK; BATTEN_PARTLY_READ, with a model, when entities were left out (each has a
 * note); without one BAD_FORMAT, UNSUPPORTED, TOO_LARGE, OVERFLOW, CANCELLED, INCOMPLETE, OUT_OF_MEMORY
 *
 * Cost: linear in the bytes; memory within the limits of the options, some ten times the file
 * for STEP.
 */
BATTEN_API batten_status batten_read_memory(const char *data, size_t size,
                                            const batten_read_options *options,
                                            const batten_job *job, batten_notes *notes,
                                            batten_model **out);
/**
 * The same from a file.
 *
 * @param path  of the file, UTF-8
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param notes  receives what was odd; may be NULL
 * @param[out] out  the model; as it was when the function fails
 * @return as batten_read_memory; FILE_ERROR when it cannot be read
 *
 * Cost: as batten_read_memory, with the file in memory.
 */
BATTEN_API batten_status batten_read_file(const char *path, const batten_read_options *options,
                                          const batten_job *job, batten_notes *notes,
                                          batten_model **out);

typedef enum batten_step_schema {
    BATTEN_STEP_AP214, /**< AUTOMOTIVE_DESIGN: read everywhere */
    BATTEN_STEP_AP203, /**< CONFIG_CONTROL_DESIGN: has no colours */
    BATTEN_STEP_AP242
} batten_step_schema;

typedef struct batten_write_options {
    size_t size;
    batten_format format; /**< by the name's ending */
    const char *name;     /**< of the product; that of the model, "batten" when it has none */
    double tolerance; /**< for shapes that the format cannot say exactly, and as the file's own
                           accuracy; model units; 0: 1e-6 of a metre */
    const char *date; /**< "2026-11-21T10:25:00", as the file is to say it; NULL for the same
                           neutral date always, so that equal models give equal bytes */
    batten_step_schema schema;
    bool no_parameter_curves; /**< STEP: faces without curves in (u, v) */
    bool solids;  /**< IGES: bodies as solids and shells that share their edges (186,
                       514), which fewer programs read than trimmed faces (144) */
    bool as_text; /**< STL and PLY: the readable form */
    const batten_mesh_options
        *mesh;    /**< for the formats of meshes: how shapes become triangles;
                                          NULL for the defaults */
    bool eighths; /**< tables of offsets in feet, inches and eighths, "1-7-4" */
    bool commas;  /**< points: commas between the coordinates, not blanks */
} batten_write_options;
/** The defaults of writers: those beside the fields of batten_write_options. */
BATTEN_API batten_write_options batten_write_defaults(void);

/**
 * What the name of a file says: its format, when the options name none (that of points for a
 * model without tables in .csv, .tsv or .txt), and commas in .csv.
 *
 * @param path  of the file, UTF-8
 * @param model  what will be written
 * @param[out] options  changed where they name no format
 * @return false when the ending names no format, and nothing else does
 */
BATTEN_API bool batten_write_choose(const char *path, const batten_model *model,
                                    batten_write_options *options);

/**
 * The model as it comes into a file of that format: instances placed, triangles as patches,
 * shapes as meshes where the format has no others, and without the objects that it does not
 * hold; the writers of tables, points and G-code choose themselves.
 * @param model  looked at only
 * @param options  NULL for the defaults
 * @param notes what was approximated or left out; may be NULL
 * @return BATTEN_OK; UNSUPPORTED when nothing of the model would be in the file, or the format
 * is not written; as batten_mesh_from_body
 *
 * Cost: linear in the objects; where meshes are made, that of batten_mesh_from_body.
 */
BATTEN_API batten_status batten_write_prepare(const batten_model *model,
                                              const batten_write_options *options,
                                              batten_notes *notes, batten_model **out);
/**
 * Write a model as the bytes of a file.
 *
 * @param model  looked at only
 * @param options  NULL for the defaults
 * @param notes what was approximated or left out; may be NULL
 * @param[out] data, size  the bytes; release with batten_release
 * @return BATTEN_OK; BAD_ARGUMENT (options), UNSUPPORTED when nothing of the model would be in
 * the file, or the format is not written; TOO_LARGE, OUT_OF_MEMORY; as batten_mesh_from_body
 * where meshes are made
 *
 * Cost: linear in the model; that of batten_write_prepare before.
 */
BATTEN_API batten_status batten_write_memory(const batten_model *model,
                                             const batten_write_options *options,
                                             batten_notes *notes, char **data, size_t *size);
/**
 * Write to a file by batten_save_file.
 *
 * @param model  looked at only
 * @param path  of the file, UTF-8; its ending chooses the format unless the options do
 * @param options  NULL for the defaults
 * @param notes  what was approximated or left out; may be NULL
 * @return as batten_write_memory; UNSUPPORTED for an ending that names no format; FILE_ERROR
 *
 * Cost: as batten_write_memory, with the bytes in memory.
 */
BATTEN_API batten_status batten_write_file(const batten_model *model, const char *path,
                                           const batten_write_options *options,
                                           batten_notes *notes);
typedef struct batten_write_gcode_options {
    size_t size;
    bool absolute_centres; /**< I and J are the centre itself (G90.1); false: from the start of
                                the arc (G91.1), as most controls expect */
    bool relative_moves; /**< every X, Y, Z counts from where the tool is (G91); false (G90) */
    double feed;         /**< along the path, units a minute; 0: 1000 mm a minute */
    double plunge;       /**< downwards, units a minute; 0: a quarter of the feed */
    double depth;        /**< height Z at which is cut; NaN: that of each path */
    double clearance;    /**< how far above the highest path the tool travels; 0: 5 mm */
    int decimals;        /**< 0..9; -1: 4 for millimetres, 5 for inches */
    double greatest_radius; /**< of an arc, which the control takes; infinity: any; 0: 10 m */
} batten_write_gcode_options;
/** The defaults of G-code: those beside the fields of batten_write_gcode_options. */
BATTEN_API batten_write_gcode_options batten_write_gcode_defaults(void);

/**
 * The program that follows the paths of a model in their order: G0 above, G1 down, then G1, G2
 * and G3.
 *
 * Paths are chains of arcs and lines, polylines, and NURBS curves that are arcs and lines
 * exactly (batten_arcs_from_curve_exact), each in a plane z = constant; other curves are left
 * out with a note (make arcs of them first). Inches (G20) when the unit of the model is the
 * inch, else millimetres (G21), into which other units are converted. Coordinates are rounded
 * to `decimals`; centres are computed from the rounded ends, so that both ends of an arc lie on
 * its circle within the last place. An arc sweeps at most a half circle. One that is less than
 * half the last place beside its chord is a line; one of a larger radius than the control takes
 * is lines that are no more than the last place beside it, with a note. Relative moves begin at
 * the machine's origin.
 *
 * @param model  looked at only
 * @param options  NULL for the defaults
 * @param notes  what was left out; may be NULL
 * @param[out] data, size  the text and its length in bytes; release with batten_release
 * @return BATTEN_OK, BAD_ARGUMENT (options), UNSUPPORTED when the model has no path, TOO_LARGE
 * (a million lines for one arc), OVERFLOW (coordinates of 1e9 and more), OUT_OF_MEMORY
 *
 * Cost: linear in the paths; each NURBS curve as batten_arcs_from_curve_exact.
 * Source: ISO 6983-1 for the words.
 */
BATTEN_API batten_status batten_write_gcode(const batten_model *model,
                                            const batten_write_gcode_options *options,
                                            batten_notes *notes, char **data, size_t *size);

/**
 * The way of the tool of the program that batten_write_gcode writes with the same options, in the
 * program's unit and with its rounded coordinates, in order: curves on the layers "cut" (G1, G2,
 * G3), "plunge" (down to the path) and "travel" (G0, above the paths), each named by its path, travel by
 * the path it leads to.
 * The way from where the tool stands at first is known with relative moves only, from the
 * machine's origin; with absolute moves it is left out.
 *
 * @param model  looked at only
 * @param options  NULL for the defaults
 * @param notes  what was left out; may be NULL
 * @param[out] out  give the reference back with batten_model_unref
 * @return as batten_write_gcode
 *
 * Cost: that of batten_write_gcode, and linear in the moves.
 */
BATTEN_API batten_status batten_gcode_tool_path(const batten_model *model,
                                                const batten_write_gcode_options *options,
                                                batten_notes *notes, batten_model **out);

#ifdef __cplusplus
}
#endif
#endif
