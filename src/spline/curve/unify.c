/*
 * Many curves with one degree and one knot vector.
 *
 * The distinct knots of all curves, mapped to [0, 1], are gathered into groups first; then each
 * curve's knots are moved onto its groups, and what it lacks is inserted. So the vectors are
 * the same bits, and no sliver of a span appears where two curves mean the same knot. Knots of
 * one curve are never joined.
 *
 * How far apart may the same knot be? A knot is stored within half an ulp of max(|a|, |b|),
 * both ends of its domain as well, and the mapping (u - a) / (b - a) rounds three times more.
 * So a knot is known within 2 eps (max(|a|, |b|) / (b - a) + 1) in [0, 1], and two curves may
 * differ by the sum of what is theirs. The value of the best known one is taken.
 */
#include "spline/curve/curve.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* A distinct knot of one curve. */
typedef struct {
    double value, doubt;
    int curve, times, group;
} entry;

/* A knot of the common vector. */
typedef struct {
    double value, doubt;
    int times;
} group;

typedef struct {
    int count, degree, entry_count, group_count;
    bool periodic, rational;
    const batten_curve *const *given;
    batten_curve **curves; /* [count] on the way to the common form */
    entry *entries;        /* [entry_count] curve after curve, each rising */
    entry **sorted;        /* [entry_count] */
    group *groups;         /* [group_count] */
    int *latest;           /* [count] the last group that a curve is in */
} unification;

/* ---- one degree, one domain ---- */

static void survey(unification *work)
{
    work->degree = 1;
    work->periodic = true;
    for (int i = 0; i < work->count; i++) {
        const batten_curve *curve = work->given[i];
        work->degree = bat_max_int(work->degree, curve->degree);
        work->periodic = work->periodic && curve->periodic;
        work->rational = work->rational || curve->weights;
    }
}

static batten_status prepare(const unification *work, const batten_curve *given,
                             batten_curve **out)
{
    batten_curve *open = NULL, *raised = NULL, *mapped = NULL;
    batten_status status = BATTEN_OK;
    if (work->periodic)
        open = batten_curve_ref(given);
    else
        status = batten_curve_clamp(given, &open);
    if (status == BATTEN_OK)
        status = batten_curve_elevate(open, work->degree - given->degree, &raised);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(raised, 0, 1, &mapped);
    if (status == BATTEN_OK && work->rational)
        status = batten_curve_to_rational(mapped, out);
    else if (status == BATTEN_OK)
        *out = batten_curve_ref(mapped);
    batten_curve_unref(mapped);
    batten_curve_unref(raised);
    batten_curve_unref(open);
    return status;
}

/* ---- the common knots ---- */

static void list_entries(unification *work)
{
    entry *next = work->entries;
    for (int c = 0; c < work->count; c++) {
        const batten_curve *curve = work->curves[c];
        const batten_interval domain = batten_curve_domain(work->given[c]);
        const double larger = bat_max(fabs(domain.a), fabs(domain.b));
        const double doubt = 2 * DBL_EPSILON * (larger / (domain.b - domain.a) + 1);
        const int p = curve->degree, n = curve->count;
        for (int i = p; i <= n; i++) {
            const double u = curve->knots[i];
            /* The end of a period is its start. */
            if ((i > p && u == curve->knots[i - 1]) || (work->periodic && u == curve->knots[n]))
                continue;
            const int times = bat_knots_multiplicity(p, n, curve->knots, u);
            *next++ = (entry){u, doubt, c, times, 0};
        }
    }
    work->entry_count = (int)(next - work->entries);
    for (int i = 0; i < work->entry_count; i++)
        work->sorted[i] = &work->entries[i];
}

static int by_value(const void *a, const void *b)
{
    const entry *x = *(entry *const *)a, *y = *(entry *const *)b;
    if (x->value != y->value)
        return x->value < y->value ? -1 : 1;
    return (x->curve > y->curve) - (x->curve < y->curve);
}

/* May the entries [first, end), all of one value, join the last group? */
static bool may_join(const unification *work, int first, int end, double doubt)
{
    if (work->group_count == 0)
        return false;
    const group *last = &work->groups[work->group_count - 1];
    if (work->sorted[first]->value - last->value > last->doubt + doubt)
        return false;
    for (int i = first; i < end; i++)
        if (work->latest[work->sorted[i]->curve] == work->group_count - 1)
            return false;
    return true;
}

static void join_group(unification *work, int first, int end)
{
    const double value = work->sorted[first]->value;
    double doubt = work->sorted[first]->doubt;
    for (int i = first; i < end; i++)
        doubt = bat_min(doubt, work->sorted[i]->doubt);
    if (!may_join(work, first, end, doubt))
        work->groups[work->group_count++] = (group){value, doubt, 0};
    group *last = &work->groups[work->group_count - 1];
    if (doubt < last->doubt) {
        last->value = value;
        last->doubt = doubt;
    }
    for (int i = first; i < end; i++) {
        entry *member = work->sorted[i];
        member->group = work->group_count - 1;
        work->latest[member->curve] = member->group;
        last->times = bat_max_int(last->times, member->times);
    }
}

static void make_groups(unification *work)
{
    qsort(work->sorted, (size_t)work->entry_count, sizeof *work->sorted, by_value);
    for (int i = 0; i < work->count; i++)
        work->latest[i] = -1;
    for (int first = 0, end; first < work->entry_count; first = end) {
        for (end = first + 1; end < work->entry_count; end++)
            if (work->sorted[end]->value != work->sorted[first]->value)
                break;
        join_group(work, first, end);
    }
}

static batten_status check_size(const unification *work)
{
    double knots = 0;
    for (int g = 0; g < work->group_count; g++)
        knots += work->groups[g].times;
    if (knots * work->count > BAT_MAX_MADE_POINTS)
        return bat_fail(
            BATTEN_TOO_LARGE,
            "%d curves with %.0f common knots have about %.3g control points; the limit is %d",
            work->count, knots, knots * work->count, BAT_MAX_MADE_POINTS);
    return BATTEN_OK;
}

/* ---- onto the common knots ---- */

/* Move the knots of a curve onto their groups; `entries` are its own. */
static batten_status snap(const unification *work, const entry *entries, batten_curve **curve)
{
    batten_curve *moved;
    const batten_status status = bat_curve_copy(*curve, &moved);
    if (status != BATTEN_OK)
        return status;
    const int p = moved->degree, n = moved->count;
    const int begin = work->periodic ? p : 0;
    int end = work->periodic ? n : n + p + 1;
    while (work->periodic && moved->knots[end - 1] == moved->knots[n])
        end--; /* the end of a period has no entry of its own and stays */
    for (int i = begin; i < end; i++) {
        while (entries->value < (*curve)->knots[i])
            entries++;
        moved->knots[i] = work->groups[entries->group].value;
    }
    if (work->periodic)
        bat_knots_wrap(p, n - p, moved->knots + p, moved->knots);
    batten_curve_unref(*curve);
    *curve = moved;
    return BATTEN_OK;
}

/* What the curve of these entries lacks, into `knots`. */
static int lacking(const unification *work, const entry *entries, const entry *end,
                   double *knots)
{
    int count = 0;
    for (int g = 0; g < work->group_count; g++) {
        int have = 0;
        if (entries < end && entries->group == g)
            have = entries++->times;
        for (; have < work->groups[g].times; have++)
            knots[count++] = work->groups[g].value;
    }
    return count;
}

static batten_status complete(const unification *work, int c, const entry *entries,
                              const entry *end, double *knots)
{
    batten_status status = snap(work, entries, &work->curves[c]);
    if (status != BATTEN_OK)
        return status;
    batten_curve *refined;
    const int count = lacking(work, entries, end, knots);
    status = batten_curve_refine(work->curves[c], count, knots, &refined);
    if (status != BATTEN_OK)
        return status;
    batten_curve_unref(work->curves[c]);
    work->curves[c] = refined;
    return BATTEN_OK;
}

static batten_status complete_all(unification *work)
{
    size_t most = 0;
    for (int g = 0; g < work->group_count; g++)
        most += (size_t)work->groups[g].times;
    double *knots = bat_array(most, sizeof *knots);
    batten_status status = knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    const entry *entries = work->entries, *last = work->entries + work->entry_count;
    for (int c = 0; status == BATTEN_OK && c < work->count; c++) {
        const entry *end = entries;
        while (end < last && end->curve == c)
            end++;
        status = complete(work, c, entries, end, knots);
        entries = end;
    }
    bat_release(knots);
    return status;
}

static batten_status make_entries(unification *work)
{
    size_t most = 0;
    for (int c = 0; c < work->count; c++)
        most += (size_t)batten_curve_spans(work->curves[c], NULL);
    if (most > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "the curves have %zu knots; the limit is %d", most,
                        BAT_MAX_POINTS);
    work->entries = bat_array(most, sizeof *work->entries);
    work->sorted = bat_array(most, sizeof *work->sorted);
    work->groups = bat_array(most, sizeof *work->groups);
    work->latest = bat_array((size_t)work->count, sizeof *work->latest);
    if (!work->entries || !work->sorted || !work->groups || !work->latest)
        return BATTEN_OUT_OF_MEMORY;
    list_entries(work);
    return BATTEN_OK;
}

static batten_status unify(unification *work)
{
    batten_status status = BATTEN_OK;
    survey(work);
    for (int c = 0; status == BATTEN_OK && c < work->count; c++)
        status = prepare(work, work->given[c], &work->curves[c]);
    if (status == BATTEN_OK)
        status = make_entries(work);
    if (status != BATTEN_OK)
        return status;
    make_groups(work);
    status = check_size(work);
    return status == BATTEN_OK ? complete_all(work) : status;
}

batten_status batten_curves_unify(int count, const batten_curve *const *curves,
                                  batten_curve **out)
{
    assert(count >= 0 && (count == 0 || (curves && out)));
    unification work = {.count = count, .given = curves};
    work.curves = bat_array((size_t)count, sizeof *work.curves);
    if (!work.curves)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = unify(&work);
    for (int c = 0; c < count; c++) {
        if (status == BATTEN_OK)
            out[c] = work.curves[c];
        else
            batten_curve_unref(work.curves[c]);
    }
    bat_release(work.curves);
    bat_release(work.entries);
    bat_release(work.sorted);
    bat_release(work.groups);
    bat_release(work.latest);
    return status;
}
