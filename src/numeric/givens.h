/*
 * Least squares whose rows touch few neighbouring unknowns: R by Givens' rotations, a row at a
 * time. The unknowns may close to a ring; then the last of them are a border, which every row
 * may touch.
 */
#ifndef BAT_GIVENS_H
#define BAT_GIVENS_H
#include "base/base.h"

typedef struct {
    int count;      /* unknowns */
    int inner;      /* those of the band; the other `border` come after them */
    int width;      /* of a row of the band */
    int border;     /* 0 unless it is a ring */
    size_t rights;  /* right sides */
    double *band;   /* [inner][width + border + rights] */
    double *corner; /* [border][border + rights] */
    double *sizes;  /* [count], squares of the columns */
    bool *filled;   /* [inner] */
    double *row;    /* [2 width + border + rights] */
} bat_givens;

/* Rows touch at most `width` neighbouring unknowns. */
batten_status bat_givens_begin(int count, int width, bool ring, size_t rights, bat_givens *out);
void bat_givens_clear(bat_givens *qr);
void bat_givens_end(bat_givens *qr);

/* In which order rows must come that begin at unknown `first`, for linear cost: 0 .. count - 1.
 */
int bat_givens_place(const bat_givens *qr, int first);

/* Add a row: factor (values [length] . x[first ..] - right [rights]); on a ring `first` may be
 * any of the unknowns, and the row goes on at 0. Cost width (width + border + rights). */
void bat_givens_add(bat_givens *qr, int first, int length, const double *values, double factor,
                    const double *right);

/* SINGULAR_SYSTEM naming the first unknown that the rows do not determine; *unknown is set. */
batten_status bat_givens_check(const bat_givens *qr, int *unknown);

/* x [count][rights] of the rows given. */
void bat_givens_solve(const bat_givens *qr, double *x);
/* In place x = R^-1 b, and x = R^-T b, of b [count][width]. */
void bat_givens_solve_upper(const bat_givens *qr, size_t width, double *b);
void bat_givens_solve_lower(const bat_givens *qr, size_t width, double *b);

/* The elements of (R^T R)^-1 that belong to unknowns met by one row. */
typedef struct {
    int count, inner, width, border;
    double *band;   /* [inner][width + border]: (i, i + k), then (i, border) */
    double *corner; /* [border][border] */
} bat_inverse_band;

/* Source: [HdH85]. Cost count (width + border)^2. */
batten_status bat_inverse_band_make(const bat_givens *qr, bat_inverse_band *out);
void bat_inverse_band_free(bat_inverse_band *inverse);
/* values^T (R^T R)^-1 values of a row as for bat_givens_add. */
double bat_inverse_band_form(const bat_inverse_band *inverse, int first, int length,
                             const double *values);

#endif
