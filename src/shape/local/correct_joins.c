/*
 * Curvatures brought together at the joins of corrected spans.
 *
 * A span with given directions and curvatures at both ends is a solution of the equations of de
 * Boor, Hollig and Sabin. So each join gets a few curvatures to choose from, and for every pair
 * of choices a span either has legs without excess or has none; the best choice for all joins
 * together is then a shortest path along the curve. At a join where nothing fits, curvature
 * jumps; that is the last resort.
 */
#include "numeric/vector.h"
#include "shape/local/correct_tangents.h"
#include "shape/local/curvature_ends.h"

#include <string.h>

/* Most curvatures of a join; one more choice is to let it jump. */
enum { CURVATURES = 13, CHOICES = CURVATURES + 1 };

/* Legs below this part of the way to T bend as sharply as what they are to cure. */
static const double shortest = 0.1;
/* What a jump costs: more than all change of legs that is allowed. */
static const double jump_cost = 1000;

typedef struct {
    bat_legs legs;
    float cost; /* HUGE_VALF: cannot be */
} option;

typedef struct {
    int count;             /* of curvatures; choice `count` is to jump */
    double left, right;    /* curvature of the spans beside it now */
    double at[CURVATURES]; /* to choose from */
    bool may_jump;         /* without cost: it jumped from the beginning, or is a free end */
} join;

typedef struct {
    bat_correction *w;
    join *joins;       /* [count + 1]; of a closed curve the last is the first */
    size_t *first;     /* [count + 1] where the options of each span begin */
    option *options;   /* for each span [choices at its start][choices at its end] */
    double *best;      /* [count + 1][CHOICES] the cheapest way to each choice */
    signed char *from; /* [count + 1][CHOICES] the choice before */
    signed char *path; /* [count + 1] */
} joining;

/* ---- choices ---- */

/* Is a span changed within `reach` spans of join j? */
static bool is_near(const bat_correction *w, int j, int reach)
{
    for (int k = j - reach; k < j + reach; k++) {
        const int i = w->closed ? (k % w->count + w->count) % w->count : k;
        if (i >= 0 && i < w->count && w->changed[i])
            return true;
    }
    return false;
}

static void choose(const bat_correction *w, int j, join *out)
{
    const bool first = j == 0, last = j == w->count, free = !w->closed && (first || last);
    const int left = first ? w->count - 1 : j - 1, right = last ? 0 : j;
    const double a = bat_correction_bend(w, left, 1), b = bat_correction_bend(w, right, 0);
    const double own = first ? w->bends[2 * right] : w->bends[2 * left + 1];
    *out = (join){.left = free && first ? b : a, .right = free && last ? a : b};
    const double l = out->left, r = out->right, mean = (l + r) / 2;
    const double choices[CURVATURES] = {
        l,       r,     own,     mean,    (3 * l + r) / 4, (l + 3 * r) / 4,
        l / 2,   r / 2, own / 2, 2 * own, mean / 4,        copysign(sqrt(fabs(l * r)), mean),
        2 * mean};
    const bool agrees = fabs(l - r) <= bat_correction_agree * bat_max(fabs(l), fabs(r));
    out->may_jump = free || !(fabs(w->bends[2 * left + 1] - w->bends[2 * right]) <=
                              bat_correction_agree * fabs(own));
    out->count = is_near(w, j, 2) ? CURVATURES : agrees;
    for (int k = 0; k < out->count; k++)
        out->at[k] = choices[k];
}

/* Curvature of a span at an end where its join has made a choice. */
static double curvature_at(const join *j, int choice, int end)
{
    return choice < j->count ? j->at[choice] : end ? j->left : j->right;
}

/* ---- one span ---- */

typedef struct {
    double t0[2], t1[2], chord[2];
    bat_legs legs; /* as they are */
    bool solvable;
} shape;

static shape shape_of(const bat_correction *w, int i)
{
    shape s = {.solvable = w->spans[i].has_tangents};
    const double *p = bat_correction_point(w, 3 * i);
    for (int k = 0; k < 2; k++) {
        s.t0[k] = p[2 + k] - p[k];
        s.t1[k] = p[6 + k] - p[4 + k];
        s.chord[k] = p[6 + k] - p[k];
    }
    s.legs = (bat_legs){bat_norm(2, s.t0), bat_norm(2, s.t1)};
    s.solvable = s.solvable && s.legs.start > 0 && s.legs.end > 0;
    for (int k = 0; k < 2 && s.solvable; k++) {
        s.t0[k] /= s.legs.start;
        s.t1[k] /= s.legs.end;
    }
    return s;
}

/* How much legs change; infinite where they bring excess, or are hardly there. */
static double cost_of(const bat_correction *w, int i, const shape *s, const bat_legs *legs)
{
    batten_cubic_place place;
    const batten_cubic *c = &w->spans[i];
    /* lambda and mu are proportional to the legs; as given they were these */
    const double lambda = c->lambda * legs->start / w->legs[2 * i];
    const double mu = c->mu * legs->end / w->legs[2 * i + 1];
    if (batten_cubic_look_up(lambda, mu, &place) != BATTEN_OK ||
        bat_correction_is_bad(place.region) || fmin(fabs(lambda), fabs(mu)) < shortest)
        return HUGE_VAL;
    const double a = bat_log(legs->start / s->legs.start), b = bat_log(legs->end / s->legs.end);
    return a * a + b * b;
}

static option solve(const bat_correction *w, int i, const shape *s, double start, double end)
{
    option best = {s->legs, HUGE_VALF};
    bat_legs legs[BAT_DBHS_SOLUTIONS];
    if (start == bat_correction_bend(w, i, 0) && end == bat_correction_bend(w, i, 1))
        return (option){s->legs, 0};
    const int count = s->solvable ? bat_dbhs(s->t0, s->t1, s->chord, start, end, legs) : 0;
    for (int k = 0; k < count; k++) {
        const double cost = cost_of(w, i, s, &legs[k]);
        if (cost < (double)best.cost)
            best = (option){legs[k], (float)cost};
    }
    return best;
}

static option *option_of(const joining *t, int i, int x, int y)
{
    return t->options + t->first[i] + (size_t)(x * (t->joins[i + 1].count + 1) + y);
}

static void fill_options(joining *t, int i)
{
    const join *a = &t->joins[i], *b = &t->joins[i + 1];
    const shape s = shape_of(t->w, i);
    for (int x = 0; x <= a->count; x++)
        for (int y = 0; y <= b->count; y++)
            *option_of(t, i, x, y) =
                solve(t->w, i, &s, curvature_at(a, x, 0), curvature_at(b, y, 1));
}

/* ---- all of them ---- */

static double price(const join *j, int choice)
{
    return choice == j->count && !j->may_jump ? jump_cost : 0;
}

/* The cheapest ways from choice `begin` of the first join (any: -1); of a closed curve back to
 * it. Returns the cost, and fills the path. */
static double find_path(joining *t, int begin)
{
    const int n = t->w->count;
    for (int y = 0; y <= t->joins[0].count; y++)
        t->best[y] = begin < 0 || y == begin ? price(&t->joins[0], y) : HUGE_VAL;
    for (int i = 0; i < n; i++)
        for (int y = 0; y <= t->joins[i + 1].count; y++) {
            double *best = &t->best[(i + 1) * CHOICES + y];
            *best = HUGE_VAL;
            for (int x = 0; x <= t->joins[i].count; x++) {
                const double cost =
                    t->best[i * CHOICES + x] + (double)option_of(t, i, x, y)->cost;
                if (!(cost < *best))
                    continue;
                *best = cost;
                t->from[(i + 1) * CHOICES + y] = (signed char)x;
            }
            if (i + 1 < n || begin < 0)
                *best += price(&t->joins[i + 1], y);
        }
    int last = begin < 0 ? 0 : begin;
    for (int y = 1; begin < 0 && y <= t->joins[n].count; y++)
        if (t->best[n * CHOICES + y] < t->best[n * CHOICES + last])
            last = y;
    t->path[n] = (signed char)last;
    for (int i = n; i > 0; i--)
        t->path[i - 1] = t->from[i * CHOICES + t->path[i]];
    return t->best[n * CHOICES + last];
}

static void find_best_path(joining *t)
{
    if (!t->w->closed) {
        find_path(t, -1);
        return;
    }
    int best = t->joins[0].count; /* letting all joins jump is always a way */
    double least = HUGE_VAL;
    for (int begin = 0; begin <= t->joins[0].count; begin++) {
        const double cost = find_path(t, begin);
        if (cost < least) {
            least = cost;
            best = begin;
        }
    }
    find_path(t, best);
}

static void set_legs(joining *t, int i)
{
    bat_correction *w = t->w;
    const shape s = shape_of(w, i);
    const option *o = option_of(t, i, t->path[i], t->path[i + 1]);
    double *p = bat_correction_point(w, 3 * i);
    if (o->legs.start == s.legs.start && o->legs.end == s.legs.end)
        return;
    for (int k = 0; k < 2; k++) {
        p[2 + k] = p[k] + o->legs.start * s.t0[k];
        p[4 + k] = p[6 + k] - o->legs.end * s.t1[k];
    }
    if (!w->changed[i])
        w->changed[i] = 2;
}

static batten_status make_room(joining *t)
{
    const size_t n = (size_t)t->w->count;
    t->joins = bat_array(n + 1, sizeof *t->joins);
    t->first = bat_array(n + 1, sizeof *t->first);
    t->best = bat_array(n + 1, CHOICES * sizeof *t->best);
    t->from = bat_array(n + 1, CHOICES);
    t->path = bat_array(n + 1, 1);
    if (!t->joins || !t->first || !t->best || !t->from || !t->path)
        return BATTEN_OUT_OF_MEMORY;
    for (int j = 0; j <= t->w->count; j++)
        choose(t->w, j, &t->joins[j]);
    if (t->w->closed)
        t->joins[n] = t->joins[0];
    for (size_t i = 0; i < n; i++)
        t->first[i + 1] =
            t->first[i] + (size_t)((t->joins[i].count + 1) * (t->joins[i + 1].count + 1));
    t->options = bat_array(t->first[n], sizeof *t->options);
    return t->options ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

batten_status bat_correction_join(bat_correction *w)
{
    joining t = {.w = w};
    const batten_status status = make_room(&t);
    if (status == BATTEN_OK) {
        for (int i = 0; i < w->count; i++)
            fill_options(&t, i);
        find_best_path(&t);
        for (int i = 0; i < w->count; i++)
            set_legs(&t, i);
    }
    bat_release(t.options);
    bat_release(t.path);
    bat_release(t.from);
    bat_release(t.best);
    bat_release(t.first);
    bat_release(t.joins);
    return status;
}
