/* Taylor arithmetic over boxes: sums, products and quotients. */
#include "numeric/interval/jet.h"

#include <string.h>

/* ---- the space ---- */

/* Where the derivative of these orders stands; -1 beyond the order. */
static int place_of(const bat_jet_space *space, int i, int j, int k)
{
    for (int c = 0; c < space->count; c++)
        if (space->exponents[c][0] == i && space->exponents[c][1] == j &&
            space->exponents[c][2] == k)
            return c;
    return -1;
}

static void add_exponents(bat_jet_space *space, int total)
{
    for (int i = total; i >= 0; i--)
        for (int j = total - i; j >= 0; j--) {
            const int k = total - i - j;
            if ((j && space->variables < 2) || (k && space->variables < 3))
                continue;
            signed char *at = space->exponents[space->count++];
            at[0] = (signed char)i;
            at[1] = (signed char)j;
            at[2] = (signed char)k;
        }
}

void bat_jet_space_begin(bat_jet_space *space, int variables, int order)
{
    *space = (bat_jet_space){.variables = variables, .order = order};
    for (int total = 0; total <= order; total++)
        add_exponents(space, total);
    for (int a = 0; a < space->count; a++)
        for (int b = 0; b < space->count; b++) {
            const signed char *x = space->exponents[a], *y = space->exponents[b];
            space->product[a][b] =
                (signed char)place_of(space, x[0] + y[0], x[1] + y[1], x[2] + y[2]);
        }
}

/* ---- sums and products ---- */

void bat_ijet_constant(const bat_jet_space *s, bat_interval value, bat_interval_jet *out)
{
    memset(out->c, 0, (size_t)s->count * sizeof *out->c);
    out->c[0] = value;
}

void bat_ijet_variable(const bat_jet_space *s, int which, bat_interval range,
                       bat_interval_jet *out)
{
    bat_ijet_constant(s, range, out);
    if (s->order > 0)
        out->c[1 + which] = bat_interval_at(1);
}

void bat_ijet_add(const bat_jet_space *s, const bat_interval_jet *a, const bat_interval_jet *b,
                  bat_interval_jet *out)
{
    for (int i = 0; i < s->count; i++)
        out->c[i] = bat_interval_add(a->c[i], b->c[i]);
}

void bat_ijet_subtract(const bat_jet_space *s, const bat_interval_jet *a,
                       const bat_interval_jet *b, bat_interval_jet *out)
{
    for (int i = 0; i < s->count; i++)
        out->c[i] = bat_interval_subtract(a->c[i], b->c[i]);
}

static bool is_zero(bat_interval a)
{
    return a.lo == 0 && a.hi == 0;
}

void bat_ijet_multiply(const bat_jet_space *s, const bat_interval_jet *a,
                       const bat_interval_jet *b, bat_interval_jet *out)
{
    bat_interval_jet made;
    memset(made.c, 0, (size_t)s->count * sizeof *made.c);
    for (int i = 0; i < s->count; i++) {
        if (is_zero(a->c[i]))
            continue;
        for (int j = 0; j < s->count && s->product[i][j] >= 0; j++) {
            bat_interval *at = &made.c[s->product[i][j]];
            if (!is_zero(b->c[j]))
                *at = bat_interval_add(*at, bat_interval_multiply(a->c[i], b->c[j]));
        }
    }
    memcpy(out->c, made.c, (size_t)s->count * sizeof *out->c);
}

/* By Horner's scheme in what a has beyond its value. */
void bat_ijet_compose(const bat_jet_space *s, const bat_interval *g, bat_interval_jet *a)
{
    bat_interval_jet change = *a, made;
    change.c[0] = bat_interval_at(0);
    bat_ijet_constant(s, g[s->order], &made);
    for (int k = s->order - 1; k >= 0; k--) {
        bat_ijet_multiply(s, &made, &change, &made);
        made.c[0] = g[k];
    }
    memcpy(a->c, made.c, (size_t)s->count * sizeof *a->c);
}

void bat_ijet_forget(const bat_jet_space *s, int first, bat_interval_jet *a)
{
    for (int i = 0; i < s->count; i++)
        if (s->exponents[i][0] + s->exponents[i][1] + s->exponents[i][2] >= first)
            a->c[i] = BAT_EVERYTHING;
}

int bat_ijet_side(const bat_jet_space *s, const bat_interval_jet *a)
{
    if (s->side == 0 || s->variables > 1)
        return 0;
    int k = 0;
    while (k < s->count && is_zero(a->c[k]))
        k++;
    if (k == s->count || bat_interval_holds_zero(a->c[k]))
        return 0;
    return (a->c[k].lo > 0 ? 1 : -1) * (k % 2 ? s->side : 1);
}

/* ---- quotients ---- */

/* 1 / x and its derivatives: (-1)^k / x^(k + 1). */
void bat_ijet_divide(bat_jet_space *s, const bat_interval_jet *a, const bat_interval_jet *b,
                     bat_interval_jet *out)
{
    bat_interval g[BAT_JET_COEFFICIENTS];
    bat_interval_jet inverse = *b;
    if (bat_interval_holds_zero(b->c[0]) || !bat_interval_is_finite(b->c[0])) {
        bat_jet_space_meet(s, b->c[0].lo == 0 && b->c[0].hi == 0 ? BAT_UNDEFINED : BAT_PARTLY);
        bat_ijet_forget(s, 0, out);
        return;
    }
    for (int k = 0; k <= s->order; k++)
        g[k] = bat_interval_divide(bat_interval_at(k % 2 ? -1 : 1),
                                   bat_interval_power(b->c[0], k + 1));
    bat_ijet_compose(s, g, &inverse);
    bat_ijet_multiply(s, a, &inverse, out);
}

/* ---- the lesser of two ---- */

void bat_ijet_least(const bat_jet_space *s, const bat_interval_jet *a,
                    const bat_interval_jet *b, bat_interval_jet *out)
{
    bat_interval_jet made;
    bat_ijet_subtract(s, a, b, &made);
    const int side = bat_ijet_side(s, &made);
    if (side < 0 || (side == 0 && a->c[0].hi <= b->c[0].lo)) {
        *out = *a;
        return;
    }
    if (side > 0 || b->c[0].hi <= a->c[0].lo) {
        *out = *b;
        return;
    }
    for (int i = 0; i < s->count; i++)
        made.c[i] = bat_interval_hull(a->c[i], b->c[i]);
    made.c[0] =
        (bat_interval){bat_min(a->c[0].lo, b->c[0].lo), bat_min(a->c[0].hi, b->c[0].hi)};
    /* A corner: slopes are between those of the two, all further derivatives are gone. */
    bat_ijet_forget(s, 2, &made);
    *out = made;
}
