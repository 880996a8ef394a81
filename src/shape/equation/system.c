/* Enclosures of a system of equations: exclusion, graphs over an axis, crossings by interval Newton. */
#include "shape/equation/system.h"

#include <string.h>

/* Cubics along a curve have a remainder of the fourth order. */
#define ALONG 4

void bat_system_begin(bat_system *system, int equations, const batten_equation *const *list)
{
    *system =
        (bat_system){.equations = equations, .dimension = equations + 1, .equation = list};
    bat_jet_space_begin(&system->first, equations + 1, 1);
    bat_jet_space_begin(&system->along, 1, ALONG);
}

void bat_system_over(bat_system *s, const bat_cell *cell, bat_enclosure *out)
{
    out->undefined = false;
    for (int i = 0; i < s->equations; i++) {
        bat_interval_jet made;
        bat_equation_over(s->equation[i], &s->first, cell->at, &made);
        out->value[i] = made.c[0];
        for (int k = 0; k < s->dimension; k++)
            out->slope[i][k] = s->first.state == BAT_DEFINED ? made.c[1 + k] : BAT_EVERYTHING;
        out->undefined = out->undefined || s->first.state == BAT_UNDEFINED;
    }
}

double bat_cell_diagonal(const bat_system *s, const bat_cell *cell)
{
    double sum = 0;
    for (int k = 0; k < s->dimension; k++)
        sum += bat_interval_width(cell->at[k]) * bat_interval_width(cell->at[k]);
    return sqrt(sum);
}

double bat_cell_extent(const bat_system *s, const bat_cell *cell)
{
    return bat_interval_width(cell->at[bat_cell_longest(s, cell)]);
}

int bat_cell_longest(const bat_system *s, const bat_cell *cell)
{
    int longest = 0;
    for (int k = 1; k < s->dimension; k++)
        if (bat_interval_width(cell->at[k]) > bat_interval_width(cell->at[longest]))
            longest = k;
    return longest;
}

static bat_cell middle_of(const bat_system *s, const bat_cell *cell)
{
    bat_cell middle = *cell;
    for (int k = 0; k < s->dimension; k++)
        middle.at[k] = bat_interval_at(bat_interval_middle(cell->at[k]));
    return middle;
}

/* ---- exclusion ---- */

/* By the mean value: F(c) + F'(X) (X - c). */
static bool mean_value_excludes(bat_system *s, const bat_cell *cell, const bat_enclosure *e)
{
    const bat_cell middle = middle_of(s, cell);
    bat_enclosure there;
    bat_system_over(s, &middle, &there);
    for (int i = 0; i < s->equations; i++) {
        bat_interval range = there.value[i];
        for (int k = 0; k < s->dimension; k++)
            range = bat_interval_add(
                range, bat_interval_multiply(e->slope[i][k],
                                             bat_interval_subtract(cell->at[k], middle.at[k])));
        if (!bat_interval_holds_zero(range))
            return true;
    }
    return false;
}

bool bat_cell_is_free(bat_system *s, const bat_cell *cell, const bat_enclosure *e)
{
    if (e->undefined)
        return true;
    for (int i = 0; i < s->equations; i++)
        if (!bat_interval_holds_zero(e->value[i]))
            return true;
    return mean_value_excludes(s, cell, e);
}

/* ---- graphs ---- */

/* The derivatives by all axes but k. */
static void take_others(const bat_system *s, const bat_enclosure *e, int k,
                        bat_interval out[BAT_EQUATIONS][BAT_EQUATIONS])
{
    for (int i = 0; i < s->equations; i++)
        for (int j = 0, c = 0; j < s->dimension; j++)
            if (j != k)
                out[i][c++] = e->slope[i][j];
}

static bool invert(int n, bat_interval m[BAT_EQUATIONS][BAT_EQUATIONS],
                   double out[BAT_EQUATIONS][BAT_EQUATIONS])
{
    const double a = bat_interval_middle(m[0][0]);
    if (n == 1) {
        out[0][0] = 1 / a;
        return isfinite(out[0][0]);
    }
    const double b = bat_interval_middle(m[0][1]), c = bat_interval_middle(m[1][0]);
    const double d = bat_interval_middle(m[1][1]), determinant = a * d - b * c;
    out[0][0] = d / determinant;
    out[0][1] = -b / determinant;
    out[1][0] = -c / determinant;
    out[1][1] = a / determinant;
    return isfinite(out[0][0]) && isfinite(out[0][1]) && isfinite(out[1][0]) &&
           isfinite(out[1][1]);
}

/* Row i of I - A M. */
static void find_departure(int n, const double a[BAT_EQUATIONS],
                           bat_interval m[BAT_EQUATIONS][BAT_EQUATIONS], int i,
                           bat_interval out[BAT_EQUATIONS])
{
    for (int j = 0; j < n; j++) {
        bat_interval sum = bat_interval_at(i == j ? 1 : 0);
        for (int k = 0; k < n; k++)
            sum = bat_interval_subtract(sum, bat_interval_scale(a[k], m[k][j]));
        out[j] = sum;
    }
}

bool bat_is_graph(const bat_system *s, const bat_enclosure *e, int k, bat_regularity *out)
{
    /* Krawczyk's operator contracts by the departure; Newton's, of one equation, anyway. */
    const double most = s->equations == 1 ? 1 : 0.7;
    bat_interval others[BAT_EQUATIONS][BAT_EQUATIONS], row[BAT_EQUATIONS];
    take_others(s, e, k, others);
    if (!invert(s->equations, others, out->inverse))
        return false;
    out->departure = 0;
    out->strength = s->equations == 1 ? fabs(1 / out->inverse[0][0])
                                      : fabs(1 / (out->inverse[0][0] * out->inverse[1][1] -
                                                  out->inverse[0][1] * out->inverse[1][0]));
    for (int i = 0; i < s->equations; i++) {
        double sum = 0;
        find_departure(s->equations, out->inverse[i], others, i, row);
        for (int j = 0; j < s->equations; j++)
            sum = bat_above(sum + bat_interval_size(row[j]));
        out->departure = bat_max(out->departure, sum);
    }
    return out->departure < most;
}

/* ---- crossings ---- */

/* Row i of A times the derivatives by axis k. */
static bat_interval slope_along(const bat_system *s, const double a[BAT_EQUATIONS],
                                const bat_enclosure *e, int k)
{
    bat_interval sum = bat_interval_at(0);
    for (int c = 0; c < s->equations; c++)
        sum = bat_interval_add(sum, bat_interval_scale(a[c], e->slope[c][k]));
    return sum;
}

/* Newton's operator for one unknown j: c - (F(c) + what coordinate k adds) / F'(X); it takes at least half of
 * what is left, however much the derivative changes. */
static bool contract_single(bat_system *s, const bat_cell *x, int k, bat_cell *out)
{
    const bat_cell middle = middle_of(s, x);
    const int j = 1 - k;
    bat_enclosure over, there;
    bat_system_over(s, x, &over);
    bat_system_over(s, &middle, &there);
    if (bat_interval_holds_zero(over.slope[0][j]) || !bat_interval_is_finite(over.slope[0][j]))
        return false;
    const bat_interval along =
        bat_interval_multiply(over.slope[0][k], bat_interval_subtract(x->at[k], middle.at[k]));
    *out = *x;
    out->at[j] = bat_interval_subtract(
        middle.at[j],
        bat_interval_divide(bat_interval_add(there.value[0], along), over.slope[0][j]));
    return true;
}

/* Krawczyk's operator for the unknowns other than k: c - A F(c) + (I - A M)(X - c), and what coordinate k adds
 * where it is an interval. */
static bool contract(bat_system *s, const bat_cell *x, int k, bat_cell *out)
{
    if (s->equations == 1)
        return contract_single(s, x, k, out);
    const bat_cell middle = middle_of(s, x);
    bat_enclosure over, there;
    bat_interval others[BAT_EQUATIONS][BAT_EQUATIONS], row[BAT_EQUATIONS];
    double inverse[BAT_EQUATIONS][BAT_EQUATIONS];
    bat_system_over(s, x, &over);
    bat_system_over(s, &middle, &there);
    take_others(s, &over, k, others);
    if (!invert(s->equations, others, inverse))
        return false;
    *out = *x;
    for (int j = 0, i = 0; j < s->dimension; j++) {
        if (j == k)
            continue;
        bat_interval sum = middle.at[j];
        for (int c = 0; c < s->equations; c++)
            sum = bat_interval_subtract(sum, bat_interval_scale(inverse[i][c], there.value[c]));
        find_departure(s->equations, inverse[i], others, i, row);
        for (int l = 0, c = 0; l < s->dimension; l++) {
            const bat_interval slope =
                l == k ? bat_interval_negative(slope_along(s, inverse[i], &over, k)) : row[c++];
            const bat_interval change = bat_interval_subtract(x->at[l], middle.at[l]);
            sum = bat_interval_add(sum, bat_interval_multiply(slope, change));
        }
        out->at[j] = sum;
        i++;
    }
    return true;
}

static void take_middle(const bat_system *s, const bat_cell *x, int k, double *point,
                        double *radius)
{
    double sum = 0;
    for (int j = 0; j < s->dimension; j++) {
        point[j] = bat_interval_middle(x->at[j]);
        const double half = j == k ? 0 : 0.5 * bat_interval_width(x->at[j]);
        sum += half * half;
    }
    *radius = bat_above(sqrt(sum));
}

bat_crossing_count bat_find_crossing(bat_system *s, const bat_cell *cell, int k, double at,
                                     double *point, double *radius)
{
    /* Contraction is quadratic in the end; more than this much is a crossing too near to a corner. */
    enum { MOST = 40 };
    bat_cell x = *cell, image;
    bat_enclosure over;
    bool is_one = false;
    x.at[k] = bat_interval_at(at);
    bat_system_over(s, &x, &over);
    if (bat_cell_is_free(s, &x, &over))
        return BAT_NO_CROSSING;
    for (int step = 0; step < MOST; step++) {
        double before = 0, after = 0;
        bool inside = true;
        if (!contract(s, &x, k, &image))
            break;
        for (int j = 0; j < s->dimension; j++) {
            const bat_interval common = bat_interval_common(x.at[j], image.at[j]);
            if (j == k)
                continue;
            if (common.lo > common.hi)
                return BAT_NO_CROSSING;
            inside = inside && image.at[j].lo > x.at[j].lo && image.at[j].hi < x.at[j].hi;
            before += bat_interval_width(x.at[j]);
            after += bat_interval_width(common);
            x.at[j] = common;
        }
        is_one = is_one || inside;
        if (!(after < 0.9 * before))
            break;
    }
    take_middle(s, &x, k, point, radius);
    return is_one ? BAT_ONE_CROSSING : BAT_CROSSINGS_UNKNOWN;
}

bool bat_cell_tighten(bat_system *s, int k, bat_cell *cell)
{
    /* Each step that helps takes a tenth or more. */
    enum { MOST = 20 };
    bool helped = true;
    for (int step = 0; step < MOST && helped; step++) {
        bat_cell image;
        double before = 0, after = 0;
        if (!contract(s, cell, k, &image))
            return true;
        for (int j = 0; j < s->dimension; j++) {
            const bat_interval common = bat_interval_common(cell->at[j], image.at[j]);
            if (j == k)
                continue;
            if (common.lo > common.hi)
                return false;
            before += bat_interval_width(cell->at[j]);
            after += bat_interval_width(common);
            cell->at[j] = common;
        }
        helped = after < 0.9 * before;
    }
    return true;
}

/* ---- the tangent ---- */

void bat_curve_tangent(bat_system *s, const double *point, double *out)
{
    bat_cell cell;
    bat_enclosure e;
    double g[BAT_EQUATIONS][BAT_SPACE] = {{0}}, t[BAT_SPACE] = {0, 0, 0};
    for (int k = 0; k < s->dimension; k++)
        cell.at[k] = bat_interval_at(point[k]);
    bat_system_over(s, &cell, &e);
    for (int i = 0; i < s->equations; i++)
        for (int k = 0; k < s->dimension; k++)
            g[i][k] = bat_interval_middle(e.slope[i][k]);
    if (s->dimension == 2) {
        t[0] = -g[0][1];
        t[1] = g[0][0];
    } else {
        t[0] = g[0][1] * g[1][2] - g[0][2] * g[1][1];
        t[1] = g[0][2] * g[1][0] - g[0][0] * g[1][2];
        t[2] = g[0][0] * g[1][1] - g[0][1] * g[1][0];
    }
    const double length = sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    for (int k = 0; k < BAT_SPACE; k++)
        out[k] = length > 0 ? t[k] / length : 0;
}
