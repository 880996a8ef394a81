/* The draught, trim and heel at which a hull is at rest: Newton's method on the turn of the
 * waterplane, the draught for the volume found anew at each. */
#include "hydrostatics/wet.h"

#include <string.h>

/* A turn is at most 5 degrees at a time; beyond 80 degrees a ship is lost. */
static const double MOST_TURN = 5 * BAT_PI / 180, CAPSIZED = 80 * BAT_PI / 180;
enum { MOST_TURNS = 200, MOST_DRAUGHTS = 100 };
/* The derivative of the volume by the draught decides only where it is more than this. */
static const double LEAST_AREA = 1e-9;

typedef struct {
    const batten_hull *hull;
    const batten_loading *loading;
    const batten_job *job;
    double precision;
    double volume, gravity[3]; /* in the coordinates of the patches */
    double trim, heel;
    bat_water water;
    bat_wet wet;
    double moment[3];    /* of the volume about the centre of mass: up, along, across */
    double stiffness[3]; /* along, mixed, across: by a turn of one radian */
} balance;

/* ---- the draught ---- */

/* From where to where the box reaches above the plane through its centre. */
static double highest(const balance *b)
{
    const batten_box box = b->hull->box;
    const double extent[3] = {box.high.x - box.low.x, box.high.y - box.low.y,
                              box.high.z - box.low.z};
    double sum = 0;
    for (int c = 0; c < 3; c++)
        sum += fabs(b->water.n[c]) * extent[c] / (2 * b->hull->size);
    return sum;
}

static batten_status wet_at(balance *b, double d)
{
    b->water.d = d;
    return bat_hull_wet(b->hull, &b->water, b->precision, b->job, &b->wet);
}

static batten_status set_water(balance *b)
{
    const batten_flotation flotation = {0, b->trim, b->heel};
    const double d = b->water.d;
    const batten_status status = bat_water_of(b->hull, &flotation, &b->water);
    b->water.d = d;
    return status;
}

/* The draught for the volume: Newton's steps, halved where they leave what is left. */
static batten_status find_draught(balance *b)
{
    batten_status status = set_water(b);
    double high = status == BATTEN_OK ? highest(b) : 0, low = -high;
    double d = bat_max(low, bat_min(high, b->water.d));
    for (int i = 0; i < MOST_DRAUGHTS && status == BATTEN_OK; i++) {
        status = wet_at(b, d);
        const double lack = b->volume - b->wet.sums[BAT_VOLUME];
        if (status != BATTEN_OK || fabs(lack) <= b->precision * b->volume || high <= low)
            return status;
        *(lack > 0 ? &low : &high) = d;
        const double area = b->wet.sums[BAT_PLANE];
        const double next = area > LEAST_AREA ? d + lack / area : low;
        const double middle = low + 0.5 * (high - low);
        d = next > low && next < high ? next : middle;
        if (!(middle > low && middle < high))
            return BATTEN_OK;
    }
    return status == BATTEN_OK
               ? bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "no draught for the volume was found in %d steps", MOST_DRAUGHTS)
               : status;
}

/* ---- the turn ---- */

static double moment_along(const balance *b, const double direction[3])
{
    double sum = 0;
    for (int c = 0; c < 3; c++)
        sum += (b->wet.sums[BAT_MOMENT + c] - b->wet.sums[BAT_VOLUME] * b->gravity[c]) *
               direction[c];
    return sum;
}

/* Moments and stiffness at the draught that was found. A turn about the centre of the
 * waterplane leaves the volume as it is. */
static void find_moments(balance *b)
{
    const double *sums = b->wet.sums, *squares = sums + BAT_PLANE_SQUARES;
    const double area = sums[BAT_PLANE];
    const double along = area > 0 ? sums[BAT_PLANE_ALONG] / area : 0;
    const double across = area > 0 ? sums[BAT_PLANE_ACROSS] / area : 0;
    b->moment[0] = moment_along(b, b->water.n);
    b->moment[1] = moment_along(b, b->water.along);
    b->moment[2] = moment_along(b, b->water.across);
    b->stiffness[0] = squares[0] - area * along * along + b->moment[0];
    b->stiffness[1] = squares[1] - area * along * across;
    b->stiffness[2] = squares[2] - area * across * across + b->moment[0];
}

/* Of the angles that are free. */
static bool is_stable(const balance *b)
{
    const double *k = b->stiffness;
    if (b->loading->fixed_trim)
        return b->loading->fixed_heel || k[2] > 0;
    return k[0] > 0 && (b->loading->fixed_heel || k[0] * k[2] > k[1] * k[1]);
}

/* The turn that Newton's method asks for, along and across; down the moments where the hull is
 * not stable, towards where it is. */
static void find_turn(const balance *b, double turn[2])
{
    const double *k = b->stiffness;
    const bool trims = !b->loading->fixed_trim, heels = !b->loading->fixed_heel;
    const double r[2] = {trims ? b->moment[1] : 0, heels ? b->moment[2] : 0};
    turn[0] = turn[1] = 0;
    if (is_stable(b)) {
        const double mixed = trims && heels ? k[1] : 0;
        const double a = trims ? k[0] : 1, c = heels ? k[2] : 1;
        const double determinant = a * c - mixed * mixed;
        turn[0] = (r[0] * c - r[1] * mixed) / determinant;
        turn[1] = (r[1] * a - r[0] * mixed) / determinant;
    } else {
        const double size = bat_hypot(r[0], r[1]);
        for (int i = 0; i < 2; i++)
            turn[i] = size > 0 ? MOST_TURN * r[i] / size : 0;
    }
    const double angle = bat_hypot(turn[0], turn[1]);
    for (int i = 0; i < 2 && angle > MOST_TURN; i++)
        turn[i] *= MOST_TURN / angle;
}

static bool is_at_rest(const balance *b)
{
    const double allowed = b->precision * b->volume;
    return (b->loading->fixed_trim || fabs(b->moment[1]) <= allowed) &&
           (b->loading->fixed_heel || fabs(b->moment[2]) <= allowed);
}

static batten_status find_rest(balance *b)
{
    for (int i = 0; i < MOST_TURNS; i++) {
        double turn[2];
        const batten_status status = find_draught(b);
        if (status != BATTEN_OK)
            return status;
        find_moments(b);
        if (is_at_rest(b))
            return BATTEN_OK;
        find_turn(b, turn);
        b->trim += turn[0];
        b->heel += turn[1] / bat_cos(b->trim);
        if (fabs(b->trim) > CAPSIZED || (!b->loading->fixed_heel && fabs(b->heel) > CAPSIZED))
            break;
    }
    return bat_fail(BATTEN_NOT_FOUND,
                    "no rest was found up to a trim of %.3g and a heel of %.3g degrees: "
                    "the hull capsizes",
                    b->trim * 180 / BAT_PI, b->heel * 180 / BAT_PI);
}

/* ---- the call ---- */

static batten_status check_loading(const batten_hull *hull, const batten_loading *loading)
{
    const double l3 = hull->size * hull->size * hull->size;
    if (!(loading->volume > 0) || !isfinite(loading->volume / l3))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a hull is to displace %g; it must be above 0",
                        loading->volume);
    const batten_vec3 g = loading->gravity;
    if (!isfinite(g.x) || !isfinite(g.y) || !isfinite(g.z))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the centre of mass (%g, %g, %g) is not finite",
                        g.x, g.y, g.z);
    return BATTEN_OK;
}

/* All of it under water displaces more than it has to. */
static batten_status check_buoyancy(balance *b)
{
    batten_status status = set_water(b);
    if (status == BATTEN_OK)
        status = wet_at(b, 1.5 * highest(b));
    const double whole = b->wet.sums[BAT_VOLUME], l = b->hull->size;
    if (status == BATTEN_OK && !(b->volume * (1 + b->precision) < whole))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the hull is to displace %.6g but has only %.6g: it sinks",
                        b->loading->volume, whole * l * l * l);
    return status;
}

static void report_balance(const balance *b, batten_balance *out)
{
    const double l = b->hull->size, volume = b->wet.sums[BAT_VOLUME];
    double height = b->water.d;
    for (int c = 0; c < 3; c++)
        height += b->water.n[c] * b->hull->centre[c] / l;
    out->flotation = (batten_flotation){l * height / b->water.n[2], b->trim, b->heel};
    bat_take_values(b->hull, &b->water, &b->wet, &out->values);
    out->heeling = -b->moment[2] / volume * l;
    out->trimming = b->moment[1] / volume * l;
    out->metacentric[0] = b->stiffness[2] / volume * l;
    out->metacentric[1] = b->stiffness[0] / volume * l;
    out->stable = is_stable(b);
}

batten_status batten_hull_balance(const batten_hull *hull, const batten_loading *loading,
                                  const batten_flotation *start, double precision,
                                  const batten_job *job, batten_balance *out)
{
    const double l = hull->size;
    const double g[3] = {loading->gravity.x, loading->gravity.y, loading->gravity.z};
    balance b = {.hull = hull,
                 .loading = loading,
                 .job = job,
                 .precision = precision,
                 .volume = loading->volume / (l * l * l),
                 .trim = start->trim,
                 .heel = start->heel};
    for (int c = 0; c < 3; c++)
        b.gravity[c] = (g[c] - hull->centre[c]) / l;
    batten_status status = bat_check_precision(precision);
    if (status == BATTEN_OK)
        status = check_loading(hull, loading);
    if (status == BATTEN_OK)
        status = check_buoyancy(&b);
    if (status == BATTEN_OK)
        status = bat_water_of(hull, start, &b.water);
    if (status == BATTEN_OK)
        status = find_rest(&b);
    if (status == BATTEN_OK)
        report_balance(&b, out);
    return status;
}
