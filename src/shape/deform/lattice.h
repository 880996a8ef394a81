/* A map of space by a lattice of control points, as it is stored. */
#ifndef BAT_DEFORM_LATTICE_H
#define BAT_DEFORM_LATTICE_H
#include "numeric/jet.h"
#include "spline/surface/axis.h"

#include <batten/offset.h>

enum { BAT_LATTICE_MOST_DEGREE = 8 }; /* the determinant is of degree 3 p - 1, at most 25 */

struct batten_deformation {
    bat_references references;
    batten_lattice lattice;
    double low[3], extent[3]; /* of the box */
    bat_axis axes[3];         /* over [0, 1] */
    double *moves;            /* [counts][3] from home; 0 exactly where a point stays */
    batten_box_join join;
    double size; /* a coordinate as large as any of the box and of the lattice */
    batten_deformation_report report;
};

/* Where a lattice point is in `moves`. */
static inline size_t bat_lattice_index(const batten_lattice *l, int i, int j, int k)
{
    return ((size_t)i * (size_t)l->counts[1] + (size_t)j) * (size_t)l->counts[2] + (size_t)k;
}

/* Whether the map folds: fills its report but for `moved` (folds.c). */
batten_status bat_deformation_find_folds(batten_deformation *deformation, int most_parts);

/* A map that folds, and shapes that leave the box as they may not, are refused. `what` they are: "the curve". */
batten_status bat_deformation_check(const batten_deformation *deformation, batten_box shape,
                                    const char *what);

/* One point, and one that is itself a function of two parameters. */
void bat_deformation_point(const batten_deformation *deformation, const double x[3],
                           double out[3]);
void bat_deformation_jets(const batten_deformation *deformation, const bat_jet x[3],
                          bat_jet out[3]);

/* The Jacobian at a point: out[row][column] of coordinate `row` by x, y, z. */
void bat_deformation_jacobian(const batten_deformation *deformation, const double x[3],
                              double out[3][3]);

/* By how much it lengthens anything at most: a bound from the differences of neighbouring lattice points. */
double bat_deformation_stretch(const batten_deformation *deformation);

#endif
