/* Tables of offsets as boat builders write them: in feet, inches and eighths of an inch. */
#include "exchange/csv/csv.h"
#include "model/short_decimal.h"

#include <batten/text.h>

typedef struct {
    batten_text *text;
    const batten_offset_table *offsets;
    int stations, lines;
    double factor; /* inches of one unit of the table */
    int *at;       /* [lines][stations] the point of the station on the line, -1 for none */
    double error;  /* largest rounding, inches */
} writing;

/* Each point must be the only one of its line at its station, and stand there. */
static batten_status find_points(writing *w)
{
    for (int i = 0; i < w->lines * w->stations; i++)
        w->at[i] = -1;
    for (int s = 0; s < w->stations; s++) {
        const batten_table_station *station = batten_offset_table_station(w->offsets, s);
        for (int k = 0; k < station->point_count; k++) {
            const batten_table_point *p = &station->points[k];
            if (p->line < 0)
                return bat_fail(BATTEN_NOT_COMPATIBLE,
                                "point %d of station '%.60s' is on no line; a table in feet, "
                                "inches and eighths consists of lines",
                                k + 1, station->name);
            if (p->x != station->x)
                return bat_fail(BATTEN_NOT_COMPATIBLE,
                                "point %d of station '%.60s' is at x = %g, not at %g as its "
                                "station; a table of lines cannot express that",
                                k + 1, station->name, p->x, station->x);
            int *at = &w->at[p->line * w->stations + s];
            if (*at >= 0)
                return bat_fail(BATTEN_NOT_COMPATIBLE,
                                "line '%.60s' has two points at station '%.60s'; a table of "
                                "lines cannot express that",
                                batten_offset_table_line(w->offsets, p->line)->name,
                                station->name);
            *at = k;
        }
    }
    return BATTEN_OK;
}

/* "1-7-4" is 1 foot, 7 inches and 4 eighths. */
static void put_eighths(writing *w, double inches, double eighths)
{
    const double feet = floor(eighths / 96), rest = eighths - 96 * feet;
    batten_text_add(w->text, "%s%.0f-%d-%d", inches < 0 && eighths > 0 ? "-" : "", feet,
                    (int)rest / 8, (int)rest % 8);
}

static void put_feet(writing *w, double value)
{
    const double inches = value * w->factor, eighths = floor(8 * fabs(inches) + 0.5);
    w->error = bat_max(w->error, fabs(eighths / 8 - fabs(inches)));
    put_eighths(w, inches, eighths);
}

/* Are all stations at whole eighths, but for the last places of their numbers? */
static bool are_whole(const writing *w)
{
    for (int s = 0; s < w->stations; s++) {
        const double x =
            bat_near_decimal(batten_offset_table_station(w->offsets, s)->x * w->factor);
        if (8 * x != floor(8 * x))
            return false;
    }
    return true;
}

static void put_station_names(writing *w)
{
    batten_text_add(w->text, "axis,name");
    for (int s = 0; s < w->stations; s++) {
        batten_text_bytes(w->text, ",", 1);
        bat_put_quoted(w->text, batten_offset_table_station(w->offsets, s)->name);
    }
}

static void put_length(writing *w, double x, bool whole)
{
    batten_text_bytes(w->text, ",", 1);
    if (whole)
        put_eighths(w, x, 8 * fabs(x));
    else
        batten_text_number(w->text, x);
}

/* The positions of the stations are written in feet, inches and eighths when that is exact for all, else
 * in inches, to the last digit. */
static void put_stations(writing *w)
{
    const bool whole = are_whole(w);
    put_station_names(w);
    batten_text_add(w->text, "\nlength,station");
    for (int s = 0; s < w->stations; s++) {
        const double x =
            bat_near_decimal(batten_offset_table_station(w->offsets, s)->x * w->factor);
        put_length(w, x, whole);
    }
    batten_text_bytes(w->text, "\n", 1);
}

static void put_block(writing *w, const char *axis, bool heights)
{
    for (int line = 0; line < w->lines; line++) {
        batten_text_add(w->text, "%s,", line == 0 ? axis : "");
        bat_put_quoted(w->text, batten_offset_table_line(w->offsets, line)->name);
        for (int s = 0; s < w->stations; s++) {
            const int at = w->at[line * w->stations + s];
            batten_text_bytes(w->text, ",", 1);
            if (at < 0) {
                batten_text_bytes(w->text, "x", 1);
                continue;
            }
            const batten_table_point *p =
                &batten_offset_table_station(w->offsets, s)->points[at];
            put_feet(w, heights ? p->z : p->y);
        }
        batten_text_bytes(w->text, "\n", 1);
    }
}

/* Numbers beyond a million feet have no eighths that a double could keep. */
static batten_status check_sizes(const writing *w)
{
    const batten_box box = batten_offset_table_box(w->offsets);
    const double far[6] = {box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z};
    for (int k = 0; k < 6; k++)
        /* In inches, rounded down from the 1.2e7 of a million feet. */
        if (!(fabs(far[k] * w->factor) < 1e7))
            return bat_fail(
                BATTEN_TOO_LARGE,
                "a coordinate of %g inches is too large for feet, inches and eighths",
                far[k] * w->factor);
    return BATTEN_OK;
}

batten_status bat_write_loft(const batten_object *object, double unit_metres,
                             batten_notes *notes, batten_text *text)
{
    const batten_offset_table *offsets = object->offset_table;
    const double own = batten_offset_table_unit_metres(offsets);
    const double unit = own > 0 ? own : unit_metres;
    if (!(unit > 0))
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the table has no unit; feet and inches need one (--from-unit)");
    writing w = {.text = text,
                 .offsets = offsets,
                 .stations = batten_offset_table_station_count(offsets),
                 .lines = batten_offset_table_line_count(offsets),
                 .factor = bat_near_decimal(unit / 0.0254)};
    w.at = bat_array3((size_t)w.lines, (size_t)w.stations, sizeof *w.at);
    if (!w.at)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = check_sizes(&w);
    if (status == BATTEN_OK)
        status = find_points(&w);
    if (status == BATTEN_OK) {
        put_stations(&w);
        put_block(&w, "heights", true);
        put_block(&w, "widths", false);
        /* Less than a nanometre, in mm, is rounding of doubles and not of eighths. */
        if (w.error > 1e-9)
            batten_notes_add(notes, "", 0, object->name,
                             "rounded to eighths of an inch, by %.3g mm at most",
                             25.4 * w.error);
    }
    bat_release(w.at);
    return status;
}
