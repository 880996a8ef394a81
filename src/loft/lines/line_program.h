/*
 * A line of a hull, and the program that makes it fair: the unknowns are the differences of its coefficients from a quadratic, in
 * bounds, without those that are pinned.
 */
#ifndef BAT_LOFT_LINE_PROGRAM_H
#define BAT_LOFT_LINE_PROGRAM_H
#include "base/arena.h"
#include "loft/patch.h"

/* Coefficients first .. last lie on one straight line over their Greville abscissas: the function is
 * straight on the spans that they alone make. */
typedef struct {
    int first, last; /* at least 3 apart */
} bat_straight_run;

typedef struct {
    int count;           /* coefficients */
    const double *knots; /* [count + 4], cubic, from 0 to 1 */
    int datum_count;     /* 3 or more */
    const double *t;     /* [datum_count], increasing */
    const double *values;
    const double *rooms; /* [datum_count]: parts of `within` that each has; NULL: all of it */
    double within;       /* |f(t) - value| */
    int changes;         /* of the sign of f'' at most, where the bound leaves a way */
    double length;       /* of what t stands for: bulges are seen over it */
    double height;       /* bulges up to this are not seen */
    bool pinned[2];      /* the first, the last value is met exactly */
    bool one_side;       /* f >= 0 */
    int run_count;
    const bat_straight_run *runs; /* [run_count], ascending; they share a coefficient at most */
} bat_loft_line;

/* A derivative of the function of these coefficients. */
double bat_loft_line_at(const bat_loft_line *line, const double *f, double t, int order);
/* Within each run put the coefficients on the line from its first to its last. */
void bat_loft_line_straighten(const bat_loft_line *line, double *f);

typedef struct {
    const bat_loft_line *of;
    bat_arena arena;
    double size;         /* of the values */
    double smooth;       /* the weight of f''' */
    double *quadratic;   /* [count]: its coefficients, straight on the runs */
    double *missing;     /* [datum_count]: of the values, beyond the quadratic, in bounds */
    int first, unknowns; /* those that are not pinned; a run has its two ends */
    bool impossible;     /* what is pinned breaks a bound by itself */
    double *hessian, *linear; /* of the differences in bounds */
    double *x;                /* [count]: the differences */
    int row_count;
    int *start, *column;
    double *value, *bounds, *prices;
    int sample_count;
    double *sample, *curvature;
    int *signs;
} bat_line_program;

/* Squares of moves and of f''', rows of the bounds, and on demand of the signs of f''. */
void bat_line_build(bat_line_program *program, bool signs);
batten_status bat_line_solve(bat_line_program *program);
/* Without rows: exact where none of them binds. `factor` [count][4]. */
batten_status bat_line_solve_freely(bat_line_program *program, double *factor, bool *holds);

#endif
