/* The output 'hydrostatics': how a hull floats, as a table by draughts, and its righting arms. */
#include "design/outputs/hydrostatics.h"
#include "base/plural.h"

#include <string.h>

/* The water may lack this share of the wetted surface to be kept out. */
static const double OPEN = 1e-6;

static const batten_parameter parameters[] = {
    {"hydrostatics", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "the surfaces of the hull: of one half of it, or of both"},
    {"draughts", BATTEN_VALUE_LENGTH, true, false, NULL, NULL,
     "heights of the water above z = 0, at x = y = 0; else round ones up to the deck"},
    {"trim", BATTEN_VALUE_ANGLE, false, false, "0 deg", NULL,
     "of the table; above 0 the water rises towards lower x, the stern"},
    {"heel", BATTEN_VALUE_ANGLE, false, false, "0 deg", NULL,
     "of the table; above 0 starboard, y < 0, goes down"},
    {"density", BATTEN_VALUE_NUMBER, false, false, "1.025", NULL,
     "of the water, t/m3; 1 for fresh water"},
    {"stations", BATTEN_VALUE_LENGTH, true, false, NULL, NULL,
     "x of the sections whose areas are listed; else 21 from end to end"},
    {"length", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "between perpendiculars, for the coefficients; else that of each waterline"},
    {"whole", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "each surface is a hull that is closed by itself"},
    {"spacing", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "of a catamaran, of which one hull is given about y = 0: between the centre planes of both"},
    {"mass", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,
     "of the ship and what it carries, tonnes: how it floats then, and its righting arms"},
    {"gravity", BATTEN_VALUE_POINT, false, false, NULL, NULL, "the centre of this mass"},
    {"heels", BATTEN_VALUE_ANGLE, true, false, NULL, NULL,
     "of the righting arms and cross curves, free to trim; else 0 to 90 degrees"},
    {"displacements", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "tonnes: those of cross curves KN"},
    {"openings", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "through which it floods, each on both sides: the heel at which the first comes to the water"},
};

/* ---- the table ---- */

static double share(double a, double b)
{
    return b > 0 ? a / b : (double)NAN;
}

/* In coefficients: of a catamaran that of both hulls, which is known where the water lies level across. */
static double breadth_of(const bat_hydro *h, const double *values)
{
    const double over_all = values[BAT_HYDRO_BREADTH], spacing = h->report.spacing;
    if (!(spacing > 0))
        return over_all;
    return h->report.heel == 0 ? 2 * bat_max(0, over_all - spacing) : (double)NAN;
}

static void fill_row(const bat_hydro *h, const batten_hydrostatics *v, double length,
                     double *values)
{
    const double cubic = h->metres * h->metres * h->metres, density = h->report.density;
    const double draught = values[BAT_HYDRO_T], breadth = breadth_of(h, values);
    const bool wet = v->volume > 0;
    values[BAT_HYDRO_VOLUME] = v->volume;
    values[BAT_HYDRO_DISPLACEMENT] = density * v->volume * cubic;
    values[BAT_HYDRO_WATERPLANE] = v->waterplane;
    values[BAT_HYDRO_WETTED] = v->wetted;
    values[BAT_HYDRO_LCB] = wet ? bat_hydro_without_dust(h, v->buoyancy.x) : (double)NAN;
    values[BAT_HYDRO_TCB] = wet ? bat_hydro_without_dust(h, v->buoyancy.y) : (double)NAN;
    values[BAT_HYDRO_VCB] = wet ? v->buoyancy.z : (double)NAN;
    values[BAT_HYDRO_LCF] =
        v->waterplane > 0 ? bat_hydro_without_dust(h, v->flotation.x) : (double)NAN;
    values[BAT_HYDRO_ACROSS] = v->across;
    values[BAT_HYDRO_ALONG] = v->along;
    values[BAT_HYDRO_BMT] = share(v->across, v->volume);
    values[BAT_HYDRO_BML] = share(v->along, v->volume);
    values[BAT_HYDRO_KMT] = values[BAT_HYDRO_VCB] + values[BAT_HYDRO_BMT];
    values[BAT_HYDRO_KML] = values[BAT_HYDRO_VCB] + values[BAT_HYDRO_BML];
    values[BAT_HYDRO_TPC] = density * v->waterplane * h->metres * h->metres / 100;
    values[BAT_HYDRO_MCT] =
        share(density * v->along * cubic * h->metres, 100 * length * h->metres);
    values[BAT_HYDRO_CB] = share(v->volume, length * breadth * draught);
    values[BAT_HYDRO_CWP] = share(v->waterplane, length * breadth);
    values[BAT_HYDRO_CVP] = share(v->volume, v->waterplane * draught);
}

/* What the water finds open is an error of the model, not a number to be printed. */
static batten_status check_closed(const batten_hydrostatics *v, double draught)
{
    const double open = bat_max(v->open[0], v->open[1]);
    if (open <= OPEN * (v->wetted + v->lids))
        return BATTEN_OK;
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "at the draught %.6g the hull is open below the water: %.3g of its area is "
                    "missing; give all of its surfaces, or one half without 'whole'",
                    draught, open);
}

static void note_deck(const bat_hydro *h, const batten_flotation *at)
{
    double freeboard;
    batten_vec3 place;
    if (batten_hull_freeboard(h->hull, at, &freeboard, &place) != BATTEN_OK ||
        bat_hydro_without_dust(h, freeboard) >= 0)
        return;
    bat_note(h->run,
             "at the draught %.6g the edge of the deck is under water: by up to %.6g, at "
             "(%.6g, %.6g, %.6g)",
             at->draught, -freeboard, place.x, place.y, place.z);
}

static batten_status add_row(bat_hydro *h, double draught, bat_hydro_row *row, double *areas)
{
    const batten_flotation at = {draught, bat_number(h->run, "trim"),
                                 bat_number(h->run, "heel")};
    const batten_box box = batten_hull_box(h->hull);
    const double size = bat_max(box.high.x - box.low.x, box.high.y - box.low.y);
    batten_hydrostatics v;
    batten_interval along, across;
    batten_status status =
        batten_hull_hydrostatics(h->hull, &at, BAT_HYDRO_PRECISION, h->run->job, &v);
    if (status == BATTEN_OK)
        status = check_closed(&v, draught);
    if (status == BATTEN_OK)
        status =
            batten_hull_waterline(h->hull, &at, BAT_HYDRO_PRECISION * size, &along, &across);
    if (status != BATTEN_OK)
        return status;
    note_deck(h, &at);
    row->values[BAT_HYDRO_T] = draught;
    row->values[BAT_HYDRO_LENGTH] = along.b - along.a;
    row->values[BAT_HYDRO_BREADTH] = across.b - across.a;
    const double length = h->report.length > 0 ? h->report.length : along.b - along.a;
    int lost = 0;
    const bat_hydro_water water = {h->hull, h->run->job, at, length, breadth_of(h, row->values),
                                   &lost};
    fill_row(h, &v, length, row->values);
    status = bat_hydro_fill_sections(&water, h->report.place_count, h->report.places, areas,
                                     row->values);
    if (lost > 0)
        bat_note(
            h->run,
            "at the draught %.6g %d area%s of sections %s not found within 1e-8 of breadth "
            "times depth, as where sections touch a surface: AX is the largest of the others",
            draught, lost, bat_plural(lost), lost == 1 ? "was" : "were");
    return status;
}

/* Those that are given, else round ones. */
static batten_status list_draughts(bat_hydro *h, double **draughts)
{
    const bat_argument *given = bat_argument_of(h->run, "draughts");
    double round[BAT_HYDRO_DRAUGHTS];
    int count = given->count;
    if (count == 0) {
        const batten_status status = bat_hydro_round_draughts(h->hull, round, &count);
        if (status != BATTEN_OK)
            return status;
    }
    *draughts = bat_arena_array(&h->arena, (size_t)count, sizeof **draughts);
    if (!*draughts)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++)
        (*draughts)[i] = given->count > 0 ? given->items[i].number[0] : round[i];
    h->report.count = count;
    return BATTEN_OK;
}

/* Those that are given, else from end to end. */
static batten_status list_places(bat_hydro *h)
{
    const bat_argument *given = bat_argument_of(h->run, "stations");
    bat_hydro_report *r = &h->report;
    r->place_count = given->count > 0 ? given->count : BAT_HYDRO_PLACES;
    r->places = bat_arena_array(&h->arena, (size_t)r->place_count, sizeof *r->places);
    if (!r->places)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < r->place_count; i++)
        r->places[i] =
            given->count > 0 ? given->items[i].number[0] : bat_hydro_place(h->hull, i);
    return BATTEN_OK;
}

static batten_status fill_table(bat_hydro *h)
{
    double *draughts = NULL;
    bat_hydro_report *r = &h->report;
    batten_status status = list_draughts(h, &draughts);
    if (status == BATTEN_OK)
        status = list_places(h);
    if (status != BATTEN_OK)
        return status;
    const size_t rows = (size_t)r->count, places = (size_t)r->place_count;
    r->rows = bat_arena_array(&h->arena, rows, sizeof *r->rows);
    r->areas = bat_arena_array(&h->arena, rows, places * sizeof *r->areas);
    if (!r->rows || !r->areas)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < rows; i++)
        status = add_row(h, draughts[i], &r->rows[i], r->areas + i * places);
    return status;
}

/* ---- the output ---- */

static batten_status check_numbers(const bat_run *run)
{
    const double density = bat_number(run, "density");
    if (!(density > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the density is %g t/m3; it must be above 0",
                        density);
    if (bat_has(run, "mass") && !(bat_number(run, "mass") > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the mass is %g t; it must be above 0",
                        bat_number(run, "mass"));
    if (bat_has(run, "spacing") && !(bat_number(run, "spacing") > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the hulls of a catamaran are %g apart; it must be above 0",
                        bat_number(run, "spacing"));
    if (bat_has(run, "length") && !(bat_number(run, "length") > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the length between perpendiculars is %g; it must be above 0",
                        bat_number(run, "length"));
    return BATTEN_OK;
}

/* A catamaran of the hull that was given. */
static batten_status double_hull(bat_hydro *h)
{
    batten_hull *twin = NULL;
    const batten_status status = batten_hull_twin(h->hull, h->report.spacing, &twin);
    if (status == BATTEN_OK) {
        batten_hull_free(h->hull);
        h->hull = twin;
    }
    return status;
}

static batten_status make_hull(bat_hydro *h)
{
    bat_objects objects;
    batten_hull_options options = batten_hull_defaults();
    options.whole = bat_yes(h->run, "whole");
    options.tolerance = bat_tolerance(h->run);
    batten_status status = bat_gather(h->run, "hydrostatics", BAT_SURFACES, &objects);
    if (status != BATTEN_OK)
        return status;
    const batten_surface **surfaces =
        bat_arena_array(&h->arena, (size_t)objects.count, sizeof(batten_surface *));
    if (!surfaces)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; surfaces && i < objects.count; i++)
        surfaces[i] = objects.at[i]->surface;
    if (status == BATTEN_OK)
        status = batten_hull_create(objects.count, surfaces, &options, &h->hull);
    bat_objects_release(&objects);
    return status == BATTEN_OK && h->report.spacing > 0 ? double_hull(h) : status;
}

static void note_hull(const bat_hydro *h)
{
    int count;
    const batten_box box = batten_hull_box(h->hull);
    if (box.low.z < -bat_tolerance(h->run))
        bat_remark(h->run,
                   "the hull reaches to z = %.6g, below the baseline z = 0 from which draughts "
                   "count, also in the coefficients",
                   box.low.z);
    const batten_hull_lid *lids = batten_hull_lids(h->hull, &count);
    for (int i = 0; i < count; i++)
        bat_remark(
            h->run, "the hull is closed across from the edge at x %.6g to %.6g, z %.6g to %.6g",
            lids[i].edge.low.x, lids[i].edge.high.x, lids[i].edge.low.z, lids[i].edge.high.z);
}

static batten_status write_report(const bat_hydro *h)
{
    const char *dot = strrchr(h->run->name, '.');
    batten_text text = BATTEN_TEXT;
    (dot && strcmp(dot, ".json") == 0  ? bat_hydro_as_json
     : dot && strcmp(dot, ".csv") == 0 ? bat_hydro_as_csv
                                       : bat_hydro_as_text)(&h->report, &text);
    const batten_status status = batten_text_take(&text, &h->run->data, &h->run->size);
    batten_text_free(&text);
    return status;
}

/* What the parameters ask for beside the table. */
static batten_status float_hull(bat_hydro *h)
{
    const batten_box box = batten_hull_box(h->hull);
    batten_flotation near = {0.5 * (box.low.z + box.high.z), 0, 0};
    h->near = &near;
    batten_status status = bat_hydro_float(h);
    if (status == BATTEN_OK && h->report.mass > 0)
        status = bat_hydro_measure(h);
    h->near = NULL;
    return status;
}

static batten_status run_hydrostatics(bat_run *run)
{
    bat_hydro h = {.run = run, .metres = bat_unit_metres(run)};
    h.report = (bat_hydro_report){
        .unit = *bat_unit_name(run) ? bat_unit_name(run) : "units",
        .density = bat_number(run, "density"),
        .trim = bat_number(run, "trim") * 180 / BAT_PI,
        .heel = bat_number(run, "heel") * 180 / BAT_PI,
        .length = bat_has(run, "length") ? bat_number(run, "length") : 0,
        .spacing = bat_has(run, "spacing") ? bat_number(run, "spacing") : 0,
    };
    batten_status status = check_numbers(run);
    if (status == BATTEN_OK)
        status = make_hull(&h);
    if (status == BATTEN_OK) {
        note_hull(&h);
        h.report.lids = batten_hull_lids(h.hull, &h.report.lid_count);
        status = fill_table(&h);
    }
    if (status == BATTEN_OK)
        status = float_hull(&h);
    if (status == BATTEN_OK)
        status = write_report(&h);
    batten_hull_free(h.hull);
    bat_arena_free(&h.arena);
    return status;
}

const bat_feature bat_feature_hydrostatics = {
    .shown =
        {"hydrostatics",
         "A report: displacement, centres, metacentres and righting arms of a hull",
         "For each draught volume and displacement, the waterline's length and breadth, areas,\n"
         "centres of buoyancy and flotation, second moments, metacentres, coefficients of form, and\n"
         "the areas of sections across x: curves of sectional areas, or Bonjean's along a station.\n"
         "For a mass and its centre how the hull floats, its righting arms GZ at fixed heels, free to\n"
         "trim, with the freeboard there, and their measures: GM, the largest arm, the range, areas\n"
         "below the curve from 0 to 30, 0 to 40 and 30 to 40 degrees (40: or the heel at which the\n"
         "first of 'openings' floods), the heel at which the deck is immersed. These are measures to\n"
         "be held against a rule, no verdict. For 'displacements' cross curves: KN = GZ for a mass\n"
         "at z = 0 and the x of 'gravity', else of the level hull's centre of buoyancy. Water is\n"
         "what lies below a plane, so all of it holds for any trim and heel.\n\n"
         "The surfaces are one half of the hull, or both when they are images of each other in the\n"
         "centre plane. Edges off the centre plane that no other surface shares are closed by\n"
         "straight lines across, as transoms, decks and flat bottoms are, and a remark names each.\n"
         "A catamaran is given by one of its hulls, about y = 0, and 'spacing'; a hull whose inner\n"
         "sides or upper faces are surfaces of their own is refused. x runs along the ship, z up\n"
         "from the baseline. As JSON when the file ends in .json; tables (CSV) when it ends in .csv;\n"
         "else text with conventions and names.",
         "features:\n"
         "  table: {read: offsets.csv}\n"
         "  hull: {loft: table, within: 3 mm}\n"
         "outputs:\n"
         "  hull.txt: {hydrostatics: hull, draughts: [0.2 m, 0.3 m, 0.4 m]}\n",
         "[RT01]", "batten_hull_hydrostatics", BAT_PARAMETERS(parameters), true,
         .also =
             "displacement, curves of form, metacentre, KM, GM, GZ curve, righting arm, stability, centre of buoyancy, waterplane, block coefficient, cross curves, KN, draught, trim, heel, wetted surface, sectional area curve, Bonjean curves, prismatic coefficient, midship section, catamaran, multihull, demihull, downflooding, deck immersion, freeboard, dynamic stability, area under GZ, range of stability, IMO criteria",
         .formula =
             "    V = ∫ h n·N,  M = ∫ (P h − n h²/2) n·N,  A = −∫ n·N,  over the wet surface; h the height above the water,\n"
             "    n up, N outwards. GZ = (B − G)·e, e across towards the side that is down",
         .promise =
             "Volume, centres and moments are integrated to 1e-9 of their size in each patch, areas of sections to 1e-8 of breadth times depth, at any heel and trim, on the surfaces that are given. Areas below GZ say their error."},
    .run = run_hydrostatics};
