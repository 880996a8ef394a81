/* Signs of the invariants of a cubic, decided exactly where floating point cannot. */
#include "inspect/affine/cubic.h"
#include "numeric/vector.h"

#include <string.h>

/* ---- forms: coefficients of A, B, C, or of A^2, B^2, C^2, A B, A C, B C ---- */

enum { QUADRATIC = BAT_FORM_D, TERMS = 6 };

static const double coefficients[BAT_FORM_COUNT][TERMS] = {
    {1, 0, 0},           {0, 1, 0},  {0, 0, 1},           {1, -1, 1},
    {2, -1, 0},          {0, -1, 2}, {0, 1, 0, 0, -4, 0}, {1, 1, 0, -1, -3, 0},
    {0, 1, 1, 0, -3, -1}};

static const int factors[TERMS][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

/* The same forms of three numbers, with the sum of the sizes of their terms. */
double bat_cubic_value(int form, const double *abc, double *size)
{
    double sum = 0;
    *size = 0;
    for (int k = 0; k < (form < QUADRATIC ? 3 : TERMS); k++) {
        if (coefficients[form][k] == 0)
            continue;
        const double term =
            coefficients[form][k] *
            (form < QUADRATIC ? abc[k] : abc[factors[k][0]] * abc[factors[k][1]]);
        sum += term;
        *size += fabs(term);
    }
    return sum;
}

static int form_sign(int form, const bat_exact *abc)
{
    bat_exact sum = {.count = 0};
    for (int k = 0; k < (form < QUADRATIC ? 3 : TERMS); k++) {
        if (coefficients[form][k] == 0)
            continue;
        if (form < QUADRATIC)
            bat_exact_add(&sum, coefficients[form][k], &abc[k]);
        else
            bat_exact_add_product(&sum, coefficients[form][k], &abc[factors[k][0]],
                                  &abc[factors[k][1]]);
    }
    return bat_exact_sign(&sum);
}

/* ---- what the signs say ---- */

batten_cubic_class bat_cubic_segment_class(const int *s)
{
    const int ends = s[BAT_FORM_A] * s[BAT_FORM_C], a = s[BAT_FORM_A];
    if (ends < 0)
        return BATTEN_CUBIC_ONE_INFLECTION;
    /* One end is flat: the other root of P' x P'' is that of a linear function. */
    if (ends == 0)
        return (a ? a : s[BAT_FORM_C]) * s[BAT_FORM_B] < 0 ? BATTEN_CUBIC_ONE_INFLECTION
                                                           : BATTEN_CUBIC_PLAIN;
    if (s[BAT_FORM_D] >= 0 && a * s[BAT_FORM_B] < 0)
        return s[BAT_FORM_D] > 0 ? BATTEN_CUBIC_TWO_INFLECTIONS : BATTEN_CUBIC_CUSP;
    if (s[BAT_FORM_D] < 0 && a * s[BAT_FORM_FIRST] > 0 && a * s[BAT_FORM_LAST] > 0 &&
        s[BAT_FORM_RETURN] > 0 && s[BAT_FORM_LEAVE] > 0)
        return BATTEN_CUBIC_LOOP;
    return BATTEN_CUBIC_PLAIN;
}

batten_cubic_class bat_cubic_whole_class(const int *s)
{
    if (s[BAT_FORM_LEAD] == 0)
        return s[BAT_FORM_FIRST] ? BATTEN_CUBIC_EXPLICIT : BATTEN_CUBIC_PARABOLA;
    if (s[BAT_FORM_D] == 0)
        return BATTEN_CUBIC_CUSP;
    return s[BAT_FORM_D] > 0 ? BATTEN_CUBIC_TWO_INFLECTIONS : BATTEN_CUBIC_LOOP;
}

/* How near the nearest form is to 0, of those whose sign matters. */
double bat_cubic_margin(const int *signs, const double *relative,
                        batten_cubic_class (*decide)(const int *))
{
    const batten_cubic_class kind = decide(signs);
    double margin = 1;
    for (int k = 0; k < BAT_FORM_COUNT; k++) {
        int other[BAT_FORM_COUNT];
        memcpy(other, signs, sizeof other);
        for (int value = -1; value <= 1 && relative[k] < margin; value++) {
            other[k] = value;
            if (decide(other) != kind)
                margin = relative[k];
        }
    }
    return margin;
}

/* ---- one cubic at work ---- */

static const int pairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};

void bat_cubic_begin(bat_cubic *c)
{
    c->longest = 0;
    c->has_exact = false;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 2; k++)
            c->edge[i][k] = c->point[i + 1][k] - c->point[i][k];
        c->longest = bat_max(c->longest, bat_hypot(c->edge[i][0], c->edge[i][1]));
    }
    for (int k = 0; k < 3; k++) {
        const double *d = c->edge[pairs[k][0]], *e = c->edge[pairs[k][1]];
        c->abc[k] = d[0] * e[1] - d[1] * e[0];
        /* Each product has three roundings of 2^-53, those of the edges and its own; the
         * difference one more. */
        c->bound[k] = 4.5 * 0x1p-53 * (fabs(d[0] * e[1]) + fabs(d[1] * e[0]));
    }
}

static const bat_exact *exact_of(bat_cubic *c)
{
    for (int k = 0; k < 3 && !c->has_exact; k++) {
        bat_exact d[2], e[2];
        for (int j = 0; j < 2; j++) {
            d[j] = bat_exact_difference(c->point[pairs[k][0] + 1][j], c->point[pairs[k][0]][j]);
            e[j] = bat_exact_difference(c->point[pairs[k][1] + 1][j], c->point[pairs[k][1]][j]);
        }
        c->exact[k].count = 0;
        bat_exact_add_product(&c->exact[k], 1, &d[0], &e[1]);
        bat_exact_add_product(&c->exact[k], -1, &d[1], &e[0]);
    }
    c->has_exact = true;
    return c->exact;
}

/* How far a form may be from its value: by the bounds of A, B, C, and its own rounding. */
static double form_bound(int form, const bat_cubic *c, double size)
{
    double sum = 0;
    for (int k = 0; k < (form < QUADRATIC ? 3 : TERMS); k++) {
        const double f = fabs(coefficients[form][k]);
        const int i = factors[k][0], j = factors[k][1];
        if (form < QUADRATIC)
            sum += f * c->bound[k];
        else
            sum += f * (fabs(c->abc[i]) * c->bound[j] + fabs(c->abc[j]) * c->bound[i] +
                        c->bound[i] * c->bound[j]);
    }
    return 1.001 * sum + 8 * 0x1p-53 * size;
}

int bat_cubic_sign(bat_cubic *c, int form, double tolerance, double *relative)
{
    double size;
    const double value = bat_cubic_value(form, c->abc, &size);
    /* A, B, C alone are measured against each other. */
    if (form <= BAT_FORM_C)
        size = fabs(c->abc[0]) + fabs(c->abc[1]) + fabs(c->abc[2]);
    *relative = size > 0 ? fabs(value) / size : 0;
    if (tolerance > 0 && fabs(value) <= tolerance * size) {
        *relative = 0;
        return 0;
    }
    if (fabs(value) > form_bound(form, c, size))
        return value > 0 ? 1 : -1;
    const int sign = form_sign(form, exact_of(c));
    if (sign == 0)
        *relative = 0;
    return sign;
}

bool bat_cubic_is_line(bat_cubic *c, double tolerance)
{
    if (bat_largest(3, c->abc) > tolerance * c->longest * c->longest && tolerance > 0)
        return false;
    for (int k = 0; k < 3 && tolerance == 0; k++)
        if (fabs(c->abc[k]) > c->bound[k] || bat_exact_sign(&exact_of(c)[k]) != 0)
            return false;
    return true;
}

/* (d1 x d2) . d3 of the scaled points; its exact sign where rounding could have made it. */
bool bat_cubic_has_volume(double p[4][3], double tolerance, double *relative)
{
    double d[3][3], longest = 0, volume = 0, size = 0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            d[i][k] = p[i + 1][k] - p[i][k];
        longest = bat_max(longest, bat_norm(3, d[i]));
    }
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        volume += d[2][k] * (d[0][i] * d[1][j] - d[0][j] * d[1][i]);
        size += fabs(d[2][k]) * (fabs(d[0][i] * d[1][j]) + fabs(d[0][j] * d[1][i]));
    }
    *relative = longest > 0 ? fabs(volume) / (longest * longest * longest) : 0;
    if (*relative <= tolerance && tolerance > 0)
        return false;
    if (fabs(volume) > 10 * 0x1p-53 * size)
        return true;
    bat_exact sum = {.count = 0};
    for (int k = 0; k < 6; k++) {
        const int x = k % 3, y = (x + (k < 3 ? 1 : 2)) % 3, z = 3 - x - y;
        const bat_exact a = bat_exact_difference(p[1][x], p[0][x]);
        const bat_exact b = bat_exact_difference(p[2][y], p[1][y]);
        const bat_exact e = bat_exact_difference(p[3][z], p[2][z]);
        bat_exact product = {.count = 0};
        bat_exact_add_product(&product, 1, &a, &b);
        bat_exact_add_product(&sum, k < 3 ? 1 : -1, &product, &e);
    }
    return bat_exact_sign(&sum) != 0;
}
