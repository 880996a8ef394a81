/* The cells in which an implicit curve is understood, and those in which it is not. */
#ifndef BAT_EQUATION_CELLS_H
#define BAT_EQUATION_CELLS_H
#include "base/work.h"
#include "shape/equation/system.h"

/* Where a piece of the curve leaves its cell. */
typedef struct {
    double point[BAT_SPACE], radius;
    int axis;  /* across the side */
    double at; /* its coordinate along it */
    int side;  /* of the cell: -1 its low side, 1 its high one */
} bat_cell_end;

/* A piece between two sides, a graph over axis `graph`. */
typedef struct {
    bat_cell cell;
    int graph;
    bat_cell_end end[2];
} bat_cell_piece;

typedef struct {
    bat_cell *items;
    size_t count, room;
} bat_cell_list;

typedef struct {
    bat_system *system;
    bat_cell whole; /* the box, grown */
    bat_cell_piece *pieces;
    size_t count, room;
    bat_cell_list undecided;
    size_t examined; /* boxes */
    size_t most;     /* how many may be */
    bat_work work;
} bat_cells;

/* Divide the cells of a list until each is free, has pieces that are added, or has no side as long as
 * `least` and is added to the undecided. When there are more than `most`, all that is left is
 * undecided. The list is used up. */
batten_status bat_cells_divide(bat_cells *cells, bat_cell_list *list, double least);
void bat_cells_release(bat_cells *cells);

#endif
