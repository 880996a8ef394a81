/* A hull afloat in the report of hydrostatics: how it rests with its mass, its righting arms, and cross curves. */
#include "base/elementary.h"
#include "design/outputs/hydrostatics.h"

/* The cosine of a heel at which the water stands upright in the hull. */
static const double PLUMB = 1e-9;
/* The cosine of a heel from which on the draught is no start for others. */
static const double STEEP = 0.1;
/* Places that are 0 but for rounding, as a part of the length. */
static const double DUST = 1e-12;
/* Angles that are 0 but for the precision of the rest. */
static const double LEVEL = 1e-9;

static const double STANDARD_HEELS[] = {0,  5,  10, 15, 20, 25, 30, 35,
                                        40, 45, 50, 55, 60, 70, 80, 90};

double bat_hydro_without_dust(const bat_hydro *h, double place)
{
    const batten_box box = batten_hull_box(h->hull);
    return fabs(place) < DUST * (box.high.x - box.low.x) ? 0 : place;
}

batten_status bat_hydro_balance(const bat_hydro *h, const batten_loading *loading, double heel,
                                batten_balance *out, bool *found)
{
    const batten_flotation start = {h->near->draught, h->near->trim, heel};
    batten_loading held = *loading;
    held.fixed_heel = true;
    const batten_status status =
        batten_hull_balance(h->hull, &held, &start, BAT_HYDRO_PRECISION, h->run->job, out);
    *found = status == BATTEN_OK;
    if (*found && fabs(bat_cos(heel)) > STEEP && !held.fixed_trim)
        *h->near = out->flotation;
    return status == BATTEN_NOT_FOUND ? BATTEN_OK : status;
}

/* ---- righting arms ---- */

static batten_status add_arm(bat_hydro *h, double heel, bat_hydro_arm *arm)
{
    const batten_loading *loading = &h->loading;
    batten_balance b;
    bool found;
    const batten_status status = bat_hydro_balance(h, loading, heel, &b, &found);
    *arm = (bat_hydro_arm){heel * 180 / BAT_PI, NAN, NAN, NAN, NAN, NAN};
    if (status != BATTEN_OK)
        return status;
    if (!found) {
        bat_note(h->run, "at a heel of %g degrees the hull finds no trim: %s", arm->heel,
                 batten_message());
        return BATTEN_OK;
    }
    arm->arm = bat_hydro_without_dust(h, b.heeling);
    arm->kn =
        arm->arm + loading->gravity.z * bat_sin(heel) - loading->gravity.y * bat_cos(heel);
    /* On its side a hull has no draught: the water is plumb in its coordinates. */
    if (fabs(bat_cos(heel)) > PLUMB) {
        double freeboard;
        arm->draught = b.flotation.draught;
        if (batten_hull_freeboard(h->hull, &b.flotation, &freeboard, NULL) == BATTEN_OK)
            arm->freeboard = bat_hydro_without_dust(h, freeboard);
    }
    arm->trim = b.flotation.trim * 180 / BAT_PI;
    return BATTEN_OK;
}

static batten_status fill_arms(bat_hydro *h)
{
    bat_hydro_report *r = &h->report;
    batten_status status = BATTEN_OK;
    r->arm_count = r->heel_count;
    r->arms = bat_arena_array(&h->arena, (size_t)r->arm_count, sizeof *r->arms);
    if (!r->arms)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < r->arm_count && status == BATTEN_OK; i++)
        status = add_arm(h, r->heels[i], &r->arms[i]);
    return status;
}

static batten_status list_heels(bat_hydro *h)
{
    const bat_argument *given = bat_argument_of(h->run, "heels");
    const int standard = sizeof STANDARD_HEELS / sizeof STANDARD_HEELS[0];
    bat_hydro_report *r = &h->report;
    r->heel_count = given->count > 0 ? given->count : standard;
    r->heels = bat_arena_array(&h->arena, (size_t)r->heel_count, sizeof *r->heels);
    if (!r->heels)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < r->heel_count; i++)
        r->heels[i] =
            given->count > 0 ? given->items[i].number[0] : STANDARD_HEELS[i] * BAT_PI / 180;
    return BATTEN_OK;
}

static batten_status find_rest(bat_hydro *h)
{
    bat_hydro_report *r = &h->report;
    const batten_box box = batten_hull_box(h->hull);
    const batten_flotation start = {0.5 * (box.low.z + box.high.z), 0, 0};
    const batten_status status = batten_hull_balance(
        h->hull, &h->loading, &start, BAT_HYDRO_PRECISION, h->run->job, &r->rest);
    if (fabs(r->rest.flotation.heel) < LEVEL)
        r->rest.flotation.heel = 0;
    if (fabs(r->rest.flotation.trim) < LEVEL)
        r->rest.flotation.trim = 0;
    return status;
}

/* ---- cross curves ---- */

/* The mass lies at the x of 'gravity', else above the centre of buoyancy of the level hull. */
static batten_status load(const bat_hydro *h, double displacement, batten_loading *out)
{
    const double cubic = h->metres * h->metres * h->metres;
    const batten_loading level = {
        displacement / (h->report.density * cubic), {0, 0, 0}, true, true};
    batten_balance b;
    bool found;
    *out = level;
    out->fixed_trim = false;
    out->gravity.x = h->report.gravity.x;
    if (bat_has(h->run, "gravity"))
        return BATTEN_OK;
    const batten_status status = bat_hydro_balance(h, &level, 0, &b, &found);
    if (status == BATTEN_OK)
        out->gravity.x = b.values.buoyancy.x;
    return status;
}

static batten_status add_cross_curve(bat_hydro *h, int index)
{
    bat_hydro_report *r = &h->report;
    batten_loading loading;
    int lost = 0;
    batten_status status = load(h, r->displacements[index], &loading);
    for (int i = 0; i < r->heel_count && status == BATTEN_OK; i++) {
        batten_balance b;
        bool found;
        double *kn = &r->cross[(size_t)index * (size_t)r->heel_count + (size_t)i];
        status = bat_hydro_balance(h, &loading, r->heels[i], &b, &found);
        if (status != BATTEN_OK)
            break;
        *kn = found ? bat_hydro_without_dust(h, b.heeling) : (double)NAN;
        lost += !found;
    }
    if (status == BATTEN_OK && lost > 0)
        bat_note(h->run, "with %g t the hull finds no trim at %d of %d heels of cross curves",
                 r->displacements[index], lost, r->heel_count);
    return status;
}

static batten_status fill_cross_curves(bat_hydro *h)
{
    const bat_argument *given = bat_argument_of(h->run, "displacements");
    bat_hydro_report *r = &h->report;
    const size_t count = (size_t)given->count;
    batten_status status = BATTEN_OK;
    r->displacements = bat_arena_array(&h->arena, count, sizeof *r->displacements);
    r->cross = bat_arena_array(&h->arena, count, (size_t)r->heel_count * sizeof *r->cross);
    if (!r->displacements || !r->cross)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < given->count && status == BATTEN_OK; i++) {
        r->displacements[i] = given->items[i].number[0];
        if (!(r->displacements[i] > 0))
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "displacement %d of the cross curves is %g t; it must be above 0",
                            i + 1, r->displacements[i]);
        status = add_cross_curve(h, i);
    }
    r->cross_count = given->count;
    return status;
}

/* ---- all of it ---- */

static batten_status check_parameters(const bat_run *run)
{
    const bool mass = bat_has(run, "mass");
    if (mass && !bat_has(run, "gravity"))
        return bat_fail(BATTEN_BAD_ARGUMENT, "'mass' and 'gravity' belong together");
    if (!mass && bat_has(run, "gravity") && !bat_has(run, "displacements"))
        return bat_fail(BATTEN_BAD_ARGUMENT, "'mass' and 'gravity' belong together");
    if (!mass && bat_has(run, "openings"))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'openings' are flooded as the hull heels with its 'mass' and "
                        "'gravity', which are not given");
    if (!mass && bat_has(run, "heels") && !bat_has(run, "displacements"))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'heels' are those of righting arms, which need 'mass' and "
                        "'gravity', or of cross curves, which need 'displacements'; 'heel' "
                        "is that of the table");
    return BATTEN_OK;
}

batten_status bat_hydro_float(bat_hydro *h)
{
    bat_hydro_report *r = &h->report;
    const bool mass = bat_has(h->run, "mass");
    batten_status status = check_parameters(h->run);
    if (status == BATTEN_OK)
        status = list_heels(h);
    if (status == BATTEN_OK && bat_has(h->run, "gravity"))
        r->gravity = bat_point(h->run, "gravity");
    if (status == BATTEN_OK && mass) {
        r->mass = bat_number(h->run, "mass");
        h->loading =
            (batten_loading){r->mass / (r->density * h->metres * h->metres * h->metres),
                             r->gravity, false, false};
        status = find_rest(h);
    }
    if (status == BATTEN_OK && mass)
        status = fill_arms(h);
    if (status == BATTEN_OK && bat_has(h->run, "displacements"))
        status = fill_cross_curves(h);
    return status;
}
