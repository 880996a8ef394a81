#ifndef BATTEN_PICTURE_H
#define BATTEN_PICTURE_H
/**
 * @file
 * Pictures: drawings of curves, lines drawings of hulls, shaded surfaces. No display is needed.
 *
 * Every function hands over the bytes of a file; save them with batten_save_file.
 */
#include <batten/contours.h>
#include <batten/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum batten_picture_format {
    BATTEN_PICTURE_PNG,
    BATTEN_PICTURE_SVG,
    BATTEN_PICTURE_PDF,
    BATTEN_PICTURE_DXF /**< of lines plans only */
} batten_picture_format;

/**
 * By the ending of a file name.
 *
 * @param path  of the file, UTF-8
 * @param[out] format  which one
 * @return false when the ending names none of them
 */
BATTEN_API bool batten_picture_format_from_name(const char *path,
                                                batten_picture_format *format);

typedef enum batten_view {
    BATTEN_VIEW_AUTO,  /**< curves in a plane: that plane; else axonometric */
    BATTEN_VIEW_TOP,   /**< x to the right, y up */
    BATTEN_VIEW_FRONT, /**< y to the right, z up: along the ship */
    BATTEN_VIEW_SIDE,  /**< x to the right, z up */
    BATTEN_VIEW_AXONOMETRIC,
    BATTEN_VIEW_ISOMETRIC /**< azimuth 45, elevation 35.264 degrees: all axes alike */
} batten_view;

/** What becomes of lines behind surfaces. */
typedef enum batten_hidden {
    BATTEN_HIDDEN_SHOWN, /**< surfaces are glass */
    BATTEN_HIDDEN_DASHED,
    BATTEN_HIDDEN_DROPPED
} batten_hidden;

typedef enum batten_sheet {
    BATTEN_SHEET_ONE,         /**< one view */
    BATTEN_SHEET_THREE_VIEWS, /**< side, front and top at one scale, and an axonometric view */
    BATTEN_SHEET_STEREO_PARALLEL, /**< the left eye's picture is the left one */
    BATTEN_SHEET_STEREO_CROSSED   /**< the left eye's picture is the right one: squint */
} batten_sheet;

typedef enum batten_shading {
    BATTEN_SHADING_PLAIN,
    BATTEN_SHADING_ISOLINES, /**< plain, with isoparametric lines */
    BATTEN_SHADING_ZEBRA,
    BATTEN_SHADING_GAUSSIAN, /**< colours of the Gaussian curvature, with a legend */
    BATTEN_SHADING_MEAN,     /**< the same of the mean curvature */
    BATTEN_SHADING_ISOPHOTES /**< stripes of equal light from above left: `stripes` dark ones
                                from facing the light to facing away from it */
} batten_shading;

typedef struct batten_draw_options {
    size_t size;
    batten_picture_format format; /**< PNG; shaded pictures can be nothing else */
    int width, height; /**< pixels, or points of 1/72 inch, 64..16384; 1200 x 0. The height 0
                            follows the shape: from a quarter of the width to all of it. A lines
                            plan looks best on 1684 x 1191 (A2) or 1191 x 842 (A3) */
    const char *title; /**< "" */
    batten_view view;
    double azimuth, elevation; /**< of the eye, radians, from x towards y and up; for the
                                    axonometric view; 28 and 12 degrees: off the port bow */
    bool control_polygon;      /**< of curves */
    bool data_points;          /**< that curves were made from */
    bool comb;                 /**< curvature comb, plane curves and projections */
    double comb_scale; /**< 0: chosen so that the longest tooth is a tenth of the picture */
    batten_shading shading;
    int isolines;         /**< parts into which they divide each direction, 1..1000; 10 */
    double stripes;       /**< dark zebra stripes that a cylinder shows from edge to edge; 24.
                               They mirror tubes along the longest axis */
    batten_hidden hidden; /**< in line drawings of surfaces; SHOWN */
    bool silhouettes;     /**< where surfaces turn away from the eye */
    bool contours;        /**< lines along which `contour_field` has round values */
    batten_surface_field contour_field;
    double contour_spacing; /**< 0: chosen, about ten levels */
    batten_sheet sheet;     /**< in line drawings of surfaces; ONE */
    double distance;        /**< of the eye from the middle of what is drawn, model units, for
                                 perspective in line drawings; 0: parallel projection */
    double stereo_angle;    /**< between both eyes, radians; 5 degrees */
    batten_notes *notes;    /**< receives faces of bodies that cannot be drawn; NULL */
} batten_draw_options;
/** The defaults of drawings: those beside the fields of batten_draw_options. */
BATTEN_API batten_draw_options batten_draw_defaults(void);

/**
 * Draw points, offsets, curves, the isoparametric lines of surfaces, the edges of bodies and
 * those of meshes where they end or turn by more than 30 degrees as lines, both axes at one
 * scale. Instances are drawn where they are placed; hidden objects only when all are. Up to
 * eight objects are told apart by colours, more are named where they end.
 *
 * @param model  looked at only
 * @param options  NULL for the defaults
 * @param[out] data  release with batten_release
 * @param[out] size  of the data, bytes
 * @return BATTEN_OK, BAD_ARGUMENT (no objects, sizes), NOT_FINITE, TOO_LARGE, OVERFLOW,
 * OUT_OF_MEMORY
 *
 * Cost: linear in the model and in what is drawn; memory of a PNG 4 bytes for each pixel.
 */
BATTEN_API batten_status batten_draw(const batten_model *model,
                                     const batten_draw_options *options, char **data,
                                     size_t *size);

/**
 * Draw the way of a tool, as batten_gcode_tool_path makes it: what is cut solid, travel dashed,
 * going down dotted, with a disc and a number where the tool goes down, in this order, and the
 * length of each in the legend. It is seen from above unless a view is asked for.
 *
 * @param tool_path  curves on the layers "cut", "travel" and "plunge"; looked at only
 * @param options  NULL for the defaults
 * @param[out] data  release with batten_release
 * @param[out] size  of the data, bytes
 * @return as batten_draw; BAD_ARGUMENT when no curve is on the layer "cut"
 *
 * Cost: as batten_draw, and the length of each curve.
 */
BATTEN_API batten_status batten_draw_tool_path(const batten_model *tool_path,
                                               const batten_draw_options *options, char **data,
                                               size_t *size);

/**
 * A line drawing of surfaces: edges, creases, isoparametric lines, silhouettes and contours,
 * each where it can be seen; curves are drawn with them, points as crosses. Surfaces hide what
 * lies behind them, themselves and each other. Edges in which two surfaces meet are drawn once.
 *
 * Lines are within a quarter of a pixel. Each is cut exactly where a triangle of the surfaces
 * begins or ends to cover it; the triangles are within a twentieth of a pixel of the surfaces,
 * and lines less than 3 pixels behind a curved one count as lying on it.
 *
 * @param model  looked at only
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] data  release with batten_release
 * @param[out] size  of the data, bytes
 * @return BATTEN_OK, BAD_ARGUMENT (no surface in space, sizes, an eye inside), NOT_FINITE,
 * TOO_LARGE, OVERFLOW, CANCELLED, INCOMPLETE, OUT_OF_MEMORY
 *
 * Cost: linear in triangles and in what is drawn.
 * Source: [Appel67] for the silhouette and edges that change visibility.
 */
BATTEN_API batten_status batten_draw_surface_lines(const batten_model *model,
                                                   const batten_draw_options *options,
                                                   const batten_job *job, char **data,
                                                   size_t *size);

/** One of several drawings side by side. */
typedef struct batten_panel {
    const char *title;         /**< above it */
    const batten_model *model; /**< what it shows */
    int line_count;
    const char *const *lines; /**< [line_count] texts below it */
} batten_panel;

/**
 * Draw models side by side, all from the same side, at the same scale and with the same scale
 * of their combs: so that curves through the same points can be compared. The range is that of
 * the first panel's data points and what all models show around them, up to half their extent
 * farther; what lies beyond is cut off.
 *
 * @param count panels, 1..64; rows and columns follow the shape of the sheet
 * @param panels  [count], each with its title and model
 * @param options  NULL for the defaults
 * @param[out] data  release with batten_release
 * @param[out] size  of the data, bytes
 * @return as batten_draw
 *
 * Cost: as batten_draw for all models.
 */
BATTEN_API batten_status batten_draw_panels(int count, const batten_panel *panels,
                                            const batten_draw_options *options, char **data,
                                            size_t *size);

typedef struct batten_draw_lines_plan_options {
    size_t size;
    double stations;          /**< spacing; 0: eleven over the length */
    double waterlines;        /**< spacing; 0: chosen */
    double buttocks;          /**< spacing; 0: chosen */
    const double *station_at; /**< [station_count] instead of the spacing; or NULL */
    int station_count;
    double design_waterline;  /**< height; NaN for none */
    const batten_model *data; /**< given points, drawn as crosses; or NULL */
    int diagonals; /**< how many are chosen; -1: three, but none on a hull with knuckles */
    const double *diagonal_at; /**< [diagonal_count] heights at which diagonals leave the centre
                                    plane, instead; or NULL */
    const double *diagonal_angle; /**< [diagonal_count] how far they fall below the level,
                                       radians, above 0 and below pi / 2 */
    int diagonal_count;
} batten_draw_lines_plan_options;
/** The defaults of lines plans: those beside the fields of batten_draw_lines_plan_options. */
BATTEN_API batten_draw_lines_plan_options batten_draw_lines_plan_defaults(void);

/**
 * A lines drawing of a half hull (x along, y >= 0 to the side, z up): profile, half-breadth
 * plan below it, and body plan, at one usual scale (1:20, 1:25, 1:30 ...), true in PDF and SVG,
 * with grid, title block, legend and the table of offsets measured on the drawn lines. The scale is
 * the largest usual one at which the views find room, whichever way they stand.
 *
 * As DXF (release 12) it has its lines at full size, one unit of the model each, with the profile at its place in (x, z);
 * layers: stations, buttocks, waterlines, diagonals, edges, points, grid, text, table, sheet. Lines are within
 * 1/40,000 of their size, as those of all pictures.
 *
 * Diagonals are straight in the body plan and stand below the centre line of the half-breadth plan
 * in their true shape. Those that are chosen cross the section amidships squarely, at equal angles about
 * its middle at the height of the sheer. Edges between surfaces at which a section turns by 10 degrees or more
 * are knuckles: the table has their heights and half-breadths.
 *
 * The bow is at the larger x, to the right; stations are numbered from 0 at the smallest x. Of
 * a whole hull the half with y >= 0 is drawn; a half at y <= 0 is mirrored. Notes say what
 * could not be drawn.
 *
 * @param model  looked at only
 * @param plan  NULL for the defaults
 * @param options  NULL for the defaults
 * @param notes  may be NULL
 * @param[out] data  release with batten_release
 * @param[out] size  of the data, bytes
 * @return BATTEN_OK, BAD_ARGUMENT (no hull, no room on the sheet, the angle of a diagonal), NOT_FINITE, NOT_INCREASING,
 * TOO_LARGE (more than 400 lines of a family), OVERFLOW, OUT_OF_MEMORY, or what the sections
 * report
 *
 * Cost: one section of each surface for each line, some 100 x 100 cells; then linear in what is
 * drawn.
 */
BATTEN_API batten_status batten_draw_lines_plan(const batten_model *model,
                                                const batten_draw_lines_plan_options *plan,
                                                const batten_draw_options *options,
                                                batten_notes *notes, char **data, size_t *size);

/**
 * Shade all surfaces of a model, seen in parallel projection; curves are drawn over them, and
 * points as dots, where nothing is before them. PNG.
 *
 * The colours of curvature end where 95 of 100 samples lie inside; the legend has the
 * true extremes.
 *
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] data  release with batten_release
 * @param[out] size  of the data, bytes
 * @return BATTEN_OK, BAD_ARGUMENT (no surface, sizes), UNSUPPORTED (SVG, PDF), NOT_FINITE,
 * TOO_LARGE, OVERFLOW, CANCELLED, OUT_OF_MEMORY
 *
 * Cost: about 1/3 s for 1200 x 800. Nine samples for each pixel.
 */
BATTEN_API batten_status batten_draw_shaded(const batten_model *model,
                                            const batten_draw_options *options,
                                            const batten_job *job, char **data, size_t *size);

typedef struct batten_draw_cubic_plane_options {
    size_t size;
    double low, high; /**< what is shown of both axes; -2 and 3.6 */
    double tolerance; /**< relative, for batten_curve_classify; 1e-9 */
    bool glyphs;      /**< small curves that show what lies in each region; true */
} batten_draw_cubic_plane_options;
/** The defaults of pictures of the plane of cubics: those beside the fields of
 * batten_draw_cubic_plane_options. */
BATTEN_API batten_draw_cubic_plane_options batten_draw_cubic_plane_defaults(void);

/**
 * Draw the plane of (lambda, mu), the lengths of the end tangents of a cubic in units of the
 * way to the point T where they meet: its regions, shaded and named, and their boundaries; and
 * a mark, with its number, for each span of the curves of a model.
 *
 * Spans without such a point (straight, twisted, with parallel end tangents) and those outside
 * the picture are counted in the legend.
 *
 * @param model NULL for the plane alone; curves must be polynomial of degree 3 at most
 * @param plane NULL for the defaults
 * @param options  NULL for the defaults
 * @param[out] data  release with batten_release
 * @param[out] size  of the data, bytes
 * @return BATTEN_OK, BAD_ARGUMENT (low >= high, sizes), UNSUPPORTED (other curves), NOT_FINITE,
 * TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: constant for the plane, one look-up for each pixel of a coarse grid; linear in the
 * spans.
 * Source: [SL] III.3, [Liu81].
 */
BATTEN_API batten_status batten_draw_cubic_plane(const batten_model *model,
                                                 const batten_draw_cubic_plane_options *plane,
                                                 const batten_draw_options *options,
                                                 char **data, size_t *size);

#ifdef __cplusplus
}
#endif
#endif
