#ifndef BATTEN_GCODE_H
#define BATTEN_GCODE_H
/**
 * @file
 * G-code: paths of lines and arcs for a machine that cuts in the xy-plane.
 */
#include <batten/model.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_gcode_options {
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
} batten_gcode_options;
BATTEN_API batten_gcode_options batten_gcode_defaults(void);

/**
 * The program that follows the paths of a model in their order: G0 above, G1 down, then G1, G2
 * and G3.
 *
 * Paths are chains of arcs and lines, polylines, and NURBS curves that are arcs and lines
 * exactly (batten_arcs_exact), each in a plane z = constant; other curves are left out with a
 * note (make arcs of them first). Inches (G20) when the unit of the model
 * is the inch, else millimetres (G21), into which other units are converted. Coordinates are
 * rounded to `decimals`; centres are computed from the rounded ends, so that both ends of an
 * arc lie on its circle within the last place. An arc sweeps at most a half circle. One
 * that is less than half the last place beside its chord is a line; one of a larger radius
 * than the control takes is lines that are no more than the last place beside it, with a note.
 * Relative moves begin at the machine's origin.
 *
 * @param notes may be NULL
 * @param[out] data, size the text; release with batten_release
 * @return BATTEN_OK, BAD_ARGUMENT (options), UNSUPPORTED when the model has no path, TOO_LARGE
 * (a million lines for one arc), OVERFLOW (coordinates of 1e9 and more), OUT_OF_MEMORY
 * Source: ISO 6983-1 for the words.
 */
BATTEN_API batten_status batten_write_gcode(const batten_model *model,
                                            const batten_gcode_options *options,
                                            batten_notes *notes, char **data, size_t *size);

#ifdef __cplusplus
}
#endif
#endif
