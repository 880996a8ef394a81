/* The feature 'loft': a fair hull straight from its table of offsets. */
#include "base/plural.h"
#include "design/shared/place.h"

#include <batten/fair.h>

/* So many cuts with inflections in excess are named one by one. */
#define MOST_CUTS 10

static const batten_parameter parameters[] = {
    {"loft", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "a table of offsets"},
    {"within", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "the surface passes every point within this, in the plane of its station"},
    {"height", BATTEN_VALUE_LENGTH, false, false, "0", NULL,
     "bulges of sections up to this are not inflections; 0: a millionth of the breadth"},
};

static void note_cut(const bat_run *run, const batten_loft_cut *cut)
{
    static const char *const families[] = {
        "the station at x =",    "the waterline at z =",   "the buttock at y =",
        "the diagonal from z =", "the profile from below", "the sheer"};
    const bool edge = cut->family == BATTEN_LOFT_PROFILE || cut->family == BATTEN_LOFT_SHEER;
    if (edge)
        bat_note(run, "%s has %d inflection%s where %d %s needed", families[cut->family],
                 cut->found, bat_plural(cut->found), cut->needed,
                 bat_one_or_many(cut->needed, "is", "are"));
    else
        bat_note(run, "%s %g has %d inflection%s where %d %s needed", families[cut->family],
                 cut->at, cut->found, bat_plural(cut->found), cut->needed,
                 bat_one_or_many(cut->needed, "is", "are"));
}

static void report_loft(const bat_run *run, const batten_loft_report *found)
{
    int named = 0;
    bat_remark(
        run,
        "%d of %d sections have inflections in excess, of bulges above %.2g; the surface "
        "is at most %.4g from a point, %.4g in the mean",
        found->cuts_in_excess, found->cut_count, found->height, found->max_move,
        found->rms_move);
    for (int k = 0; k < found->cut_count && named < MOST_CUTS; k++)
        if (found->cuts[k].found > found->cuts[k].needed) {
            note_cut(run, found->cuts + k);
            named++;
        }
    if (found->cuts_in_excess > named)
        bat_note(run, "%d more sections have inflections in excess",
                 found->cuts_in_excess - named);
    if (found->trimmed_count > 0)
        bat_note(run, "%d point%s on the centre plane below the hull %s left out",
                 found->trimmed_count, bat_plural(found->trimmed_count),
                 bat_one_or_many(found->trimmed_count, "was", "were"));
}

static batten_status run_loft(bat_run *run)
{
    bat_objects objects;
    batten_surface *surface = NULL;
    batten_loft_report *found = &run->result->loft;
    batten_status status = bat_gather(run, "loft", BAT_OFFSETS, &objects);
    if (status != BATTEN_OK)
        return status;
    batten_loft_options options = batten_loft_defaults(bat_number(run, "within"));
    options.height = bat_number(run, "height");
    if (objects.count > 1)
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          "one table of offsets is lofted at a time, not %d", objects.count);
    if (status == BATTEN_OK)
        status = batten_surface_loft(objects.at[0]->offset_table, &options, run->job, found,
                                     &surface);
    bat_objects_release(&objects);
    status = bat_put_surface(run, status, surface);
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
         "The control points of one surface are found by convex programs: of all surfaces that\n"
         "pass every point within the bound, the one that changes least between the points, and\n"
         "whose stations, waterlines, buttocks, diagonals and edges have no more inflections than\n"
         "the points require. Profile and stem stay on the centre plane, and the surface does not\n"
         "cross it. A note names each section that has inflections in excess all the same, and a\n"
         "bound that no surface can keep is refused with one that can be kept.\n\n"
         "The table describes one half: stations in order, points from the profile to the sheer.\n"
         "One surface has no knuckles: tables of hulls with chines are refused.",
         "features:\n"
         "  table: {read: offsets.csv}\n"
         "  hull: {loft: table, within: 3 mm}\n",
         "[SL section VII.3] [EH95] [NW06]", "batten_surface_loft", BAT_PARAMETERS(parameters),
         false,
         .also =
             "lofting, fair hull, hull surface, table of offsets, lines fairing, convex program, ship hull, mould loft",
         .formula =
             "    Σ (d_k / within)² + λ Σ_a C(3, a) ∫∫ |∂³S / ∂u^a ∂v^(3−a)|² du dv → minimum,  |d_k| ≤ within,\n"
             "    σ II(T, T) ≥ 0 along sections, σ = ±1 with as many changes as the points require",
         .promise =
             "No point is farther than the bound, in the plane of its station; inflections are counted on the surface."},
    .run = run_loft};
