/* The path of least warp: which point of one edge each point of the other is joined to. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/plate/developable_parts.h"

#include <string.h>

enum { N = BAT_EDGE_STEPS, SIDE = N + 1, PASSES = 6, BRACKETS = 8, HALVINGS = 60 };

/* Among paths without warp the shortest; small beside the warp that matters. */
static const double length_cost = 1e-6;
/* The weight of the warp where a cone and the rest meet: a crease there, which is worse than
 * the same warp spread over the plate. */
static const double crease_cost = 2;

/* ---- the lattice ---- */

typedef struct {
    double warp; /* (1 - cos) / 2, 0 to 1 */
    double sine, cosine;
    double cost;  /* of the best way here */
    uint8_t from; /* the step that leads here */
} node;

static const struct {
    uint8_t x, y;
} steps[] = {{1, 1}, {1, 0}, {0, 1}, {1, 2}, {2, 1}, {1, 3}, {3, 1}, {2, 3}, {3, 2}};
enum { STEPS = sizeof steps / sizeof steps[0] };

/* Is another node on the other side of a root that is nearer to this one? */
static bool root_between(const node *a, const node *b)
{
    return a->cosine > 0 && b->cosine > 0 && a->sine * b->sine <= 0 &&
           fabs(a->sine) <= fabs(b->sine);
}

static batten_status fill_lattice(const bat_plate *plate, node *nodes)
{
    const double no_length = BAT_MEANT_SAME * plate->size;
    bat_edge_place *places = bat_array((size_t)2 * SIDE, sizeof *places);
    batten_status status = places ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < 2 * SIDE && status == BATTEN_OK; i++)
        status = bat_plate_edge_at(&plate->edge[i / SIDE], (double)(i % SIDE) / N, &places[i]);
    for (int k = 0; k < SIDE * SIDE && status == BATTEN_OK; k++) {
        const int i = k / SIDE, j = k % SIDE;
        const bool is_end = k == 0 || k == SIDE * SIDE - 1;
        node *n = &nodes[k];
        if (bat_warp_of(&places[i], &places[SIDE + j], no_length, &n->sine, &n->cosine))
            continue;
        const double gap = bat_vec3_norm(bat_vec3_subtract(places[SIDE + j].P, places[i].P));
        if (!is_end && gap <= no_length)
            status = bat_fail(BATTEN_NOT_COMPATIBLE,
                              "the edges touch at %g of the first and %g of the second",
                              places[i].u, places[SIDE + j].u);
        /* Edges may meet at their ends; elsewhere a line without planes is not a ruling. */
        n->sine = 0;
        n->cosine = is_end ? 1 : 0;
    }
    bat_release(places);
    return status;
}

/* Between nodes the warp has roots: the nearest nodes on both sides stand for them. */
static void find_warps(node *nodes)
{
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            node *n = &nodes[i * SIDE + j];
            const bool at_root =
                (i > 0 && root_between(n, n - SIDE)) || (i < N && root_between(n, n + SIDE)) ||
                (j > 0 && root_between(n, n - 1)) || (j < N && root_between(n, n + 1));
            n->warp = at_root ? 0 : (1 - n->cosine) / 2;
        }
}

/* From node (i, j) by a step; a step along a side is a piece of a cone and has no warp. */
static double step_cost(const node *nodes, int i, int j, int k)
{
    const int i1 = i + steps[k].x, j1 = j + steps[k].y;
    const double length = bat_hypot(steps[k].x, steps[k].y) / N;
    const bool before = (i == 0 && i1 == 0) || (j == 0 && j1 == 0);
    const bool behind = (i == N && i1 == N) || (j == N && j1 == N);
    const double w = nodes[i * SIDE + j].warp, w1 = nodes[i1 * SIDE + j1].warp;
    double cost = length_cost * length;
    if (!before && !behind)
        cost += (w + w1) / 2 * length;
    if (!before && (i == 0 || j == 0) && i + j > 0)
        cost += crease_cost * w;
    if (!behind && (i1 == N || j1 == N) && i1 + j1 < 2 * N)
        cost += crease_cost * w1;
    return cost;
}

/* From node (i, j) by step k, if that is the cheapest way to where it leads. */
static void try_step(node *nodes, int i, int j, int k)
{
    const int i1 = i + steps[k].x, j1 = j + steps[k].y;
    if (i1 > N || j1 > N)
        return;
    const double cost = nodes[i * SIDE + j].cost + step_cost(nodes, i, j, k);
    node *to = &nodes[i1 * SIDE + j1];
    if (cost < to->cost) {
        to->cost = cost;
        to->from = (uint8_t)k;
    }
}

static void find_costs(node *nodes)
{
    for (int k = 0; k < SIDE * SIDE; k++)
        nodes[k].cost = k == 0 ? 0 : HUGE_VAL;
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++)
            for (int k = 0; k < STEPS; k++)
                try_step(nodes, i, j, k);
}

static void reverse_pairs(bat_plate *plate)
{
    for (int a = 0, b = plate->count - 1; a < b; a++, b--) {
        const bat_pair kept = plate->pairs[a];
        plate->pairs[a] = plate->pairs[b];
        plate->pairs[b] = kept;
    }
}

/* The nodes of the best path, first to last; there is room for all. */
static void trace(const node *nodes, bat_plate *plate)
{
    int i = N, j = N, count = 0;
    for (; i > 0 || j > 0; count++) {
        plate->pairs[count] = (bat_pair){(double)i / N, (double)j / N};
        const int k = nodes[i * SIDE + j].from;
        i -= steps[k].x;
        j -= steps[k].y;
    }
    plate->pairs[count] = (bat_pair){0, 0};
    plate->count = count + 1;
    reverse_pairs(plate);
}

/* ---- roots beside the lattice ---- */

static bat_pair pair_on(const bat_pair_line *on, double by)
{
    return (bat_pair){bat_min(1, bat_max(0, on->from.x + by * on->along.x)),
                      bat_min(1, bat_max(0, on->from.y + by * on->along.y))};
}

static batten_status signed_warp(const bat_plate *plate, const bat_pair_line *on, double by,
                                 bool *has, double *sine)
{
    double cosine = -1;
    const bat_pair at = pair_on(on, by);
    const batten_status status = bat_plate_warp(plate, at, has, sine, &cosine);
    *has = *has && cosine > 0;
    return status;
}

/* Between two places, where the sines have different signs; that at the first is given. */
static batten_status halve_step(const bat_plate *plate, const bat_pair_line *on,
                                batten_interval between, double sine_a, double *root)
{
    double a = between.a, b = between.b;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < HALVINGS && status == BATTEN_OK; k++) {
        const double middle = (a + b) / 2;
        bool has;
        double sine = 0;
        status = signed_warp(plate, on, middle, &has, &sine);
        if (sine * sine_a > 0)
            a = middle;
        else
            b = middle;
    }
    *root = (a + b) / 2;
    return status;
}

batten_status bat_plate_root(const bat_plate *plate, const bat_pair_line *on,
                             batten_interval reach, bool *found, bat_pair *out)
{
    double at[BRACKETS + 1], sine[BRACKETS + 1], best = HUGE_VAL, largest = 0;
    bool has[BRACKETS + 1];
    batten_status status = BATTEN_OK;
    *found = false;
    for (int k = 0; k <= BRACKETS && status == BATTEN_OK; k++) {
        at[k] = reach.a + (reach.b - reach.a) * k / BRACKETS;
        sine[k] = 0;
        status = signed_warp(plate, on, at[k], &has[k], &sine[k]);
        largest = bat_max(largest, fabs(sine[k]));
    }
    /* All directions do: a plane, or the rulings of a plane part. */
    if (status != BATTEN_OK || largest < BAT_MEANT_SAME)
        return status;
    for (int k = 0; k < BRACKETS && status == BATTEN_OK; k++) {
        if (!has[k] || !has[k + 1] || sine[k] * sine[k + 1] > 0)
            continue;
        double root = 0;
        status = halve_step(plate, on, (batten_interval){at[k], at[k + 1]}, sine[k], &root);
        if (status == BATTEN_OK && fabs(root) < fabs(best)) {
            best = root;
            *found = true;
        }
    }
    if (*found)
        *out = pair_on(on, best);
    return status;
}

/* ---- where cones end ---- */

static bool same_pair(bat_pair a, bat_pair b)
{
    return a.x == b.x && a.y == b.y;
}

/* The pair between the cone and the rest: on a side through `corner` (0, 0) or (1, 1), near the
 * last node of the path there, which is the corner itself when there is no cone. */
static batten_status find_departure(const bat_plate *plate, bat_pair corner,
                                    bat_pair node_there, bat_pair *out)
{
    const double inward = corner.x == 0 ? 1 : -1, reach = 3.0 / N;
    double nearest = HUGE_VAL;
    *out = node_there;
    for (int side = 0; side < 2; side++) {
        const bat_pair along = side ? (bat_pair){0, inward} : (bat_pair){inward, 0};
        const bool on_side = side ? node_there.x == corner.x : node_there.y == corner.y;
        const double off = fabs(node_there.x - corner.x) + fabs(node_there.y - corner.y);
        bool found = false;
        bat_pair root;
        batten_status status = BATTEN_OK;
        if (on_side)
            status =
                bat_plate_root(plate, &(bat_pair_line){node_there, along},
                               (batten_interval){-bat_min(reach, off), bat_min(reach, 1 - off)},
                               &found, &root);
        if (status != BATTEN_OK)
            return status;
        const double moved =
            found ? fabs(root.x - node_there.x) + fabs(root.y - node_there.y) : HUGE_VAL;
        if (found && moved < nearest) {
            nearest = moved;
            *out = root;
        }
    }
    /* A cone that is no more than rounding. */
    if (fabs(out->x - corner.x) + fabs(out->y - corner.y) < 1e-7)
        *out = corner;
    return BATTEN_OK;
}

/* Only what lies between the cones, from `first` to `last`; nodes next to these are left out
 * when they could stand before or behind them. */
static void keep_between(bat_plate *plate, bat_pair first, bat_pair last)
{
    const double near = 1.5 / N;
    int count = 1;
    for (int k = 0; k < plate->count; k++) {
        const bat_pair p = plate->pairs[k];
        if (p.x >= first.x && p.y >= first.y && p.x <= last.x && p.y <= last.y &&
            p.x - first.x + p.y - first.y > near && last.x - p.x + last.y - p.y > near)
            plate->pairs[count++] = p;
    }
    plate->pairs[0] = first;
    if (!same_pair(first, last))
        plate->pairs[count++] = last;
    plate->count = count;
}

static batten_status cut_cones(bat_plate *plate)
{
    const bat_pair start = {0, 0}, end = {1, 1};
    int a = 0, b = plate->count - 1;
    while (a + 1 < plate->count && (plate->pairs[a + 1].x == 0 || plate->pairs[a + 1].y == 0))
        a++;
    while (b > a && (plate->pairs[b - 1].x == 1 || plate->pairs[b - 1].y == 1))
        b--;
    bat_pair first, last;
    batten_status status = find_departure(plate, start, plate->pairs[a], &first);
    if (status == BATTEN_OK)
        status = find_departure(plate, end, plate->pairs[b], &last);
    if (status == BATTEN_OK && a == b)
        last = first = plate->pairs[a];
    if (status == BATTEN_OK)
        keep_between(plate, first, last);
    return status;
}

/* Steps of the lattice become a smooth path. */
void bat_plate_smooth(bat_plate *plate, int passes)
{
    for (int pass = 0; pass < passes; pass++) {
        bat_pair before = plate->pairs[0];
        for (int k = 1; k + 1 < plate->count; k++) {
            bat_pair *p = &plate->pairs[k];
            const bat_pair here = *p, next = p[1];
            p->x = (before.x + 2 * here.x + next.x) / 4;
            p->y = (before.y + 2 * here.y + next.y) / 4;
            before = here;
        }
    }
}

batten_status bat_plate_find_path(bat_plate *plate)
{
    node *nodes = bat_array((size_t)SIDE * SIDE, sizeof *nodes);
    plate->pairs = bat_array((size_t)2 * SIDE + 2, sizeof *plate->pairs);
    batten_status status = nodes && plate->pairs ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = fill_lattice(plate, nodes);
    if (status == BATTEN_OK) {
        find_warps(nodes);
        find_costs(nodes);
        trace(nodes, plate);
        status = cut_cones(plate);
    }
    if (status == BATTEN_OK)
        bat_plate_smooth(plate, PASSES);
    bat_release(nodes);
    return status;
}
