/* A lines plan while it is drawn: its views, scale and sheet. */
#ifndef BAT_LINES_PLAN_H
#define BAT_LINES_PLAN_H
#include "picture/drawings/hull.h"
#include "picture/sheet/sheet.h"

/*
 * Three views of one hull at one scale: profile (x, z), half-breadth plan (x, y) below it, and
 * body plan (y, z) beside the profile or at the bottom, whichever lets the drawing be larger.
 * The bow is at the larger x, to the right.
 */
typedef enum { PROFILE, BREADTH, BODY, VIEWS } bat_lines_view;

/* The coordinates that a view shows to the right and up, and the family of planes it shows as
 * curves. */
static const struct {
    int right, up;
    bat_family curves;
    const char *title;
} bat_lines_views[VIEWS] = {[PROFILE] = {0, 2, BAT_BUTTOCKS, "Profile"},
                            [BREADTH] = {0, 1, BAT_WATERLINES, "Half-breadth plan"},
                            [BODY] = {1, 2, BAT_STATIONS, "Body plan"}};

static const bat_colour bat_lines_colours[BAT_FAMILIES] = {
    [BAT_STATIONS] = {0.13, 0.15, 0.18},
    [BAT_BUTTOCKS] = {0.07, 0.45, 0.27},
    [BAT_WATERLINES] = {0.10, 0.36, 0.68},
    [BAT_DIAGONALS] = {0.52, 0.20, 0.55}};
static const bat_colour bat_lines_design_colour = {0.80, 0.18, 0.12};

typedef struct {
    const batten_model *model;
    const batten_draw_lines_plan_options *plan;
    const batten_draw_options *options;
    batten_notes *notes;
    bat_hull hull;
    double middle; /* x between after-body and fore-body */
    double ratio;  /* the scale is 1 : ratio */
    double scale;  /* points per unit */
    bat_plot plots[VIEWS];
    bat_rectangle strip; /* the foot of the sheet: legend, scale bar, title block */
    bat_rectangle table; /* room for the table of offsets */
} bat_lines_sheet;

/* Between the edge of the sheet and its frame, in em. */
enum { BAT_LINES_BORDER = 2 };

/* ---- pens ---- */

static inline bat_pen bat_lines_curve_pen(bat_family family, bool is_design)
{
    return is_design ? (bat_pen){bat_lines_design_colour, 1.5, BAT_SOLID}
                     : (bat_pen){bat_lines_colours[family], 0.9, BAT_SOLID};
}

static const bat_pen bat_lines_edge_pen = {{0.13, 0.15, 0.18}, 1.6, BAT_SOLID};
static const bat_pen bat_lines_cross_pen = {{0.75, 0.30, 0.05}, 0.8, BAT_SOLID};

/* ---- lines_plan_names.c ---- */

/* "WL 0.5", "B 0.2", "D1", or the number of a station. */
void bat_lines_name(const bat_lines_sheet *s, bat_family family, int i, char text[static 48]);

/* ---- lines_plan_diagonals.c ---- */

/* The diagonals: straight in the body plan, and in their true shape below the centre line of the half-breadth
 * plan. */
batten_status bat_lines_draw_diagonals(bat_canvas *canvas, const bat_lines_sheet *s);

/* ---- lines_plan_layout.c ---- */

/* Place the views and the foot, at the largest scale of usual ratio that has room. */
batten_status bat_lines_lay_out(bat_lines_sheet *s, const bat_canvas *canvas);

/* ---- lines_plan_foot.c ---- */

/* Legend, scale bar and title block, in the strip of the sheet. */
void bat_lines_draw_foot(bat_canvas *canvas, const bat_lines_sheet *s);

/* ---- lines_plan_offsets.c ---- */

/* Where a station crosses a waterline, its half-breadth; where it crosses a buttock, the lowest height; where it
 * crosses a diagonal, the longest way along that; NaN where it does not. */
double bat_lines_offset(const bat_lines_sheet *s, int station, bat_family family, int line);
/* The lowest and the highest point of a station, and how far the highest is from the middle; NaN without any. */
typedef struct {
    double keel, sheer, breadth;
} bat_lines_ends;
bat_lines_ends bat_lines_ends_of(const bat_lines_sheet *s, int station);
/* The half-breadth and the height of a knuckle at a station; NaN where it does not reach. */
void bat_lines_knuckle_offsets(const bat_lines_sheet *s, int station, int knuckle,
                               double yz[2]);

/* ---- lines_plan_table.c ---- */

/* The table of offsets in its room; false when it is too large for it. */
bool bat_lines_draw_table(bat_canvas *canvas, const bat_lines_sheet *s);

#endif
