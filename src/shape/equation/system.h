/*
 * One equation in the plane, two in space: what intervals say of them in a box. The curve is a graph
 * over axis k where the matrix of derivatives by the other axes is regular in all of the box.
 */
#ifndef BAT_EQUATION_SYSTEM_H
#define BAT_EQUATION_SYSTEM_H
#include "shape/equation/program.h"

/* Coordinates, and equations, at most. */
#define BAT_SPACE 3
#define BAT_EQUATIONS 2

typedef struct {
    int equations, dimension; /* dimension = equations + 1 */
    const batten_equation *const *equation;
    bat_jet_space first, along; /* of order 1 in the coordinates; of order 4 along a curve */
} bat_system;

typedef struct {
    bat_interval at[BAT_SPACE];
} bat_cell;

/* Values and derivatives over a cell. */
typedef struct {
    bat_interval value[BAT_EQUATIONS];
    bat_interval slope[BAT_EQUATIONS][BAT_SPACE];
    bool undefined; /* one of the equations has no value anywhere in the cell */
} bat_enclosure;

void bat_system_begin(bat_system *system, int equations, const batten_equation *const *list);
void bat_system_over(bat_system *s, const bat_cell *cell, bat_enclosure *out);

/* Proves that no point of the cell is on the curve. */
bool bat_cell_is_free(bat_system *s, const bat_cell *cell, const bat_enclosure *e);

/* What makes the derivatives by the axes other than k nearly the identity. */
typedef struct {
    double inverse[BAT_EQUATIONS][BAT_EQUATIONS];
    double strength;  /* the determinant: large where the curve runs along the axis */
    double departure; /* of the product from it, largest sum of a row; below 1 */
} bat_regularity;

/* Is the curve a graph over axis k in the whole cell? */
bool bat_is_graph(const bat_system *s, const bat_enclosure *e, int k, bat_regularity *out);

typedef enum { BAT_NO_CROSSING, BAT_ONE_CROSSING, BAT_CROSSINGS_UNKNOWN } bat_crossing_count;

/* Where the curve crosses the part of a cell in which coordinate k is `at`.
 * @param[out] point  [dimension]; @param[out] radius  how far the true point may be from it */
bat_crossing_count bat_find_crossing(bat_system *s, const bat_cell *cell, int k, double at,
                                     double *point, double *radius);

/* Take away what interval Newton shows to be free of the curve, a graph over axis k; false: all is. */
bool bat_cell_tighten(bat_system *s, int k, bat_cell *cell);

/* The unit tangent at a point of the curve, its sign by the order of the equations. */
void bat_curve_tangent(bat_system *s, const double *point, double *out);

double bat_cell_diagonal(const bat_system *s, const bat_cell *cell);
double bat_cell_extent(const bat_system *s, const bat_cell *cell); /* its longest side */
int bat_cell_longest(const bat_system *s, const bat_cell *cell);   /* which that is */

#endif
