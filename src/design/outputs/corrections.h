/* What lofting and fairing changed, point by point. */
#ifndef BAT_DESIGN_CORRECTIONS_H
#define BAT_DESIGN_CORRECTIONS_H
#include <batten/fair.h>
#include <batten/text.h>

/* One correction, as lists have it. */
typedef struct {
    batten_station_label place; /* of curves "curve 2", "control points of curve 2" */
    int set;                    /* which station or curve */
    int index;                  /* which point */
    const char *line;           /* "" for none */
    const double *from, *to;
    double distance;
    const char *reason; /* "noise", "bound", "suspect" */
} bat_correction;

/* The correction of this index of a lofting; it borrows from the report. */
bat_correction bat_loft_correction_at(const batten_loft_report *report, int index);

/* As text, without an end of the line: station, line or point, what changed, how far and why. */
void bat_correction_as_text(const bat_correction *correction, const char *unit,
                            batten_text *out);
/* As an object of JSON. */
void bat_correction_as_json(const bat_correction *correction, batten_text *out);

#endif
