/* The feature 'loft': a fair hull straight from its table of offsets. */
#include "base/arena.h"
#include "base/plural.h"
#include "design/features/surfaces/straight_runs.h"
#include "design/shared/place.h"

#include <batten/fair.h>
#include <stdio.h>

/* So many cuts with inflections in excess are named one by one. */
#define MOST_CUTS 10

static const batten_parameter parameters[] = {
    {"loft", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "a table of offsets"},
    {"within", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "the surface passes every point within this, in the plane of its station"},
    {"height", BATTEN_VALUE_LENGTH, false, false, "0", NULL,
     "bulges of sections up to this are not inflections; 0: a millionth of the breadth"},
    {"knuckles", BATTEN_VALUE_TEXT, true, false, NULL, NULL,
     "lines of the table at which the hull has an edge: chines, wales"},
    {"straight", BATTEN_VALUE_TEXT, true, false, NULL, NULL,
     "runs of its lines: 'chine from stem to 2', in both views or 'in plan', 'in profile'"},
};

/* " of panel 2", where there are several. */
static void name_panel(const batten_loft_report *found, int panel, size_t size, char *out)
{
    out[0] = 0;
    if (found->panel_count > 1)
        snprintf(out, size, " of panel %d", panel + 1);
}

static void note_cut(const bat_run *run, const batten_loft_report *found,
                     const batten_loft_cut *cut)
{
    static const char *const families[] = {
        "the station at x =",     "the waterline at z =",   "the buttock at y =",
        "the diagonal from z =",  "the profile from below", "the sheer",
        "the knuckle at the foot"};
    const bool edge = cut->family >= BATTEN_LOFT_PROFILE;
    char at[40] = "", panel[40];
    name_panel(found, cut->panel, sizeof panel, panel);
    if (!edge)
        batten_text_print(at, sizeof at, " %g", cut->at);
    bat_note(run, "%s%s%s has %d inflection%s where %d %s needed", families[cut->family], at,
             panel, cut->found, bat_plural(cut->found), cut->needed,
             bat_one_or_many(cut->needed, "is", "are"));
}

/* The first point given beyond the centre plane: there the surface crosses it. */
static void note_beyond(const bat_run *run, const batten_offset_table *table)
{
    for (int k = 0; k < batten_offset_table_station_count(table); k++) {
        const batten_table_station *s = batten_offset_table_station(table, k);
        for (int i = 0; i < s->point_count; i++)
            if (s->points[i].y < 0) {
                bat_note(run,
                         "point %d of %s is %g beyond the centre plane, which the surface "
                         "crosses there",
                         i + 1, batten_offset_table_label(table, k).text, -s->points[i].y);
                return;
            }
    }
}

/* Whether planks can be cut from sheet. */
static void remark_warps(const bat_run *run, const batten_loft_report *found)
{
    const double degree = BAT_PI / 180;
    for (int k = 0; k < found->warp_count; k++) {
        const batten_loft_warp *w = found->warps + k;
        bat_remark(run,
                   "between its lines panel %d has plates with a warp of %.2f degrees in the "
                   "median, %.2f in 90 of 100 rulings, at most %.2f from x = %.4g below to "
                   "x = %.4g above",
                   w->panel + 1, w->median / degree, w->most / degree, w->largest / degree,
                   w->at[0], w->at[1]);
    }
}

static void report_loft(const bat_run *run, const batten_loft_report *found)
{
    int named = 0;
    bat_remark(run,
               "%d of %d sections %s inflections in excess, of bulges above %.2g; the surface "
               "is at most %.4g from a point, %.4g in the mean",
               found->cuts_in_excess, found->cut_count,
               bat_one_or_many(found->cuts_in_excess, "has", "have"), found->height,
               found->max_move, found->rms_move);
    for (int k = 0; k < found->cut_count && named < MOST_CUTS; k++)
        if (found->cuts[k].found > found->cuts[k].needed) {
            note_cut(run, found, found->cuts + k);
            named++;
        }
    if (found->cuts_in_excess > named)
        bat_note(run, "%d more section%s %s inflections in excess",
                 found->cuts_in_excess - named, bat_plural(found->cuts_in_excess - named),
                 bat_one_or_many(found->cuts_in_excess - named, "has", "have"));
    if (found->trimmed_count > 0)
        bat_note(run, "%d point%s on the centre plane where there is no hull %s left out",
                 found->trimmed_count, bat_plural(found->trimmed_count),
                 bat_one_or_many(found->trimmed_count, "was", "were"));
    if (found->panel_count > 1)
        bat_note(run, "%d panels from the keel up, %d of them straight across",
                 found->panel_count, found->ruled_count);
    remark_warps(run, found);
}

/* The names of an argument; in the arena, which the caller frees. */
static batten_status take_knuckles(const bat_run *run, bat_arena *arena,
                                   batten_loft_options *options)
{
    const bat_argument *names = bat_argument_of(run, "knuckles");
    const char **knuckles = bat_arena_array(arena, (size_t)names->count, sizeof *knuckles);
    if (!knuckles)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < names->count; k++)
        knuckles[k] = names->items[k].text;
    options->knuckle_count = names->count;
    options->knuckles = knuckles;
    return BATTEN_OK;
}

/* One surface has the name of the feature; several are numbered from 1, from below. */
static batten_status put_panels(bat_run *run, batten_status status, int count,
                                batten_surface *const *surfaces)
{
    for (int k = 0; k < count; k++) {
        char name[220];
        batten_object like = {.name = run->name, .layer = ""};
        if (count > 1) {
            snprintf(name, sizeof name, "%.200s %d", run->name, k + 1);
            like.name = name;
        }
        status = bat_put_surface_like(run, status, surfaces[k], &like);
    }
    return status;
}

static batten_status loft_table(bat_run *run, const batten_offset_table *table,
                                bat_arena *arena)
{
    batten_loft_options options = batten_loft_defaults(bat_number(run, "within"));
    options.height = bat_number(run, "height");
    batten_status status = take_knuckles(run, arena, &options);
    const int count = options.knuckle_count + 1;
    batten_surface **surfaces = bat_arena_array(arena, (size_t)count, sizeof *surfaces);
    if (status != BATTEN_OK || !surfaces)
        return BATTEN_OUT_OF_MEMORY;
    status = bat_take_straight_runs(run, table, arena, &options);
    if (status == BATTEN_OK)
        status = bat_expect(run, count);
    if (status == BATTEN_OK)
        status = batten_hull_loft(table, &options, run->job, &run->result->loft, surfaces);
    if (status == BATTEN_OK)
        note_beyond(run, table);
    return status == BATTEN_OK ? put_panels(run, status, count, surfaces) : status;
}

static batten_status run_loft(bat_run *run)
{
    bat_objects objects;
    bat_arena arena = {0};
    const batten_loft_report *found = &run->result->loft;
    batten_status status = bat_gather(run, "loft", BAT_OFFSETS, &objects);
    if (status != BATTEN_OK)
        return status;
    if (objects.count > 1)
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          "one table of offsets is lofted at a time, not %d", objects.count);
    if (status == BATTEN_OK)
        status = loft_table(run, objects.at[0]->offset_table, &arena);
    bat_objects_release(&objects);
    bat_arena_free(&arena);
    if (status == BATTEN_OK) {
        report_loft(run, found);
        run->result->shown.loft = found;
        bat_report_error(run, found->max_move, found->rms_move);
    }
    return status;
}

const bat_feature bat_feature_loft = {
    .shown =
        {"loft", "A fair hull straight from its table of offsets",
         "The control points of one surface are found by convex programs: of all surfaces that pass\n"
         "every point within the bound, the one that changes least between the points, and whose\n"
         "stations, waterlines, buttocks, diagonals and edges have no more inflections than the\n"
         "points require. Profile and stem stay on the centre plane, and the surface does not cross\n"
         "it by a hundredth of the bound where no point given does. A note names each section that\n"
         "has inflections in excess all the same, and a bound that no surface can keep is refused\n"
         "with one that can be kept.\n\n"
         "The table describes one half: stations in order, points from the profile to the sheer.\n"
         "Half-breadths on waterlines that meet only some of the stations are lofted as one function\n"
         "over the profile plane. A 0, or a blank below the hull, then says that no hull is there and not\n"
         "where it begins: stem, stern, keel and sheer are found between the points and made fair within\n"
         "what the bound leaves open. Where the ends of the table are not 0 the hull ends with it.\n"
         "Where the hull has an edge, name its line in 'knuckles'; a chine that is not named is\n"
         "refused, with the name of its line. Profile, knuckles and sheer are then made fair first,\n"
         "each in space; they bound panels, numbered from the keel up, that share their lines point\n"
         "for point. A panel with nothing between its lines is straight across; others are found as\n"
         "above, with their edges held. Where a line is straight by intent, as many a chine towards the\n"
         "stem, say so in 'straight': the name of the line, or 'profile' or 'sheer', and the names of two\n"
         "stations. It is then straight there to the last digit, and its points keep the bound; 'in plan'\n"
         "and 'in profile' ask for the view from above or from the side alone.\n\n"
         "The output 'corrections' lists which points of the table moved, how far and why, and\n"
         "'faired-table' makes the table that the surface has.",
         "features:\n"
         "  table: {read: offsets.csv}\n"
         "  hull: {loft: table, within: 3 mm}\n"
         "  boat: {read: sharpie.csv, lines: [bottom, chine, sheer]}\n"
         "  planks: {loft: boat, within: 3 mm, knuckles: chine}\n"
         "  barge: {loft: boat, within: 3 mm, knuckles: chine, straight: chine from 5 to 6}\n",
         "[SL section VII.3] [EH95] [NW06]", "batten_hull_loft", BAT_PARAMETERS(parameters),
         false,
         .also =
             "lofting, fair hull, hull surface, table of offsets, lines fairing, convex program, ship hull, mould loft, "
             "hard chine, knuckle, plank, strake, plywood hull, straight run, parallel middle body",
         .formula =
             "    Σ (d_k / within)² + λ Σ_a C(3, a) ∫∫ |∂³S / ∂u^a ∂v^(3−a)|² du dv → minimum,  |d_k| ≤ within,\n"
             "    σ II(T, T) ≥ 0 along sections, σ = ±1 with as many changes as the points require;\n"
             "    of lines: Σ (d_k / w)² + λ ∫ f‴(u)² du → minimum,  |d_k| ≤ w = within / √2 in y and in z",
         .promise =
             "No point is farther than the bound, in the plane of its station; inflections are counted on the surface; "
             "panels have the same control points on the line between them; f″ = 0 but for rounding on straight runs."},
    .run = run_loft};
