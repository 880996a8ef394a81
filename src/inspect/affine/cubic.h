/* Signs of the forms in A, B, C that decide what a cubic is. */
#ifndef BAT_CUBIC_H
#define BAT_CUBIC_H
#include "numeric/exact.h"
#include <batten/invariants.h>

/* The forms: linear and quadratic in A, B, C. */
typedef enum {
    BAT_FORM_A,
    BAT_FORM_B,
    BAT_FORM_C,
    BAT_FORM_LEAD,   /* A - B + C, of t^2 in P' x P'' */
    BAT_FORM_FIRST,  /* 2 A - B: the mean parameter of a double point is above 0 */
    BAT_FORM_LAST,   /* 2 C - B: and below 1 */
    BAT_FORM_D,      /* B^2 - 4 A C */
    BAT_FORM_RETURN, /* A^2 - A B + B^2 - 3 A C: the loop crosses behind P0 */
    BAT_FORM_LEAVE,  /* C^2 - C B + B^2 - 3 A C: and before P3 */
    BAT_FORM_COUNT
} bat_cubic_form;

/* The form of A, B, C; *size: the sum of the sizes of its terms. */
double bat_cubic_value(int form, const double *abc, double *size);

/* The points in the plane, scaled by a power of two so that the largest coordinate is near 1.
 */
typedef struct {
    double point[4][2];
    double edge[3][2];
    double scale;
    double longest;          /* edge */
    double abc[3], bound[3]; /* A, B, C, and how far rounding may have moved them */
    bool has_exact;
    bat_exact exact[3];
} bat_cubic;

/* Edges and A, B, C from the points. */
void bat_cubic_begin(bat_cubic *c);
/* The sign of a form: 0 within `tolerance` of its terms, else exact. *relative: its size by
 * that of its terms. */
int bat_cubic_sign(bat_cubic *c, int form, double tolerance, double *relative);
/* Are A, B, C all 0, or within `tolerance` (longest edge)^2? */
bool bat_cubic_is_line(bat_cubic *c, double tolerance);
/* Do four points in space lie in no plane? *relative: the volume by (longest edge)^3. */
bool bat_cubic_has_volume(double p[4][3], double tolerance, double *relative);

/* How near the nearest form is to 0, of those whose sign matters to a decision. */
double bat_cubic_margin(const int *signs, const double *relative,
                        batten_cubic_class (*decide)(const int *));

/* The class by the signs of all forms, of the open segment and of the whole cubic. */
batten_cubic_class bat_cubic_segment_class(const int *signs);
batten_cubic_class bat_cubic_whole_class(const int *signs);

#endif
