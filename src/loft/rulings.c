/*
 * The rulings of a plank: from each of equal steps along its lower line to that place of the upper
 * at which the normals at both ends of the ruling differ least, by dynamic program over places of
 * the upper line, so that none crosses another; then to where they agree.
 */
#include "base/elementary.h"
#include "loft/planks.h"
#include "numeric/vector.h"

/* Places along the upper line; bisections of one step, to rounding. */
enum { N = BAT_PLANK_RULINGS, PLACES = 801, HALVINGS = 45 };

/* A ruling leads along the hull by at most this share of the lines, and a little is asked for it:
 * the square of the share, with this weight, against that of the sine. Plates whose rulings lean
 * more are cones about one end. */
static const double farthest = 0.12, lean_weight = 0.02;

/* What a ruling costs at which the plank turns over, above all sines. */
static const double cost_of_turning = 2;

bool bat_hull_is_plank(const bat_hull_rails *r, int low)
{
    const int n = r->of.station_count;
    int k = 0;
    while (k < n && r->at[(low + 1) * n + k] == r->at[low * n + k] + 1)
        k++;
    return k == n;
}

/* A place of a rail, and its derivative by u. */
typedef struct {
    double at[3], by_u[3];
} rail_place;

static void find_place(const bat_hull_rails *r, int rail, double u, rail_place *out)
{
    const bat_hull_rail *of = r->rails + rail;
    out->at[0] = (1 - u) * of->x[0] + u * of->x[1];
    out->by_u[0] = of->x[1] - of->x[0];
    for (int axis = 0; axis < 2; axis++) {
        const bat_loft_line *line = r->lines + 2 * rail + axis;
        out->at[axis + 1] = bat_loft_line_at(line, of->yz[axis], u, 0);
        out->by_u[axis + 1] = bat_loft_line_at(line, of->yz[axis], u, 1);
    }
}

double bat_plank_warp(const bat_plank_ruling *ruling)
{
    return bat_atan2(fabs(ruling->sine), ruling->cosine);
}

/* The warp between two places; turned over where one has no normal. */
static void measure_warp(const rail_place *a, const rail_place *b, bat_plank_ruling *ruling)
{
    double along[3], normal[2][3], both[3];
    for (int c = 0; c < 3; c++)
        along[c] = b->at[c] - a->at[c];
    bat_cross(a->by_u, along, normal[0]);
    bat_cross(b->by_u, along, normal[1]);
    const double sizes = bat_norm(3, normal[0]) * bat_norm(3, normal[1]),
                 length = bat_norm(3, along);
    bat_cross(normal[0], normal[1], both);
    ruling->sine = sizes > 0 ? bat_dot(3, both, along) / (length * sizes) : 0;
    ruling->cosine = sizes > 0 ? bat_dot(3, normal[0], normal[1]) / sizes : -1;
}

/* ---- the dynamic program ---- */

typedef struct {
    const bat_hull_rails *rails;
    int low;
    bat_arena arena;
    rail_place *upper; /* [PLACES] */
    double *sum;       /* [PLACES]: of the best path to each */
    int16_t *from;     /* [N][PLACES]: by which place of the ruling before */
} search;

static double place_of(int j)
{
    return (double)j / (PLACES - 1);
}

static double cost_of(const search *s, const rail_place *lower, double u, int j)
{
    bat_plank_ruling ruling;
    const double lean = place_of(j) - u;
    if (fabs(lean) > farthest)
        return HUGE_VAL;
    measure_warp(lower, s->upper + j, &ruling);
    return lean_weight * lean * lean +
           (ruling.cosine > 0 ? ruling.sine * ruling.sine : cost_of_turning);
}

/* The sums of the paths to the places of ruling i, from those of the one before. */
static void extend_paths(search *s, int i)
{
    rail_place lower;
    const double u = (double)i / (N - 1);
    double least = HUGE_VAL;
    int at = 0;
    find_place(s->rails, s->low, u, &lower);
    for (int j = 0; j < PLACES; j++) {
        if (i == 0)
            least = 0;
        else if (s->sum[j] < least) {
            least = s->sum[j];
            at = j;
        }
        s->from[(size_t)i * PLACES + (size_t)j] = (int16_t)at;
        s->sum[j] = least + cost_of(s, &lower, u, j);
    }
}

static void trace_back(const search *s, int places[N])
{
    int j = 0;
    for (int k = 1; k < PLACES; k++)
        if (s->sum[k] < s->sum[j])
            j = k;
    for (int i = N - 1; i >= 0; i--) {
        places[i] = j;
        j = s->from[(size_t)i * PLACES + (size_t)j];
    }
}

/* ---- roots ---- */

static void set_ruling(const search *s, double u, double w, bat_plank_ruling *out)
{
    rail_place lower, upper;
    find_place(s->rails, s->low, u, &lower);
    find_place(s->rails, s->low + 1, w, &upper);
    *out = (bat_plank_ruling){.u = u, .w = w};
    measure_warp(&lower, &upper, out);
}

/* Where the warp is 0 between two rulings of the same u, if its sign changes. */
static bool find_root(const search *s, bat_plank_ruling a, bat_plank_ruling b,
                      bat_plank_ruling *out)
{
    const double rounding = 1e-12;
    if (a.cosine <= 0 || b.cosine <= 0)
        return false;
    if (a.sine * b.sine > 0 && fabs(a.sine) > rounding && fabs(b.sine) > rounding)
        return false;
    for (int k = 0; k < HALVINGS && fabs(a.sine) > rounding && fabs(b.sine) > rounding; k++) {
        bat_plank_ruling middle;
        set_ruling(s, a.u, (a.w + b.w) / 2, &middle);
        if (middle.sine * a.sine > 0)
            a = middle;
        else
            b = middle;
    }
    *out = fabs(a.sine) <= fabs(b.sine) ? a : b;
    return true;
}

/* The ruling at place j, or at the root nearest to it, but not before `least`: what rulings are
 * asked for their lean takes them some places off. */
static void refine_ruling(const search *s, double u, int j, double least, bat_plank_ruling *out)
{
    enum { REACH = 8 };
    bat_plank_ruling beside[2];
    bool found = false;
    set_ruling(s, u, place_of(j), out);
    beside[0] = beside[1] = *out;
    for (int k = 1; k <= REACH && !found; k++)
        for (int side = 0; side < 2 && !found; side++) {
            const int at = side ? j + k : j - k;
            const bat_plank_ruling before = beside[side];
            if (at < 0 || at >= PLACES)
                continue;
            set_ruling(s, u, place_of(at), beside + side);
            found = find_root(s, before, beside[side], out);
        }
    if (out->w < least)
        set_ruling(s, u, least, out);
}

batten_status bat_plank_find_rulings(const bat_hull_rails *rails, int low,
                                     bat_plank_ruling *out)
{
    search s = {.rails = rails, .low = low};
    int places[N];
    s.upper = bat_arena_array(&s.arena, PLACES, sizeof *s.upper);
    s.sum = bat_arena_array(&s.arena, PLACES, sizeof *s.sum);
    s.from = bat_arena_array(&s.arena, (size_t)N * PLACES, sizeof *s.from);
    if (s.upper && s.sum && s.from) {
        for (int j = 0; j < PLACES; j++)
            find_place(rails, low + 1, place_of(j), s.upper + j);
        for (int i = 0; i < N; i++)
            extend_paths(&s, i);
        trace_back(&s, places);
        for (int i = 0; i < N; i++)
            refine_ruling(&s, (double)i / (N - 1), places[i], i > 0 ? out[i - 1].w : 0,
                          out + i);
    }
    const batten_status status = bat_arena_status(&s.arena);
    bat_arena_free(&s.arena);
    return status;
}
