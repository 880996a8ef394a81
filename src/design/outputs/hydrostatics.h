/* What the output 'hydrostatics' states. */
#ifndef BAT_DESIGN_HYDROSTATICS_H
#define BAT_DESIGN_HYDROSTATICS_H
#include "base/arena.h"
#include "design/feature.h"
#include <batten/hull.h>
#include <batten/measure.h>
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
    double
        freeboard; /* least height of the edge of the deck above the water, NAN without one */
} bat_hydro_arm;

/* Length times radians, and how well it is known. */
typedef struct {
    double area, error;
} bat_hydro_area;

/* Of the curve of righting arms to starboard; NAN: none up to 90 degrees, or none found. */
typedef struct {
    double gm, arm;             /* upright */
    double largest, largest_at; /* arm, and its heel; degrees */
    double vanishing;           /* the heel from which the arm is no longer above 0 */
    double deck,
        opening; /* heels at which the edge of the deck and the first opening come to the water */
    double area_to;          /* 40 degrees, or `opening` when that is less */
    bat_hydro_area areas[3]; /* below the curve from 0 to 30, 0 to `area_to`, 30 to `area_to` */
} bat_hydro_measures;

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
    int heel_count;
    double *heels; /* [heel_count]: radians */
    int arm_count;
    bat_hydro_arm *arms; /* [arm_count] */
    bat_hydro_measures measures;
    double spacing; /* of a catamaran, 0: one hull */
    int cross_count;
    double *displacements; /* [cross_count]: t */
    double *cross;         /* [cross_count][heel_count]: KN */
} bat_hydro_report;

/* Of the sums in each patch, relatively; text shows six digits. */
static const double BAT_HYDRO_PRECISION = 1e-9;

/* The output while it is made. */
typedef struct {
    bat_run *run;
    bat_arena arena;
    batten_hull *hull;
    double metres;
    batten_loading loading;
    batten_flotation
        *near; /* where the next search for rest begins: at the last that was found */
    bat_hydro_report report;
} bat_hydro;

/* What is 0 but for rounding is 0. */
double bat_hydro_without_dust(const bat_hydro *h, double place);
/* How the hull floats with its mass, its arms and cross curves: what the parameters ask for. */
batten_status bat_hydro_float(bat_hydro *h);
/* At a heel, free to trim; `found` is false where it finds no trim. */
batten_status bat_hydro_balance(const bat_hydro *h, const batten_loading *loading, double heel,
                                batten_balance *out, bool *found);
/* The measures of its arms. */
batten_status bat_hydro_measure(bat_hydro *h);

/* What sections need: areas are found within 1e-8 of the breadth times the depth of the hull. */
typedef struct {
    const batten_hull *hull;
    const batten_job *job;
    batten_flotation at;
    double length, breadth; /* those of the coefficients */
    int *lost;              /* areas that were not found */
} bat_hydro_water;

/* Areas of the sections at places [count], and the columns of the largest section. CANCELLED, OUT_OF_MEMORY. */
batten_status bat_hydro_fill_sections(const bat_hydro_water *water, int count,
                                      const double *places, double *areas,
                                      double values[BAT_HYDRO_COLUMNS]);

/* Heights of the water in round steps, from above the keel and the baseline to the edge of the deck; at
 * least one. BAD_ARGUMENT where there is none. */
enum { BAT_HYDRO_DRAUGHTS = 12 };
batten_status bat_hydro_round_draughts(const batten_hull *hull,
                                       double draughts[BAT_HYDRO_DRAUGHTS], int *count);

/* So many places, of which the first and the last are the ends of the hull. */
enum { BAT_HYDRO_PLACES = 21 };
double bat_hydro_place(const batten_hull *hull, int index);

/* ---- parts of reports ---- */
/* A column of text; "-" for NAN. */
void bat_hydro_add_cell(double value, batten_text *out);
/* All digits; `none` for NAN. */
void bat_hydro_add_value(double value, const char *none, batten_text *out);
/* Of a JSON object. */
void bat_hydro_add_member(const char *key, double value, bool first, batten_text *out);
void bat_hydro_stability_as_text(const bat_hydro_report *report, batten_text *out);
void bat_hydro_stability_as_csv(const bat_hydro_report *report, batten_text *out);
void bat_hydro_stability_as_json(const bat_hydro_report *report, batten_text *out);

void bat_hydro_as_text(const bat_hydro_report *report, batten_text *out);
void bat_hydro_as_csv(const bat_hydro_report *report, batten_text *out);
void bat_hydro_as_json(const bat_hydro_report *report, batten_text *out);

#endif
