/* The plane of canonical cubics: its regions hold loops, cusps, inflections or none of them. */
#include "numeric/exact.h"
#include "numeric/vector.h"
#include <batten/invariants.h>

/* What lies in each region. */
static const struct {
    const char *name;
    batten_cubic_class segment;
} regions[BATTEN_REGION_COUNT] = {
    [BATTEN_REGION_REGULAR] = {"regular", BATTEN_CUBIC_PLAIN},
    [BATTEN_REGION_ONE_INFLECTION] = {"one inflection", BATTEN_CUBIC_ONE_INFLECTION},
    [BATTEN_REGION_EXCESS] = {"excess inflections", BATTEN_CUBIC_TWO_INFLECTIONS},
    [BATTEN_REGION_CUSP] = {"cusp", BATTEN_CUBIC_CUSP},
    [BATTEN_REGION_LOOP] = {"loop", BATTEN_CUBIC_LOOP},
    [BATTEN_REGION_S_SHAPED] = {"S-shaped", BATTEN_CUBIC_ONE_INFLECTION},
    [BATTEN_REGION_S_EXCESS] = {"S-shaped, two inflections", BATTEN_CUBIC_TWO_INFLECTIONS},
    [BATTEN_REGION_S_CUSP] = {"S-shaped, cusp", BATTEN_CUBIC_CUSP},
    [BATTEN_REGION_S_LOOP] = {"S-shaped, loop", BATTEN_CUBIC_LOOP},
    [BATTEN_REGION_TURNING] = {"turning far", BATTEN_CUBIC_PLAIN},
    [BATTEN_REGION_FAR] = {"far side", BATTEN_CUBIC_PLAIN},
    [BATTEN_REGION_DEGENERATE] = {"degenerate", BATTEN_CUBIC_PLAIN},
};

const char *batten_cubic_region_name(batten_cubic_region region)
{
    return (unsigned)region < BATTEN_REGION_COUNT ? regions[region].name : "unknown";
}

/* The sign of 3 x y - 4 x - 4 y + 4. */
static int hyperbola_sign(double x, double y)
{
    const bat_exact a = bat_exact_difference(x, 0), b = bat_exact_difference(y, 0);
    bat_exact sum = bat_exact_difference(4, 0);
    bat_exact_add_product(&sum, 3, &a, &b);
    bat_exact_add(&sum, -4, &a);
    bat_exact_add(&sum, -4, &b);
    return bat_exact_sign(&sum);
}

/* The sign of y - 3 x (1 - x). */
static int parabola_sign(double x, double y)
{
    const bat_exact a = bat_exact_difference(x, 0);
    bat_exact sum = bat_exact_difference(y, 0);
    bat_exact_add(&sum, -3, &a);
    bat_exact_add_product(&sum, 3, &a, &a);
    return bat_exact_sign(&sum);
}

/* One positive length x, one negative y. */
static batten_cubic_region s_shaped(double x, double y)
{
    const int h = hyperbola_sign(x, y);
    if (x <= 1)
        return BATTEN_REGION_S_SHAPED;
    if (h >= 0)
        return h > 0 ? BATTEN_REGION_S_EXCESS : BATTEN_REGION_S_CUSP;
    return parabola_sign(x, y) < 0 ? BATTEN_REGION_S_LOOP : BATTEN_REGION_TURNING;
}

static batten_cubic_region region_of(double x, double y)
{
    if (x == 0 || y == 0)
        return BATTEN_REGION_DEGENERATE;
    if (x < 0 || y < 0)
        return x < 0 && y < 0 ? BATTEN_REGION_FAR : s_shaped(bat_max(x, y), bat_min(x, y));
    if (x <= 1 && y <= 1)
        return BATTEN_REGION_REGULAR;
    if (x <= 1 || y <= 1)
        return BATTEN_REGION_ONE_INFLECTION;
    const int h = hyperbola_sign(x, y);
    return h < 0 ? BATTEN_REGION_EXCESS : h > 0 ? BATTEN_REGION_LOOP : BATTEN_REGION_CUSP;
}

batten_status batten_cubic_look_up(double lambda, double mu, batten_cubic_place *out)
{
    if (!isfinite(lambda) || !isfinite(mu))
        return bat_fail(BATTEN_NOT_FINITE, "lambda %g, mu %g: both must be finite", lambda, mu);
    batten_cubic_place place = {.region = region_of(lambda, mu)};
    place.segment = regions[place.region].segment;
    place.h = 3 * lambda * mu - 4 * lambda - 4 * mu + 4;
    place.d = -lambda * mu * place.h;
    place.first = lambda * (lambda - 3 * mu * (1 - mu));
    place.last = mu * (mu - 3 * lambda * (1 - lambda));
    *out = place;
    return BATTEN_OK;
}

void batten_cubic_from_lengths(double lambda, double mu, double *points)
{
    const double made[8] = {0, 0, 0, lambda, 1 - mu, 1, 1, 1};
    for (int k = 0; k < 8; k++)
        points[k] = made[k];
}

batten_status batten_cubic_canonical(const double *points, double *x, double *y)
{
    batten_cubic cubic;
    const batten_status status = batten_cubic_classify(2, points, 0, &cubic);
    if (status != BATTEN_OK)
        return status;
    if (!(fabs(cubic.a) > 0))
        return bat_fail(BATTEN_SINGULAR_HERE, "the first three points lie on a line");
    *x = 1 + cubic.b / cubic.a;
    *y = 1 - cubic.c / cubic.a;
    return BATTEN_OK;
}

batten_cubic_class batten_cubic_canonical_class(double x, double y)
{
    const double cusp = (-x * x + 2 * x + 3) / 4;
    if (y > 1)
        return BATTEN_CUBIC_ONE_INFLECTION;
    if (x >= 1)
        return BATTEN_CUBIC_PLAIN;
    if (y >= cusp)
        return y > cusp ? BATTEN_CUBIC_TWO_INFLECTIONS : BATTEN_CUBIC_CUSP;
    const double last = x <= 0 ? (-x * x + 3 * x) / 3 : (sqrt(3 * (4 * x - x * x)) - x) / 2;
    return y > last ? BATTEN_CUBIC_LOOP : BATTEN_CUBIC_PLAIN;
}
