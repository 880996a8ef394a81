/* Stability in the report of hydrostatics: how the hull rests, its righting arms with their measures, and cross curves;
 * as text, CSV and JSON. */
#include "design/outputs/hydrostatics.h"

#include <stdio.h>

/* ---- parts of reports ---- */

void bat_hydro_add_cell(double value, batten_text *out)
{
    if (isnan(value))
        batten_text_add(out, " %11s", "-");
    else
        batten_text_add(out, " %11.6g", value);
}

void bat_hydro_add_value(double value, const char *none, batten_text *out)
{
    if (isnan(value))
        batten_text_add(out, "%s", none);
    else
        batten_text_number(out, value);
}

void bat_hydro_add_member(const char *key, double value, bool first, batten_text *out)
{
    batten_text_add(out, "%s\"%s\": ", first ? "" : ", ", key);
    bat_hydro_add_value(value, "null", out);
}

/* ---- measures ---- */

/* What a measure is called, its key of JSON, and its unit: "%": that of length. */
enum { MEASURES = 13, NAME_SIZE = 80 };
typedef struct {
    char name[NAME_SIZE];
    const char *key, *unit;
    double value;
} measure_row;

static void put_measure(measure_row *row, const char *key, const char *unit, double value)
{
    row->key = key;
    row->unit = unit;
    row->value = value;
}

static int put_areas(const bat_hydro_measures *m, measure_row *rows)
{
    static const char *const keys[][2] = {{"area30", "area30_error"},
                                          {"area40", "area40_error"},
                                          {"area30to40", "area30to40_error"}};
    const double from[] = {0, 0, 30}, to[] = {30, m->area_to, m->area_to};
    for (int i = 0; i < 3; i++) {
        batten_text_print(rows[2 * i].name, NAME_SIZE, "area below GZ, %.6g to %.6g deg",
                          from[i], to[i]);
        batten_text_print(rows[2 * i + 1].name, NAME_SIZE, "its error is at most");
        put_measure(&rows[2 * i], keys[i][0], "% rad", m->areas[i].area);
        put_measure(&rows[2 * i + 1], keys[i][1], "% rad", m->areas[i].error);
    }
    return 6;
}

static int list_measures(const bat_hydro_report *r, measure_row rows[MEASURES])
{
    const bat_hydro_measures *m = &r->measures;
    const struct {
        const char *name, *key, *unit;
        double value;
    } plain[] = {{"GM upright", "GM", "%", m->gm},
                 {"GZ upright", "GZ0", "%", m->arm},
                 {"largest GZ", "GZmax", "%", m->largest},
                 {"at the heel", "GZmax_heel", "deg", m->largest_at},
                 {"GZ is above 0 up to the heel", "vanishing_heel", "deg", m->vanishing},
                 {"the edge of the deck is immersed at the heel", "deck_heel", "deg", m->deck},
                 {"an opening is immersed at the heel", "opening_heel", "deg", m->opening}};
    int count = 0;
    for (size_t i = 0; i < sizeof plain / sizeof plain[0]; i++, count++) {
        snprintf(rows[count].name, NAME_SIZE, "%s", plain[i].name);
        put_measure(&rows[count], plain[i].key, plain[i].unit, plain[i].value);
    }
    return count + put_areas(m, rows + count);
}

/* ---- text ---- */

static void add_unit(const bat_hydro_report *r, const char *unit, batten_text *out)
{
    batten_text_add(out, "%s%s", *unit == '%' ? r->unit : unit, *unit == '%' ? unit + 1 : "");
}

static void add_text_measures(const bat_hydro_report *r, batten_text *out)
{
    measure_row rows[MEASURES];
    const int count = list_measures(r, rows);
    batten_text_add(out, "\nMeasures of GZ, to starboard from 0 to 90 deg (-: none there)\n");
    for (int i = 0; i < count; i++) {
        batten_text_add(out, "  %-46s", rows[i].name);
        bat_hydro_add_cell(rows[i].value, out);
        batten_text_add(out, " ");
        add_unit(r, rows[i].unit, out);
        batten_text_add(out, "\n");
    }
}

static void add_text_rest(const bat_hydro_report *r, batten_text *out)
{
    const batten_balance *b = &r->rest;
    batten_text_add(out,
                    "Afloat with %.6g t, their centre at (%.6g, %.6g, %.6g) %s\n"
                    "  draught %.6g %s at x = 0, trim %.6g deg, heel %.6g deg\n"
                    "  GMT %.6g %s, GML %.6g %s: %s\n",
                    r->mass, r->gravity.x, r->gravity.y, r->gravity.z, r->unit,
                    b->flotation.draught, r->unit, b->flotation.trim * 180 / BAT_PI,
                    b->flotation.heel * 180 / BAT_PI, b->metacentric[0], r->unit,
                    b->metacentric[1], r->unit, b->stable ? "stable" : "not stable");
    batten_text_add(out, "\n%-12s %11s %11s %11s %11s %11s\n", "heel, deg", "GZ", "KN", "T",
                    "trim, deg", "freeboard");
    for (int i = 0; i < r->arm_count; i++) {
        const bat_hydro_arm *a = r->arms + i;
        batten_text_add(out, "%-12.6g", a->heel);
        bat_hydro_add_cell(a->arm, out);
        bat_hydro_add_cell(a->kn, out);
        bat_hydro_add_cell(a->draught, out);
        bat_hydro_add_cell(a->trim, out);
        bat_hydro_add_cell(a->freeboard, out);
        batten_text_add(out, "\n");
    }
}

enum { CURVES_OF_TEXT = 6 };

static void add_text_cross(const bat_hydro_report *r, int first, batten_text *out)
{
    const int last = bat_min_int(first + CURVES_OF_TEXT, r->cross_count);
    batten_text_add(out, "\ncross curves: KN, %s, by heel, deg, and displacement, t\n%-12s",
                    r->unit, "");
    for (int k = first; k < last; k++)
        bat_hydro_add_cell(r->displacements[k], out);
    batten_text_add(out, "\n");
    for (int i = 0; i < r->heel_count; i++) {
        batten_text_add(out, "%-12.6g", r->heels[i] * 180 / BAT_PI);
        for (int k = first; k < last; k++)
            bat_hydro_add_cell(r->cross[k * r->heel_count + i], out);
        batten_text_add(out, "\n");
    }
}

void bat_hydro_stability_as_text(const bat_hydro_report *r, batten_text *out)
{
    if (r->mass > 0) {
        add_text_rest(r, out);
        add_text_measures(r, out);
    }
    for (int first = 0; first < r->cross_count; first += CURVES_OF_TEXT)
        add_text_cross(r, first, out);
}

/* ---- tables ---- */

/* The last table: how it rests, as a heel of its own, and the arms. */
static void add_csv_arms(const bat_hydro_report *r, batten_text *out)
{
    const batten_flotation *rest = &r->rest.flotation;
    const double degrees = 180 / BAT_PI;
    batten_text_add(out, "\nheel,GZ,KN,T,trim,freeboard\ndeg,%s,%s,%s,deg,%s\n", r->unit,
                    r->unit, r->unit, r->unit);
    for (int i = -1; i < r->arm_count; i++) {
        const bat_hydro_arm at_rest = {rest->heel * degrees, 0,  NAN, rest->draught,
                                       rest->trim * degrees, NAN};
        const bat_hydro_arm *a = i < 0 ? &at_rest : r->arms + i;
        const double values[] = {a->heel, a->arm, a->kn, a->draught, a->trim, a->freeboard};
        for (int k = 0; k < 6; k++) {
            bat_hydro_add_value(values[k], "", out);
            batten_text_add(out, k < 5 ? "," : "\n");
        }
    }
}

static void add_csv_measures(const bat_hydro_report *r, batten_text *out)
{
    measure_row rows[MEASURES];
    const int count = list_measures(r, rows);
    batten_text_add(out, "\nmeasure,value,unit\n");
    for (int i = 0; i < count; i++) {
        batten_text_add(out, "%s,", rows[i].key);
        bat_hydro_add_value(rows[i].value, "", out);
        batten_text_add(out, ",");
        add_unit(r, rows[i].unit, out);
        batten_text_add(out, "\n");
    }
}

/* Heels by rows, displacements by columns. */
static void add_csv_cross(const bat_hydro_report *r, batten_text *out)
{
    batten_text_add(out, "\nheel");
    for (int k = 0; k < r->cross_count; k++) {
        batten_text_add(out, ",KN at ");
        batten_text_number(out, r->displacements[k]);
        batten_text_add(out, " t");
    }
    batten_text_add(out, "\ndeg");
    for (int k = 0; k < r->cross_count; k++)
        batten_text_add(out, ",%s", r->unit);
    for (int i = 0; i < r->heel_count; i++) {
        batten_text_add(out, "\n");
        bat_hydro_add_value(r->heels[i] * 180 / BAT_PI, "", out);
        for (int k = 0; k < r->cross_count; k++) {
            batten_text_add(out, ",");
            bat_hydro_add_value(r->cross[k * r->heel_count + i], "", out);
        }
    }
    batten_text_add(out, "\n");
}

void bat_hydro_stability_as_csv(const bat_hydro_report *r, batten_text *out)
{
    if (r->mass > 0) {
        add_csv_arms(r, out);
        add_csv_measures(r, out);
    }
    if (r->cross_count > 0)
        add_csv_cross(r, out);
}

/* ---- JSON ---- */

static void add_json_rest(const bat_hydro_report *r, batten_text *out)
{
    const batten_balance *b = &r->rest;
    batten_text_add(out, ",\n  \"afloat\": {");
    bat_hydro_add_member("mass", r->mass, true, out);
    bat_hydro_add_member("x", r->gravity.x, false, out);
    bat_hydro_add_member("y", r->gravity.y, false, out);
    bat_hydro_add_member("z", r->gravity.z, false, out);
    bat_hydro_add_member("draught", b->flotation.draught, false, out);
    bat_hydro_add_member("trim", b->flotation.trim * 180 / BAT_PI, false, out);
    bat_hydro_add_member("heel", b->flotation.heel * 180 / BAT_PI, false, out);
    bat_hydro_add_member("GMT", b->metacentric[0], false, out);
    bat_hydro_add_member("GML", b->metacentric[1], false, out);
    batten_text_add(out, ", \"stable\": %s},\n  \"arms\": [", b->stable ? "true" : "false");
    for (int i = 0; i < r->arm_count; i++) {
        const bat_hydro_arm *a = r->arms + i;
        batten_text_add(out, "%s\n    {", i ? "," : "");
        bat_hydro_add_member("heel", a->heel, true, out);
        bat_hydro_add_member("GZ", a->arm, false, out);
        bat_hydro_add_member("KN", a->kn, false, out);
        bat_hydro_add_member("T", a->draught, false, out);
        bat_hydro_add_member("trim", a->trim, false, out);
        bat_hydro_add_member("freeboard", a->freeboard, false, out);
        batten_text_add(out, "}");
    }
    batten_text_add(out, "\n  ]");
}

static void add_json_measures(const bat_hydro_report *r, batten_text *out)
{
    measure_row rows[MEASURES];
    const int count = list_measures(r, rows);
    batten_text_add(out, ",\n  \"measures\": {");
    for (int i = 0; i < count; i++)
        bat_hydro_add_member(rows[i].key, rows[i].value, i == 0, out);
    bat_hydro_add_member("area_to", r->measures.area_to, false, out);
    batten_text_add(out, "}");
}

static void add_json_cross(const bat_hydro_report *r, batten_text *out)
{
    batten_text_add(out, ",\n  \"cross_curves\": [");
    for (int k = 0; k < r->cross_count; k++) {
        batten_text_add(out, "%s\n    {", k ? "," : "");
        bat_hydro_add_member("DISP", r->displacements[k], true, out);
        batten_text_add(out, ", \"heel\": ");
        for (int i = 0; i < r->heel_count; i++) {
            batten_text_add(out, "%s", i ? ", " : "[");
            bat_hydro_add_value(r->heels[i] * 180 / BAT_PI, "null", out);
        }
        batten_text_add(out, "], \"KN\": ");
        for (int i = 0; i < r->heel_count; i++) {
            batten_text_add(out, "%s", i ? ", " : "[");
            bat_hydro_add_value(r->cross[k * r->heel_count + i], "null", out);
        }
        batten_text_add(out, "]}");
    }
    batten_text_add(out, "\n  ]");
}

void bat_hydro_stability_as_json(const bat_hydro_report *r, batten_text *out)
{
    if (r->mass > 0) {
        add_json_rest(r, out);
        add_json_measures(r, out);
    }
    if (r->cross_count > 0)
        add_json_cross(r, out);
}
