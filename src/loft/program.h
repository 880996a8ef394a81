/*
 * The program of one round of a lofting: the unknowns are the moves of those coordinates of
 * control points that are not held, in units of the bound; linear rows and squares are added
 * one by one.
 */
#ifndef BAT_LOFT_PROGRAM_H
#define BAT_LOFT_PROGRAM_H
#include "loft/patch.h"
#include "numeric/programs/convex_program.h"

typedef struct {
    const bat_loft_patch *patch;
    const bool *held; /* [nu][nv][3] */
    double unit;      /* moves are in units of this length */
    int count, band;
    int *unknown; /* [nu][nv][3]: its number, -1 where held */
    double *hessian, *linear;
    int entry_count, entry_room, start_count, start_room;
    int bound_count, bound_room, price_count, price_room;
    int *start, *column;
    double *value, *bounds, *prices;
    int column_count, column_room;
} bat_loft_program;

/* What a row measures: sum of weight[du][dv] d^(du + dv) S / du^.. dv^.. times a vector. */
typedef struct {
    double weight[3][3], vector[3];
} bat_loft_measure;

batten_status bat_loft_program_make(const bat_loft_patch *patch, const bool *held, double unit,
                                    bat_loft_program *out);
void bat_loft_program_free(bat_loft_program *program);

/* Add factor J3: the sum over a of C(3, a) times the integral of (d^3 S / du^a dv^(3-a))^2. */
batten_status bat_loft_add_energy(bat_loft_program *program, double factor);
/* Add factor (measure of the moves at the place - missing)^2 / 2. */
void bat_loft_add_square(bat_loft_program *program, const bat_loft_place *place,
                         const bat_loft_measure *measure, double factor, double missing);
/* measure of the move <= bound, divided by its norm; `price` of a unit of the normed row,
 * HUGE_VAL when it must hold. Rows that no move of a million units reaches are left out. */
batten_status bat_loft_add_row(bat_loft_program *program, const bat_loft_place *place,
                               const bat_loft_measure *measure, double bound, double price);

/* No coordinate of a control point moves by more than this. */
batten_status bat_loft_limit_moves(bat_loft_program *program, double most);

/* Solve and move the points. NOT_COMPATIBLE when the rows cannot hold together. */
batten_status bat_loft_program_move(bat_loft_program *program, double *points, double *slack,
                                    bat_convex_report *report);

/* J3 of the patch. */
batten_status bat_loft_energy(const bat_loft_patch *patch, double *out);

#endif
