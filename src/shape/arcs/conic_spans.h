/* One span of conics: a C by one conic or two, an S, a line, a biarc. */
#ifndef BAT_ARCS_CONIC_SPANS_H
#define BAT_ARCS_CONIC_SPANS_H
#include <batten/arcs.h>

/* A conic arc: its ends, where the tangents meet, and the weight there. */
typedef struct {
    double a[2], b[2], c[2], w;
} bat_conic_piece;

/* Two points with directions of length 1, angles from the chord, and curvatures. */
typedef struct {
    const double *start, *end, *t0, *t1;
    double l, alpha, beta, k0, k1;
} bat_conic_span;

typedef struct {
    int count;
    const double *points;
    const batten_curve_conics_options *options;
    double *units;      /* [count][2] */
    double *curvatures; /* [count] */
    int piece_count;
    bat_conic_piece *pieces;
    int *first; /* [spans + 1] pieces */
    batten_curve_conics_report report;
} bat_conic_fit;

/* Legs and weights beyond these do not make a conic that anybody means. */
static const double bat_conic_longest_leg = 20, bat_conic_most_weight = 50;

/* Where the tangents meet, as legs; false when that is too far. */
bool bat_conic_find_legs(const bat_conic_span *s, double *start, double *end);
double bat_conic_curvature(const bat_conic_piece *p, bool at_end);
void bat_conic_add_c(bat_conic_fit *t, int i, const bat_conic_span *s, double leg0,
                     double leg1);
/* The joint on the chord and the direction there are those of the cubic function over the chord
 * with the same angles: it crosses at alpha / (alpha + beta), at the angle -alpha beta / (alpha
 * + beta). So each half is a C, and has a curvature at its point, but not at the joint. */
void bat_conic_add_s(bat_conic_fit *t, int i, const bat_conic_span *s);
void bat_conic_add_line(bat_conic_fit *t, const bat_conic_span *s);
batten_status bat_conic_add_biarc(bat_conic_fit *t, int i, const bat_conic_span *s);

#endif
