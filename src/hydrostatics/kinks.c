/* Kinks of integrals over rows: turns of the waterline are found by halving pieces of a patch in
 * which neither the height nor its derivative along the rows keeps its sign. */
#include "hydrostatics/kinks.h"
#include "base/sort.h"
#include "numeric/bernstein.h"

#include <string.h>

/* Pieces that may have a turn are halved to this width; so many are looked at. */
static const double TURN_WIDTH = 1e-9, ROW_WIDTH = 1e-14;
enum { MOST_WAITING = 128, MOST_PIECES = 3000 };

/* A part of a patch, with rows numbered first. */
typedef struct {
    batten_interval rows, along;
    double *heights; /* [degree of rows + 1][degree along + 1] */
} piece;

typedef struct {
    int degree[2]; /* across the rows, along them */
    piece waiting[MOST_WAITING];
} search;

/* ---- turns ---- */

static bool may_turn(const search *s, const piece *p)
{
    const int columns = s->degree[1] + 1, size = (s->degree[0] + 1) * columns;
    bool low = false, high = false, falls = false, rises = false;
    for (int i = 0; i < size; i++) {
        const double step = i % columns > 0 ? p->heights[i] - p->heights[i - 1] : 0;
        low |= p->heights[i] <= 0;
        high |= p->heights[i] >= 0;
        rises |= i % columns > 0 && step >= 0;
        falls |= i % columns > 0 && step <= 0;
    }
    return low && high && falls && rises;
}

static bool is_narrow(const piece *p)
{
    const double rows = p->rows.b - p->rows.a, along = p->along.b - p->along.a;
    return rows < ROW_WIDTH || (rows < TURN_WIDTH && along < TURN_WIDTH);
}

/* The first half stays in its place, the other one goes to the next. */
static void halve(const search *s, piece *p, piece *other)
{
    const bool rows = p->rows.b - p->rows.a >= p->along.b - p->along.a;
    const int columns = s->degree[1] + 1, degree = s->degree[!rows];
    const int step = rows ? columns : 1, next = rows ? 1 : columns;
    for (int k = 0; k <= s->degree[rows]; k++) {
        double row[BATTEN_MAX_DEGREE + 1], low[BATTEN_MAX_DEGREE + 1],
            high[BATTEN_MAX_DEGREE + 1];
        for (int i = 0; i <= degree; i++)
            row[i] = p->heights[k * next + i * step];
        bat_bernstein_split(degree, row, 0.5, low, high);
        for (int i = 0; i <= degree; i++) {
            p->heights[k * next + i * step] = low[i];
            other->heights[k * next + i * step] = high[i];
        }
    }
    other->rows = p->rows;
    other->along = p->along;
    batten_interval *first = rows ? &p->rows : &p->along,
                    *second = rows ? &other->rows : &other->along;
    first->b = second->a = 0.5 * (first->a + first->b);
}

static int find_turns(search *s, double turns[BAT_MOST_TURNS])
{
    int waiting = 1, found = 0;
    for (int looked = 0; waiting > 0 && looked < MOST_PIECES && found < BAT_MOST_TURNS;
         looked++) {
        piece *p = &s->waiting[waiting - 1];
        if (!may_turn(s, p))
            waiting--;
        else if (is_narrow(p)) {
            turns[found++] = 0.5 * (p->rows.a + p->rows.b);
            waiting--;
        } else if (waiting < MOST_WAITING)
            halve(s, p, &s->waiting[waiting++]);
        else
            break;
    }
    return found;
}

static void begin_search(const bat_patch *patch, batten_direction constant,
                         const bat_water *water, search *s)
{
    const int columns = patch->degree[1] + 1;
    for (int i = 0; i <= s->degree[0]; i++)
        for (int j = 0; j <= s->degree[1]; j++) {
            const int place = constant == BATTEN_U ? i * columns + j : j * columns + i;
            const double *p = patch->points + 4 * place, *n = water->n;
            s->waiting[0].heights[i * (s->degree[1] + 1) + j] =
                n[0] * p[0] + n[1] * p[1] + n[2] * p[2] - water->d * p[3];
        }
    s->waiting[0].rows = s->waiting[0].along = (batten_interval){0, 1};
}

static batten_status add_turns(const bat_patch *patch, batten_direction constant,
                               const bat_water *water, double *turns, int *count)
{
    bat_arena arena = {0};
    search *s = bat_arena_array(&arena, 1, sizeof *s);
    if (!s)
        return BATTEN_OUT_OF_MEMORY;
    s->degree[0] = patch->degree[constant];
    s->degree[1] = patch->degree[!constant];
    const size_t size = (size_t)(s->degree[0] + 1) * (size_t)(s->degree[1] + 1);
    double *heights = bat_arena_array(&arena, MOST_WAITING * size, sizeof *heights);
    if (heights) {
        for (size_t i = 0; i < MOST_WAITING; i++)
            s->waiting[i].heights = heights + i * size;
        begin_search(patch, constant, water, s);
        *count += find_turns(s, turns);
    }
    bat_arena_free(&arena);
    return heights ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* ---- all ---- */

batten_status bat_find_kinks(const bat_patch *patch, batten_direction constant,
                             const bat_water *water, double kinks[BAT_MOST_KINKS], int *count)
{
    batten_status status = BATTEN_OK;
    *count = 0;
    kinks[(*count)++] = 0;
    for (int end = 0; end < 2 && status == BATTEN_OK; end++) {
        bat_row row;
        double heights[BATTEN_MAX_DEGREE + 1];
        int found = 0;
        bat_patch_row(patch, (batten_direction)!constant, end, &row);
        bat_row_heights(&row, water->n, water->d, heights);
        status = bat_row_roots(row.degree, heights, kinks + *count, &found);
        *count += found;
    }
    if (status == BATTEN_OK)
        status = add_turns(patch, constant, water, kinks + *count, count);
    kinks[(*count)++] = 1;
    bat_sort_doubles((size_t)*count, kinks);
    return status;
}

/* ---- their last digits ---- */

static batten_status count_crossings(const bat_patch *patch, batten_direction constant,
                                     const bat_water *water, double t, int *count)
{
    bat_row row;
    double heights[BATTEN_MAX_DEGREE + 1], roots[BATTEN_MAX_DEGREE];
    bat_patch_row(patch, constant, t, &row);
    bat_row_heights(&row, water->n, water->d, heights);
    return bat_row_roots(row.degree, heights, roots, count);
}

/* Where the number of crossings changes in `around`; its middle where it is the same at both ends. */
static batten_status find_change(const bat_patch *patch, batten_direction constant,
                                 const bat_water *water, batten_interval around, double *kink)
{
    int low = 0, high = 0, count = 0;
    batten_status status = count_crossings(patch, constant, water, around.a, &low);
    if (status == BATTEN_OK)
        status = count_crossings(patch, constant, water, around.b, &high);
    *kink = 0.5 * (around.a + around.b);
    while (status == BATTEN_OK && low != high && *kink > around.a && *kink < around.b) {
        status = count_crossings(patch, constant, water, *kink, &count);
        *(count == low ? &around.a : &around.b) = *kink;
        *kink = 0.5 * (around.a + around.b);
    }
    return status;
}

batten_status bat_sharpen_kinks(const bat_patch *patch, batten_direction constant,
                                const bat_water *water, double kinks[BAT_MOST_KINKS],
                                int *count)
{
    double sharp[BAT_MOST_KINKS] = {0};
    int kept = 1;
    batten_status status = BATTEN_OK;
    for (int i = 1, next; i + 1 < *count && status == BATTEN_OK; i = next) {
        for (next = i + 1; next + 1 < *count && kinks[next] - kinks[next - 1] < 4 * TURN_WIDTH;)
            next++;
        const batten_interval around = {bat_max(0, kinks[i] - 2 * TURN_WIDTH),
                                        bat_min(1, kinks[next - 1] + 2 * TURN_WIDTH)};
        status = find_change(patch, constant, water, around, &sharp[kept++]);
    }
    if (status != BATTEN_OK)
        return status;
    sharp[kept++] = 1;
    memcpy(kinks, sharp, (size_t)kept * sizeof *kinks);
    *count = kept;
    return BATTEN_OK;
}
