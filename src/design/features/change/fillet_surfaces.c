/* The feature 'fillet-surfaces': the surface that a rolling ball leaves between two
 * surfaces. */
#include "base/plural.h"
#include "design/feature.h"

#include <batten/blend.h>
#include <stdio.h>

typedef enum { LEFT, RIGHT } side;

static const batten_parameter parameters[] = {
    {"fillet-surfaces", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "two surfaces"},
    {"radius", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "of the ball"},
    {"sides", BATTEN_VALUE_WORD, true, false, "left", "left right",
     "on which side of either surface it rolls; left is where the normal points"},
    {"start", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "u and v on the first surface, on the second: where the ball is sought"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far from the true fillet; a tenth of the tolerance of the design by default"},
    {"contacts", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the curves along which the ball touches, too"},
};

static batten_status roll(const bat_run *run, const bat_objects *all,
                          batten_surface_fillet *out)
{
    const bat_argument *sides = bat_argument_of(run, "sides");
    const bat_argument *start = bat_argument_of(run, "start");
    double radii[2], from[4];
    if (all->count != 2)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "two surfaces are needed, there are %d",
                        all->count);
    if (sides->count > 2 || (start->count != 0 && start->count != 4))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d 'sides' and %d numbers of 'start' are given; there are two sides, "
                        "and four numbers",
                        sides->count, start->count);
    for (int i = 0; i < start->count; i++)
        from[i] = start->items[i].number[0];
    for (int k = 0; k < 2; k++) {
        const int where = sides->items[sides->count == 2 ? k : 0].count;
        radii[k] = (where == RIGHT ? -1 : 1) * bat_number(run, "radius");
    }
    const batten_surface *const pair[2] = {all->at[0]->surface, all->at[1]->surface};
    return batten_surfaces_fillet(
        pair, radii, start->count ? from : NULL,
        bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run) / 10, out);
}

static void report_fillet_surfaces(const bat_run *run, const batten_surface_fillet *fillet)
{
    static const char *const ends[] = {"at a border of the first surface",
                                       "at a border of the second surface",
                                       "where the ball finds no place", "where it began"};
    const double degrees = 180 / 3.14159265358979323846;
    bat_remark(run, "arcs of %.4g to %.4g degree%s; it ends %s, and %s",
               fillet->least * degrees, fillet->most * degrees,
               bat_plural_real(fillet->most * degrees, 4), ends[fillet->ends[0]],
               ends[fillet->ends[1]]);
}

static batten_status run_fillet_surfaces(bat_run *run)
{
    bat_objects all;
    batten_surface_fillet fillet = {0};
    batten_status status = bat_gather(run, "fillet-surfaces", BAT_SURFACES, &all);
    if (status != BATTEN_OK)
        return status;
    status = roll(run, &all, &fillet);
    bat_objects_release(&all);
    if (status != BATTEN_OK)
        return status;
    report_fillet_surfaces(run, &fillet);
    bat_report_error(run, fillet.error, fillet.error);
    status = bat_put_surface(run, status, batten_surface_ref(fillet.surface));
    for (int k = 0; k < 2 && bat_yes(run, "contacts") && status == BATTEN_OK; k++)
        status = bat_put_curve(run, status, batten_curve_ref(fillet.contacts[k]));
    batten_surface_fillet_release(&fillet);
    return status;
}

const bat_feature bat_feature_fillet_surfaces = {
    .shown =
        {"fillet-surfaces", "The surface that a rolling ball leaves between two surfaces",
         "A ball of this radius rolls along both surfaces, touching both, until it reaches a\n"
         "border; the arcs between its contacts make the fillet, tangent to both surfaces.\n"
         "Sections are exact arcs, and the spline through them is 'within' its tolerance. The\n"
         "surfaces need not meet. A ball larger than a hollow is refused, and the message says\n"
         "where. The surfaces stay as they are.",
         "features:\n"
         "  deck: {bilinear: [[0, 0, 0], [4 m, 0, 0], [4 m, 3 m, 0], [0, 3 m, 0]]}\n"
         "  wall: {bilinear: [[0, 0, 0], [0.5 m, 0, 2 m], [0.5 m, 3 m, 2 m], [0, 3 m, 0]]}\n"
         "  cove: {fillet-surfaces: [deck, wall], radius: 0.3 m, sides: [left, right]}\n",
         "[PM02]", "batten_surfaces_fillet", BAT_PARAMETERS(parameters), false,
         .also = "rolling ball, rounding, blend between surfaces, constant radius fillet"},
    .run = run_fillet_surfaces,
    .displacing = "fillet-surfaces"};
