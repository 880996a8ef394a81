/* Measures of the curve of righting arms: areas below it, its top and its end, and the heels at which the edge of the
 * deck and openings come to the water. */
#include "base/elementary.h"
#include "design/outputs/hydrostatics.h"

/* The scan for changes of sign, degrees; heels are found so well, radians. */
enum { STEP = 5, SCANNED = 18 };
static const double HEEL = 1e-9, LAST = 89.999;
/* What golden sections leave of an interval; the top is flat, so that this many find it. */
static const double GOLDEN = 0.61803398874989485;
enum { SECTIONS = 18, MOST_STEPS = 80, PIECES = 4 };

static const double DEGREE = BAT_PI / 180;

/* What is asked of the hull at a heel. */
typedef enum { ARM, FREEBOARD, OPENINGS, WANTED } what;

/* Heels in steps, and the values there. */
typedef struct {
    double heels[SCANNED + 1], values[SCANNED + 1][WANTED];
} scan;

/* The height of the lowest opening above the water, on either side of the ship. */
static double lowest_opening(const bat_hydro *h, const batten_flotation *at)
{
    const bat_argument *openings = bat_argument_of(h->run, "openings");
    const double st = bat_sin(at->trim), ct = bat_cos(at->trim), sp = bat_sin(at->heel),
                 cp = bat_cos(at->heel);
    double least = INFINITY;
    for (int i = 0; i < openings->count; i++) {
        const double *p = openings->items[i].number;
        const double height = st * p[0] - ct * fabs(sp * p[1]) + ct * cp * (p[2] - at->draught);
        least = bat_min(least, height);
    }
    return least;
}

/* NAN where the hull does not float so, and heights of what is plumb to the water. */
static batten_status values_at(const bat_hydro *h, double heel, double values[WANTED])
{
    batten_balance b;
    bool found;
    const batten_status status = bat_hydro_balance(h, &h->loading, heel, &b, &found);
    for (int k = 0; k < WANTED; k++)
        values[k] = (double)NAN;
    if (status != BATTEN_OK || !found)
        return status;
    values[ARM] = b.heeling;
    values[OPENINGS] = lowest_opening(h, &b.flotation);
    /* Without a deck it stays NAN. */
    (void)batten_hull_freeboard(h->hull, &b.flotation, &values[FREEBOARD], NULL);
    return BATTEN_OK;
}

static batten_status value_at(const bat_hydro *h, what wanted, double heel, double *value)
{
    double values[WANTED];
    const batten_status status = values_at(h, heel, values);
    *value = values[wanted];
    return status;
}

/* Where a value falls through 0, between heels at which it is above and below: false position with the older end
 * halved (Illinois). */
static batten_status find_zero(const bat_hydro *h, what wanted, batten_interval heels,
                               batten_interval values, double *out)
{
    batten_status status = BATTEN_OK;
    int side = 0;
    for (int i = 0; i < MOST_STEPS && heels.b - heels.a > HEEL && status == BATTEN_OK; i++) {
        double heel = heels.a + (heels.b - heels.a) * values.a / (values.a - values.b), value;
        heel = bat_max(heels.a + 0.25 * HEEL, bat_min(heels.b - 0.25 * HEEL, heel));
        status = value_at(h, wanted, heel, &value);
        if (status != BATTEN_OK || isnan(value))
            break;
        const bool high = value > 0;
        values.b *= high && side > 0 ? 0.5 : 1;
        values.a *= !high && side < 0 ? 0.5 : 1;
        side = high ? 1 : -1;
        *(high ? &heels.a : &heels.b) = heel;
        *(high ? &values.a : &values.b) = value;
    }
    *out = heels.b;
    return status;
}

/* The first heel of the scan at which a value is no longer above 0: NAN when it stays there; an arm, which may begin
 * at 0 or below, falls from where it was above. */
static batten_status find_end(const bat_hydro *h, what wanted, const scan *s, double *out)
{
    double before = (double)NAN;
    *out = (double)NAN;
    for (int i = 0; i <= SCANNED; i++) {
        const double value = s->values[i][wanted];
        if (isnan(value))
            break;
        if (i == 0 && wanted != ARM && value <= 0)
            *out = 0;
        if (before > 0 && value <= 0)
            return find_zero(h, wanted, (batten_interval){s->heels[i - 1], s->heels[i]},
                             (batten_interval){before, value}, out);
        if (!isnan(*out))
            break;
        before = wanted == ARM && i == 0 ? 0 : value; /* at 0 it is rounding */
    }
    return BATTEN_OK;
}

static batten_status fill_scan(const bat_hydro *h, scan *out)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i <= SCANNED && status == BATTEN_OK; i++) {
        /* At 90 degrees the water is plumb, and has no draught. */
        out->heels[i] = bat_min(i * STEP, LAST) * DEGREE;
        status = values_at(h, out->heels[i], out->values[i]);
    }
    return status;
}

/* ---- the largest arm ---- */

static batten_status climb(const bat_hydro *h, batten_interval between, bat_hydro_measures *m)
{
    double x[2] = {between.b - GOLDEN * (between.b - between.a),
                   between.a + GOLDEN * (between.b - between.a)};
    double arms[2];
    batten_status status = value_at(h, ARM, x[0], &arms[0]);
    if (status == BATTEN_OK)
        status = value_at(h, ARM, x[1], &arms[1]);
    for (int i = 0; i < SECTIONS && status == BATTEN_OK; i++) {
        const int worse = arms[0] >= arms[1] ? 1 : 0;
        *(worse == 0 ? &between.a : &between.b) = x[worse];
        arms[worse] = arms[!worse];
        x[worse] = x[!worse];
        x[!worse] = worse == 0 ? between.a + GOLDEN * (between.b - between.a)
                               : between.b - GOLDEN * (between.b - between.a);
        status = value_at(h, ARM, x[!worse], &arms[!worse]);
    }
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        if (arms[k] > m->largest) {
            m->largest = arms[k];
            m->largest_at = x[k] / DEGREE;
        }
    return status;
}

static batten_status find_largest(const bat_hydro *h, const scan *s, bat_hydro_measures *m)
{
    int best = 0;
    for (int i = 0; i <= SCANNED; i++)
        best =
            s->values[i][ARM] > s->values[best][ARM] || isnan(s->values[best][ARM]) ? i : best;
    m->largest = s->values[best][ARM];
    m->largest_at = s->heels[best] / DEGREE;
    if (isnan(m->largest)) {
        m->largest_at = (double)NAN;
        return BATTEN_OK;
    }
    return climb(h,
                 (batten_interval){s->heels[bat_max_int(0, best - 1)],
                                   s->heels[bat_min_int(SCANNED, best + 1)]},
                 m);
}

/* ---- areas ---- */

/* How far the centre of mass lies above the centre of buoyancy, seen from the water. */
static double lever(const bat_hydro *h, const batten_balance *b)
{
    const batten_flotation *at = &b->flotation;
    const batten_vec3 g = h->loading.gravity, c = b->values.buoyancy;
    const double ct = bat_cos(at->trim);
    return bat_sin(at->trim) * (g.x - c.x) + ct * bat_sin(at->heel) * (g.y - c.y) +
           ct * bat_cos(at->heel) * (g.z - c.z);
}

/* By work: with the volume held and the trim free, this lever grows by GZ cos(trim) for each radian of heel. The
 * small rest, GZ (1 - cos(trim)), is integrated by Simpson's rule, and by half of its places for the error. */
static batten_status find_area(const bat_hydro *h, double from, double to, bat_hydro_area *out)
{
    static const double fine[] = {1, 4, 2, 4, 1}, coarse[] = {1, 0, 4, 0, 1};
    double levers[PIECES + 1], rest[2] = {0, 0};
    const batten_box box = batten_hull_box(h->hull);
    const double step = (to - from) / PIECES;
    *out = (bat_hydro_area){(double)NAN, (double)NAN};
    for (int i = 0; i <= PIECES; i++) {
        batten_balance b;
        bool found;
        const batten_status status =
            bat_hydro_balance(h, &h->loading, from + i * step, &b, &found);
        if (status != BATTEN_OK || !found)
            return status;
        levers[i] = lever(h, &b);
        const double lost = b.heeling * (1 - bat_cos(b.flotation.trim));
        rest[0] += fine[i] * step / 3 * lost;
        rest[1] += coarse[i] * 2 * step / 3 * lost;
    }
    out->area = levers[PIECES] - levers[0] + rest[0];
    out->error = fabs(rest[0] - rest[1]) +
                 BAT_HYDRO_PRECISION * bat_max(box.high.y - box.low.y, box.high.z - box.low.z);
    return BATTEN_OK;
}

static batten_status find_areas(const bat_hydro *h, bat_hydro_measures *m)
{
    const double most = m->opening < 40 ? m->opening : 40;
    batten_status status = BATTEN_OK;
    m->area_to = most;
    m->areas[2] = (bat_hydro_area){(double)NAN, (double)NAN};
    status = find_area(h, 0, 30 * DEGREE, &m->areas[0]);
    if (status == BATTEN_OK && most > 30) {
        status = find_area(h, 30 * DEGREE, most * DEGREE, &m->areas[2]);
        m->areas[1] = (bat_hydro_area){m->areas[0].area + m->areas[2].area,
                                       m->areas[0].error + m->areas[2].error};
    } else if (status == BATTEN_OK) {
        status = find_area(h, 0, most * DEGREE, &m->areas[1]);
    }
    return status;
}

batten_status bat_hydro_measure(bat_hydro *h)
{
    bat_hydro_measures *m = &h->report.measures;
    batten_balance b;
    bool found;
    scan s;
    *m = (bat_hydro_measures){.gm = (double)NAN, .arm = (double)NAN, .opening = (double)NAN};
    batten_status status = bat_hydro_balance(h, &h->loading, 0, &b, &found);
    if (status == BATTEN_OK && found) {
        m->gm = b.metacentric[0];
        m->arm = bat_hydro_without_dust(h, b.heeling);
    }
    if (status == BATTEN_OK)
        status = fill_scan(h, &s);
    if (status == BATTEN_OK)
        status = find_largest(h, &s, m);
    if (status == BATTEN_OK)
        status = find_end(h, ARM, &s, &m->vanishing);
    if (status == BATTEN_OK)
        status = find_end(h, FREEBOARD, &s, &m->deck);
    if (status == BATTEN_OK && bat_has(h->run, "openings"))
        status = find_end(h, OPENINGS, &s, &m->opening);
    m->vanishing /= DEGREE;
    m->deck /= DEGREE;
    m->opening /= DEGREE;
    return status == BATTEN_OK ? find_areas(h, m) : status;
}
