/* What the output 'hydrostatics' states. */
#ifndef BAT_DESIGN_HYDROSTATICS_H
#define BAT_DESIGN_HYDROSTATICS_H
#include "base/base.h"
#include <batten/hull.h>
#include <batten/text.h>

/* The columns of the table: by the symbols of the International Towing Tank Conference. */
typedef enum {
    BAT_HYDRO_T,
    BAT_HYDRO_VOLUME,
    BAT_HYDRO_DISPLACEMENT,
    BAT_HYDRO_LENGTH,
    BAT_HYDRO_BREADTH,
    BAT_HYDRO_WATERPLANE,
    BAT_HYDRO_WETTED,
    BAT_HYDRO_LCB,
    BAT_HYDRO_TCB,
    BAT_HYDRO_VCB,
    BAT_HYDRO_LCF,
    BAT_HYDRO_ACROSS,
    BAT_HYDRO_ALONG,
    BAT_HYDRO_BMT,
    BAT_HYDRO_BML,
    BAT_HYDRO_KMT,
    BAT_HYDRO_KML,
    BAT_HYDRO_TPC,
    BAT_HYDRO_MCT,
    BAT_HYDRO_CB,
    BAT_HYDRO_CWP,
    BAT_HYDRO_CVP,
    BAT_HYDRO_AX,
    BAT_HYDRO_CX,
    BAT_HYDRO_CP,
    BAT_HYDRO_COLUMNS
} bat_hydro_column;

typedef struct {
    double values[BAT_HYDRO_COLUMNS]; /* NAN: none, as the coefficients of no length */
} bat_hydro_row;

/* A righting arm; all NAN beside the heel where the hull does not float so. */
typedef struct {
    double heel, arm, kn, draught, trim; /* degrees, lengths */
} bat_hydro_arm;

typedef struct {
    const char *unit;           /* of length */
    double density, trim, heel; /* t/m3, degrees */
    double length;              /* between perpendiculars, 0: the waterline's */
    int count;
    bat_hydro_row *rows; /* [count] */
    int place_count;
    double *places; /* [place_count]: x of sections */
    double *areas;  /* [count][place_count] */
    int lid_count;
    const batten_hull_lid *lids;
    double mass; /* t; 0: no loading */
    batten_vec3 gravity;
    batten_balance rest;
    int arm_count;
    bat_hydro_arm *arms; /* [arm_count] */
} bat_hydro_report;

/* What sections need: areas are found within 1e-8 of the breadth times the depth of the hull. */
typedef struct {
    const batten_hull *hull;
    const batten_job *job;
    batten_flotation at;
    double length; /* that of the coefficients */
    int *lost;     /* areas that were not found */
} bat_hydro_water;

/* Areas of the sections at places [count], and the columns of the largest section. CANCELLED, OUT_OF_MEMORY. */
batten_status bat_hydro_fill_sections(const bat_hydro_water *water, int count,
                                      const double *places, double *areas,
                                      double values[BAT_HYDRO_COLUMNS]);

/* The lowest edge along the ship that is closed across in the upper half of the hull, else its top. */
double bat_hydro_deck(const batten_hull *hull);

/* Heights of the water in round steps, from above the keel and the baseline to the edge of the deck; at
 * least one. BAD_ARGUMENT where there is none. */
enum { BAT_HYDRO_DRAUGHTS = 12 };
batten_status bat_hydro_round_draughts(const batten_hull *hull,
                                       double draughts[BAT_HYDRO_DRAUGHTS], int *count);

/* So many places, of which the first and the last are the ends of the hull. */
enum { BAT_HYDRO_PLACES = 21 };
double bat_hydro_place(const batten_hull *hull, int index);

void bat_hydro_as_text(const bat_hydro_report *report, batten_text *out);
void bat_hydro_as_csv(const bat_hydro_report *report, batten_text *out);
void bat_hydro_as_json(const bat_hydro_report *report, batten_text *out);

#endif
