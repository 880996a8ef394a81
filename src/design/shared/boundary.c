/* The curves around a patch, and the surfaces beside it, as its features take them. */
#include "design/shared/boundary.h"
#include "base/plural.h"

#include <batten/curvature.h>

static batten_status counts_of(const bat_run *run, int counts[4], const int **out)
{
    const bat_argument *given = bat_argument_of(run, "sides");
    *out = NULL;
    if (given->count == 0)
        return BATTEN_OK;
    if (given->count != 4)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'sides' has %d counts, not 4", given->count);
    for (int i = 0; i < 4; i++)
        counts[i] = given->items[i].count;
    *out = counts;
    return BATTEN_OK;
}

static void set_side(bat_boundary *boundary, int e)
{
    boundary->sides[e] =
        (batten_ribbon){boundary->curves[e][0], boundary->curves[e][1], boundary->curves[e][2]};
}

/* Which curves run against the loop. */
static void tell_reversed(bat_run *run, const bat_objects *objects,
                          const batten_loop_place *places)
{
    for (int i = 0; i < objects->count; i++)
        if (places[i].reversed)
            bat_remark(run, "'%s' runs against the first curve and is reversed",
                       objects->at[places[i].curve]->name);
}

static void remark_standstills(const bat_run *run, int side, const batten_parameters *at)
{
    for (int i = 0; i < at->count; i++)
        /* Within a millionth of an end it is the end that stands still: a pole, which is
         * allowed. */
        if (at->at[i] > 1e-6 && at->at[i] < 1 - 1e-6)
            bat_remark(run,
                       "side %d stands still at %.4g of its parameter; the normal there is "
                       "a limit",
                       side, at->at[i]);
}

static void note_facing(const bat_run *run, int side, const batten_parameters *at,
                        const batten_parameters *beyond)
{
    for (int i = 0; i < at->count; i++)
        for (int j = 0; j < beyond->count; j++)
            /* Inside, and at the same parameter to a millionth of the side. */
            if (at->at[i] > 1e-6 && at->at[i] < 1 - 1e-6 &&
                fabs(at->at[i] - beyond->at[j]) < 1e-6)
                bat_note(run,
                         "the corners of sides %d and %d at %.4g of their parameters face "
                         "each other; the surface may fold between them",
                         side, side + 2, at->at[i]);
}

/* Corners inside a side that is smooth for its parameter, and pairs of them that face each
 * other. */
static batten_status tell_corners(bat_run *run, const bat_boundary *boundary)
{
    batten_parameters at[4] = {{0, NULL}, {0, NULL}, {0, NULL}, {0, NULL}};
    batten_status status = BATTEN_OK;
    for (int e = 0; status == BATTEN_OK && e < 4; e++) {
        const batten_box box = batten_curve_box(boundary->curves[e][0]);
        if (box.low.x == box.high.x && box.low.y == box.high.y && box.low.z == box.high.z)
            continue;
        status = batten_curve_standstills(boundary->curves[e][0], &at[e]);
        if (status == BATTEN_OK)
            remark_standstills(run, e + 1, &at[e]);
    }
    for (int e = 0; status == BATTEN_OK && e < 2; e++)
        note_facing(run, e + 1, &at[e], &at[e + 2]);
    for (int e = 0; e < 4; e++)
        bat_release(at[e].at);
    return status;
}

/* Which sides are one curve each, and which of these run against their curve. `parts`: the curves
 * of each side; NULL for one each. */
static void find_lone_curves(int count, const batten_loop_place *places, const int *parts,
                             bat_boundary *out)
{
    out->curve_count = count;
    for (int e = 0, at = 0; e < 4; e++) {
        const int here = parts ? parts[e] : at < count;
        out->alone[e] = here == 1 ? places[at].curve : -1;
        /* V1 and U0 run against the loop. */
        out->against[e] =
            here == 1 && places[at].reversed != (e == BATTEN_EDGE_V1 || e == BATTEN_EDGE_U0);
        at += here;
    }
}

batten_status bat_boundary_take(bat_run *run, const char *parameter, double tolerance,
                                bat_boundary *out)
{
    bat_objects objects;
    int counts[4];
    const int *parts = NULL;
    batten_curve *sides[4] = {NULL};
    batten_status status = bat_gather(run, parameter, BAT_CURVES, &objects);
    if (status != BATTEN_OK)
        return status;
    batten_curve **curves = bat_array((size_t)objects.count, sizeof *curves);
    batten_loop_place *places = bat_array((size_t)objects.count, sizeof *places);
    status = curves && places ? counts_of(run, counts, &parts) : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < objects.count; i++)
        status = batten_curve_to_dimension(objects.at[i]->curve, 3, &curves[i]);
    if (status == BATTEN_OK)
        status = batten_boundary_sides(objects.count, (const batten_curve *const *)curves,
                                       parts, tolerance, places, sides);
    for (int e = 0; status == BATTEN_OK && e < 4; e++) {
        out->curves[e][0] = sides[e];
        set_side(out, e);
    }
    if (status == BATTEN_OK) {
        tell_reversed(run, &objects, places);
        find_lone_curves(objects.count, places, parts, out);
        status = tell_corners(run, out);
    }
    for (int i = 0; curves && i < objects.count; i++)
        batten_curve_unref(curves[i]);
    bat_release(places);
    bat_release(curves);
    bat_objects_release(&objects);
    return status;
}

/* ---- slopes as they are given ---- */

/* Of the side that is the given curve alone. */
static batten_status set_slope(const batten_object *slope, int curve, bat_boundary *boundary)
{
    int e = 0;
    while (e < 4 && boundary->alone[e] != curve)
        e++;
    if (e == 4)
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "'%s' is the slope of curve %d, which shares its side with others: join "
            "them first",
            slope->name, curve + 1);
    batten_curve *there = NULL;
    batten_status status = batten_curve_to_dimension(slope->curve, 3, &there);
    if (status == BATTEN_OK && !boundary->against[e])
        boundary->curves[e][1] = batten_curve_ref(there);
    else if (status == BATTEN_OK)
        status = batten_curve_reverse(there, &boundary->curves[e][1]);
    batten_curve_unref(there);
    set_side(boundary, e);
    return status;
}

batten_status bat_boundary_slopes(bat_run *run, const char *parameter, int order,
                                  bat_boundary *boundary)
{
    bat_objects slopes;
    if (order < 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a patch of the first kind takes no '%s'",
                        parameter);
    batten_status status = bat_gather(run, parameter, BAT_CURVES, &slopes);
    if (status != BATTEN_OK)
        return status;
    if (slopes.count > boundary->curve_count)
        status = bat_fail(BATTEN_BAD_ARGUMENT, "there are %d '%s' for %d curve%s", slopes.count,
                          parameter, boundary->curve_count, bat_plural(boundary->curve_count));
    for (int i = 0; status == BATTEN_OK && i < slopes.count; i++)
        status = set_slope(slopes.at[i], i, boundary);
    bat_objects_release(&slopes);
    return status;
}

/* ---- surfaces beside it ---- */

/* Which surface lies along each side, or -1; the sides become the edges themselves. */
static batten_status match_sides(const bat_objects *surfaces, double tolerance,
                                 bat_boundary *boundary, int matches[4])
{
    batten_status status = BATTEN_OK;
    for (int s = 0; status == BATTEN_OK && s < surfaces->count; s++) {
        bool used = false;
        for (int e = 0; status == BATTEN_OK && e < 4; e++) {
            batten_curve *edge[3] = {NULL, NULL, NULL};
            if (matches[e] >= 0)
                continue;
            status =
                batten_ribbon_along(surfaces->at[s]->surface, boundary->curves[e][0],
                                    (batten_ribbon_wish){0, NULL, tolerance}, NULL, NULL, edge);
            if (status == BATTEN_OK) {
                batten_curve_unref(boundary->curves[e][0]);
                boundary->curves[e][0] = edge[0];
                matches[e] = s;
                used = true;
            }
            if (status == BATTEN_NOT_FOUND)
                status = BATTEN_OK;
        }
        if (status == BATTEN_OK && !used)
            status = bat_fail(BATTEN_NOT_FOUND,
                              "'%s' has no edge along a side of the patch within %g",
                              surfaces->at[s]->name, tolerance);
    }
    return status;
}

/* The inward derivatives of the two sides beside side e, at its ends. */
static batten_status derivatives_beside(const bat_boundary *boundary, int e, double ends[6])
{
    const bool along_u = e == BATTEN_EDGE_V0 || e == BATTEN_EDGE_V1;
    const bool far = e == BATTEN_EDGE_V1 || e == BATTEN_EDGE_U1;
    static const int beside[2][2] = {{BATTEN_EDGE_V0, BATTEN_EDGE_V1},
                                     {BATTEN_EDGE_U0, BATTEN_EDGE_U1}};
    for (int k = 0; k < 2; k++) {
        double out[6];
        const batten_curve *curve = boundary->curves[beside[along_u][k]][0];
        const batten_interval domain = batten_curve_domain(curve);
        const batten_status status =
            batten_curve_evaluate_side(curve, far ? domain.b : domain.a,
                                       far ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, 1, out);
        if (status != BATTEN_OK)
            return status;
        for (int x = 0; x < 3; x++)
            ends[3 * k + x] = far ? -out[3 + x] : out[3 + x];
    }
    return BATTEN_OK;
}

static batten_status take_slope(bat_run *run, const batten_object *object, int e, int order,
                                double tolerance, bat_boundary *boundary)
{
    batten_curve *ribbon[3] = {NULL, NULL, NULL};
    double ends[6], misfit[2] = {0, 0}, error = 0;
    batten_status status = derivatives_beside(boundary, e, ends);
    if (status == BATTEN_OK)
        status = batten_ribbon_along(object->surface, boundary->curves[e][0],
                                     (batten_ribbon_wish){order - 1, ends, tolerance}, misfit,
                                     &error, ribbon);
    if (status != BATTEN_OK)
        return status;
    for (int k = 0; k < order; k++) {
        batten_curve_unref(boundary->curves[e][k]);
        boundary->curves[e][k] = ribbon[k];
    }
    bat_remark(run, "side %d lies along '%s'", e + 1, object->name);
    if (error > 0)
        bat_report_error(run, error, error);
    const double off = bat_max(misfit[0], misfit[1]);
    /* A sine: less than a millionth is what exact neighbours keep of rounding. */
    if (off > 1e-6)
        bat_note(run, "a boundary curve leaves '%s' %.3g degree%s off its tangent plane",
                 object->name, bat_asin(bat_min(1, off)) * 180 / BAT_PI,
                 bat_plural_real(bat_asin(bat_min(1, off)) * 180 / BAT_PI, 3));
    return BATTEN_OK;
}

batten_status bat_boundary_along(bat_run *run, const char *parameter, int order,
                                 double tolerance, bat_boundary *boundary)
{
    bat_objects surfaces;
    int matches[4] = {-1, -1, -1, -1};
    if (order < 2)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a patch of the first kind takes no slopes from '%s'", parameter);
    batten_status status = bat_gather(run, parameter, BAT_SURFACES, &surfaces);
    if (status != BATTEN_OK)
        return status;
    status = match_sides(&surfaces, tolerance, boundary, matches);
    for (int e = 0; status == BATTEN_OK && e < 4; e++)
        if (matches[e] >= 0) {
            boundary->beside[e] = batten_surface_ref(surfaces.at[matches[e]]->surface);
            status = take_slope(run, surfaces.at[matches[e]], e, order, tolerance, boundary);
        }
    for (int e = 0; e < 4; e++)
        set_side(boundary, e);
    bat_objects_release(&surfaces);
    return status;
}

void bat_boundary_release(bat_boundary *boundary)
{
    for (int e = 0; e < 4; e++) {
        batten_surface_unref(boundary->beside[e]);
        for (int k = 0; k < 3; k++)
            batten_curve_unref(boundary->curves[e][k]);
    }
}
