/* The report of hydrostatics, its columns with their names and units: text; CSV and JSON, which
 * have all digits: the table by draughts and the areas of sections. */
#include "design/outputs/hydrostatics.h"

#include <string.h>

/* "%" stands for the unit of length. */
static const struct {
    const char *symbol, *unit, *about;
} columns[BAT_HYDRO_COLUMNS] = {
    [BAT_HYDRO_T] = {"T", "%", "draught at x = 0 above the baseline z = 0"},
    [BAT_HYDRO_VOLUME] = {"VOL", "%3", "displaced volume, moulded"},
    [BAT_HYDRO_DISPLACEMENT] = {"DISP", "t", "displacement"},
    [BAT_HYDRO_LENGTH] = {"LWL", "%", "length of the waterline"},
    [BAT_HYDRO_BREADTH] = {"BWL", "%", "breadth of the waterline"},
    [BAT_HYDRO_WATERPLANE] = {"AW", "%2", "area of the waterplane"},
    [BAT_HYDRO_WETTED] = {"S", "%2", "wetted surface"},
    [BAT_HYDRO_LCB] = {"XCB", "%", "centre of buoyancy: x"},
    [BAT_HYDRO_TCB] = {"YCB", "%", "y"},
    [BAT_HYDRO_VCB] = {"KB", "%", "z"},
    [BAT_HYDRO_LCF] = {"XCF", "%", "centre of flotation: x"},
    [BAT_HYDRO_ACROSS] = {"IT", "%4", "transverse second moment of the waterplane"},
    [BAT_HYDRO_ALONG] = {"IL", "%4", "longitudinal second moment of the waterplane"},
    [BAT_HYDRO_BMT] = {"BMT", "%", "transverse metacentric radius, IT / VOL"},
    [BAT_HYDRO_BML] = {"BML", "%", "longitudinal metacentric radius, IL / VOL"},
    [BAT_HYDRO_KMT] = {"KMT", "%", "transverse metacentre above the baseline, KB + BMT"},
    [BAT_HYDRO_KML] = {"KML", "%", "longitudinal metacentre above the baseline, KB + BML"},
    [BAT_HYDRO_TPC] = {"TPC", "t/cm", "tonnes per centimetre of immersion"},
    [BAT_HYDRO_MCT] = {"MCT", "t m/cm", "moment to trim one centimetre, by BML"},
    [BAT_HYDRO_CB] = {"CB", "1", "block coefficient, VOL / (L BWL T)"},
    [BAT_HYDRO_CWP] = {"CWP", "1", "waterplane coefficient, AW / (L BWL)"},
    [BAT_HYDRO_CVP] = {"CVP", "1", "vertical prismatic coefficient, VOL / (AW T)"},
    [BAT_HYDRO_AX] = {"AX", "%2", "area of the largest section across x"},
    [BAT_HYDRO_CX] = {"CX", "1", "coefficient of this section, AX / (BWL T)"},
    [BAT_HYDRO_CP] = {"CP", "1", "prismatic coefficient, VOL / (L AX)"},
};

static void add_unit(const bat_hydro_report *r, const char *unit, batten_text *out)
{
    if (*unit == '%')
        batten_text_add(out, "%s%s", r->unit, unit + 1);
    else
        batten_text_add(out, "%s", unit);
}

/* ---- text ---- */

enum { COLUMNS_OF_TEXT = 6 };

static void add_block(const bat_hydro_report *r, int first, batten_text *out)
{
    const int last = bat_min_int(first + COLUMNS_OF_TEXT, r->count);
    for (int c = 0; c < BAT_HYDRO_COLUMNS; c++) {
        const size_t before = out->length;
        batten_text_add(out, "%-5s", columns[c].symbol);
        add_unit(r, columns[c].unit, out);
        const int width = (int)(out->length - before);
        batten_text_add(out, "%*s", bat_max_int(0, 12 - width), "");
        for (int i = first; i < last; i++)
            bat_hydro_add_cell(r->rows[i].values[c], out);
        batten_text_add(out, "\n");
    }
    batten_text_add(out, "\n");
}

static void add_conventions(const bat_hydro_report *r, batten_text *out)
{
    batten_text_add(out,
                    "x along the ship, y to port, z up from the baseline; moulded, water of "
                    "%.6g t/m3\ntrim %.6g deg (by the stern, towards lower x, above 0), heel "
                    "%.6g deg (to starboard above 0)\n",
                    r->density, r->trim, r->heel);
    if (r->length > 0)
        batten_text_add(out, "L in the coefficients and in MCT is %.6g %s\n", r->length,
                        r->unit);
    else
        batten_text_add(out, "L in the coefficients and in MCT is LWL\n");
    if (r->spacing > 0)
        batten_text_add(out,
                        "two hulls, their centre planes %.6g %s apart; BWL is over both, the "
                        "breadth in CB, CWP and CX that of both without what is between them\n",
                        r->spacing, r->unit);
    for (int i = 0; i < r->lid_count; i++) {
        const batten_box *box = &r->lids[i].edge;
        batten_text_add(out,
                        "closed across from the edge at x %.6g to %.6g, z %.6g to %.6g: "
                        "%.6g %s2, which S does not count\n",
                        box->low.x, box->high.x, box->low.z, box->high.z, r->lids[i].area,
                        r->unit);
    }
    batten_text_add(out, "\n");
}

/* Bonjean's curves are its rows, curves of sectional areas its columns. */
static void add_sections(const bat_hydro_report *r, int first, batten_text *out)
{
    const int last = bat_min_int(first + COLUMNS_OF_TEXT, r->count);
    batten_text_add(out, "areas of sections, %s2, at x by draughts\n%-12s", r->unit, "x");
    for (int i = first; i < last; i++)
        bat_hydro_add_cell(r->rows[i].values[BAT_HYDRO_T], out);
    batten_text_add(out, "\n");
    for (int k = 0; k < r->place_count; k++) {
        batten_text_add(out, "%-12.6g", r->places[k]);
        for (int i = first; i < last; i++)
            bat_hydro_add_cell(r->areas[(size_t)i * (size_t)r->place_count + (size_t)k], out);
        batten_text_add(out, "\n");
    }
    batten_text_add(out, "\n");
}

void bat_hydro_as_text(const bat_hydro_report *r, batten_text *out)
{
    add_conventions(r, out);
    for (int first = 0; first < r->count; first += COLUMNS_OF_TEXT)
        add_block(r, first, out);
    for (int c = 0; c < BAT_HYDRO_COLUMNS; c++)
        batten_text_add(out, "%-5s%s\n", columns[c].symbol, columns[c].about);
    batten_text_add(out, "\n");
    for (int first = 0; first < r->count; first += COLUMNS_OF_TEXT)
        add_sections(r, first, out);
    bat_hydro_stability_as_text(r, out);
}

/* ---- a table ---- */

/* A table below the first: x by rows, draughts by columns. */
static void add_csv_sections(const bat_hydro_report *r, batten_text *out)
{
    batten_text_add(out, "\nx");
    for (int i = 0; i < r->count; i++) {
        batten_text_add(out, ",A at T = ");
        batten_text_number(out, r->rows[i].values[BAT_HYDRO_T]);
    }
    batten_text_add(out, "\n%s", r->unit);
    for (int i = 0; i < r->count; i++)
        batten_text_add(out, ",%s2", r->unit);
    batten_text_add(out, "\n");
    for (int k = 0; k < r->place_count; k++) {
        bat_hydro_add_value(r->places[k], "", out);
        for (int i = 0; i < r->count; i++) {
            batten_text_add(out, ",");
            bat_hydro_add_value(r->areas[(size_t)i * (size_t)r->place_count + (size_t)k], "",
                                out);
        }
        batten_text_add(out, "\n");
    }
}

void bat_hydro_as_csv(const bat_hydro_report *r, batten_text *out)
{
    for (int c = 0; c < BAT_HYDRO_COLUMNS; c++)
        batten_text_add(out, "%s%s", c ? "," : "", columns[c].symbol);
    batten_text_add(out, "\n");
    for (int c = 0; c < BAT_HYDRO_COLUMNS; c++) {
        batten_text_add(out, "%s", c ? "," : "");
        add_unit(r, columns[c].unit, out);
    }
    batten_text_add(out, "\n");
    for (int i = 0; i < r->count; i++)
        for (int c = 0; c < BAT_HYDRO_COLUMNS; c++) {
            bat_hydro_add_value(r->rows[i].values[c], "", out);
            batten_text_add(out, c + 1 < BAT_HYDRO_COLUMNS ? "," : "\n");
        }
    add_csv_sections(r, out);
    bat_hydro_stability_as_csv(r, out);
}

/* ---- JSON ---- */

static void add_json_numbers(int count, const double *numbers, batten_text *out)
{
    for (int k = 0; k < count; k++) {
        batten_text_add(out, "%s", k ? ", " : "[");
        bat_hydro_add_value(numbers[k], "null", out);
    }
    batten_text_add(out, "]");
}

/* The areas of each row of the table. */
static void add_json_sections(const bat_hydro_report *r, batten_text *out)
{
    batten_text_add(out, ",\n  \"sections\": {\n    \"x\": ");
    add_json_numbers(r->place_count, r->places, out);
    batten_text_add(out, ",\n    \"A\": [");
    for (int i = 0; i < r->count; i++) {
        batten_text_add(out, "%s\n      ", i ? "," : "");
        add_json_numbers(r->place_count, r->areas + (size_t)i * (size_t)r->place_count, out);
    }
    batten_text_add(out, "\n    ]\n  }");
}

static void add_json_lids(const bat_hydro_report *r, batten_text *out)
{
    batten_text_add(out, ",\n  \"lids\": [");
    for (int i = 0; i < r->lid_count; i++) {
        const batten_box *box = &r->lids[i].edge;
        batten_text_add(out, "%s\n    {\"x\": [", i ? "," : "");
        batten_text_number(out, box->low.x);
        batten_text_add(out, ", ");
        batten_text_number(out, box->high.x);
        batten_text_add(out, "], \"z\": [");
        batten_text_number(out, box->low.z);
        batten_text_add(out, ", ");
        batten_text_number(out, box->high.z);
        batten_text_add(out, "], \"area\": ");
        batten_text_number(out, r->lids[i].area);
        batten_text_add(out, "}");
    }
    batten_text_add(out, "\n  ]");
}

void bat_hydro_as_json(const bat_hydro_report *r, batten_text *out)
{
    batten_text_add(out, "{\n  \"unit\": \"%s\",\n  ", r->unit);
    bat_hydro_add_member("density", r->density, true, out);
    bat_hydro_add_member("trim", r->trim, false, out);
    bat_hydro_add_member("heel", r->heel, false, out);
    if (r->spacing > 0)
        bat_hydro_add_member("spacing", r->spacing, false, out);
    bat_hydro_add_member("L", r->length > 0 ? r->length : (double)NAN, false, out);
    batten_text_add(out, ",\n  \"rows\": [");
    for (int i = 0; i < r->count; i++) {
        batten_text_add(out, "%s\n    {", i ? "," : "");
        for (int c = 0; c < BAT_HYDRO_COLUMNS; c++)
            bat_hydro_add_member(columns[c].symbol, r->rows[i].values[c], c == 0, out);
        batten_text_add(out, "}");
    }
    batten_text_add(out, "\n  ]");
    add_json_sections(r, out);
    add_json_lids(r, out);
    bat_hydro_stability_as_json(r, out);
    batten_text_add(out, "\n}\n");
}
